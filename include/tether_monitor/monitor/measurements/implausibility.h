#pragma once

namespace tether_monitor::monitor
{
/// What makes an input unbelievable although each of its messages is in order.
enum class Implausibility
{
  LEAP,             ///< a position that no body gets to in the time.
  RELOCATION,       ///< after a leap the positions went on elsewhere: one of the two places is wrong.
  FROZEN_POSITION,  ///< a position that repeats to the last digit after it moved, or while a velocity is measured.
  CONTRADICTORY_VELOCITY,  ///< the velocity is not that with which the positions change.
  VELOCITY_IN_WORLD_AXES,  ///< likewise, but it is when its axes are taken for those of the world.
  VELOCITY_IN_BODY_AXES,   ///< likewise, but it is when its axes are taken for those of the body.
  TWO_SOURCES,             ///< several publishers on one topic.
  VEHICLE_ABOVE_WATER,
  VESSEL_UNDER_WATER,
  LENGTH_LEAP,         ///< a deployed length that no winch gets to in the time.
  OTHER_LENGTH,        ///< after a leap the lengths went on from there.
  FROZEN_LENGTH,       ///< a length that repeats while a rate is reported.
  CONTRADICTORY_RATE,  ///< the rate is not that with which the length changes.
  IMPROBABLE_FORCE,    ///< only a force far beyond vehicle.force_stddev explains where the vehicle is.
  IMPROBABLE_LENGTH,   ///< only a length far off the deployed one explains the measurements; likewise below.
  IMPROBABLE_DRAG,
  IMPROBABLE_MASS,
  IMPROBABLE_STIFFNESS,
  IMPROBABLE_CURRENT,
  IMPROBABLE_VEHICLE_DRAG,
  IMPROBABLE_TENSION,    ///< of the load cell.
  IMPROBABLE_DIRECTION,  ///< of the direction at the vessel end.
  COUNT
};

/// Which input a finding is about.
enum class Subject
{
  VESSEL,
  VEHICLE,
  WINCH,
  TETHER,
  WATER,
  SENSOR,  ///< at the vessel end: load cell, direction.
  COUNT
};

/// What was found, and what to look at, in a sentence.
const char* describe(Implausibility what);
const char* describe(Subject subject);

}  // namespace tether_monitor::monitor
