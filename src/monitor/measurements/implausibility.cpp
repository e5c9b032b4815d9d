#include "tether_monitor/monitor/measurements/implausibility.h"

namespace tether_monitor::monitor
{
const char* describe(Implausibility what)
{
  switch (what)
  {
    case Implausibility::LEAP:
      return "its position leapt farther than it can have gone: look at its positioning, and whether another body "
             "is "
             "published on its topic";
    case Implausibility::RELOCATION:
      return "its positions leapt and went on elsewhere: one of the two places is wrong; the tether has settled "
             "anew";
    case Implausibility::FROZEN_POSITION:
      return "its position repeats to the last digit although it was moving: the sensor or its driver has stopped";
    case Implausibility::CONTRADICTORY_VELOCITY:
      return "its velocity is not that with which its position changes: look at both sensors and their clocks";
    case Implausibility::VELOCITY_IN_WORLD_AXES:
      return "its velocity fits its positions only in the axes of the world: set its twist_frame to world";
    case Implausibility::VELOCITY_IN_BODY_AXES:
      return "its velocity fits its positions only in the axes of the body: set its twist_frame to child";
    case Implausibility::TWO_SOURCES:
      return "more than one node publishes on its topic: stop all but one";
    case Implausibility::VEHICLE_ABOVE_WATER:
      return "the vehicle is above the water: look at the sign of its depth (z is up, 0 at the surface) and at "
             "world_frame";
    case Implausibility::VESSEL_UNDER_WATER:
      return "the vessel's end is deep under water: look at the sign of z (z is up, 0 at the surface) and at "
             "world_frame";
    case Implausibility::LENGTH_LEAP:
      return "the deployed length leapt farther than a winch can turn: look at its counter";
    case Implausibility::OTHER_LENGTH:
      return "the deployed length leapt and went on from there: one of the two is wrong; the tether has settled "
             "anew";
    case Implausibility::FROZEN_LENGTH:
      return "the deployed length stays while a rate is reported: its counter has stopped, or the rate is wrong";
    case Implausibility::CONTRADICTORY_RATE:
      return "the rate of pay-out is not that with which the length changes (> 0 pays out): it is not used";
    case Implausibility::IMPROBABLE_FORCE:
      return "only a force on it far beyond vehicle.force_stddev explains where it is: look at the sign of its "
             "height "
             "(z is up), at its mass and volume, and at world_frame";
    case Implausibility::IMPROBABLE_LENGTH:
      return "only a length far from the deployed one explains the measurements: look at tether.length, the "
             "winch's "
             "counter, and the places of the tether's ends on vessel and vehicle";
    case Implausibility::IMPROBABLE_DRAG:
      return "only a drag far from the configured one explains the measurements: look at tether.drag_normal and "
             "drag_tangential (both on the diameter), and at fouling";
    case Implausibility::IMPROBABLE_MASS:
      return "only a mass far from the configured one explains the measurements: look at tether.mass_per_length "
             "(dry) "
             "and its diameter";
    case Implausibility::IMPROBABLE_STIFFNESS:
      return "only a stiffness far from the configured one explains the measurements: look at "
             "tether.axial_stiffness";
    case Implausibility::IMPROBABLE_CURRENT:
      return "only a current far from the one told explains the measurements: look at environment.current, its "
             "axes "
             "(x east, y north) and at environment.current_stddev";
    case Implausibility::IMPROBABLE_VEHICLE_DRAG:
      return "only a drag far from the configured one explains its motion: look at vehicle.drag_area";
    case Implausibility::IMPROBABLE_TENSION:
      return "the load cell is off by far more than tension_sensor.bias_stddev: look at its zero and its unit";
    case Implausibility::IMPROBABLE_DIRECTION:
      return "the measured direction of the tether is off by far more than direction_sensor.stddev: look at its "
             "frame";
    case Implausibility::COUNT:
      break;
  }
  return "";
}

const char* describe(Subject subject)
{
  switch (subject)
  {
    case Subject::VESSEL:
      return "vessel";
    case Subject::VEHICLE:
      return "vehicle";
    case Subject::WINCH:
      return "winch";
    case Subject::TETHER:
      return "tether";
    case Subject::WATER:
      return "water";
    case Subject::SENSOR:
      return "sensor at the vessel end";
    case Subject::COUNT:
      break;
  }
  return "";
}

}  // namespace tether_monitor::monitor
