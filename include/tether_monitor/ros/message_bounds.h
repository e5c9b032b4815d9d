#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/core/base/types.h"
#include "tether_monitor/monitor/measurements/measured_vector.h"
#include "tether_monitor/monitor/measurements/rejection.h"

namespace tether_monitor
{
/// Why a message was refused, for a person.
using InputError = std::string;

/// What a number in a message is.
enum class Field
{
  POSITION,
  VELOCITY,
  ANGULAR_VELOCITY,
  FORCE,
  TORQUE,
  LENGTH,
  PAYOUT_RATE,
  DEPTH,
  WATER_VELOCITY,
  OBSTACLE_SIZE,
  MASS,
  FRICTION,
  OBSTACLES,
  PAST,
  FUTURE
};

/// How large it may be: beyond, no tether at sea can have meant it, and arithmetic would suffer.
struct FieldBound
{
  Field field;
  const char* name;
  double most;  ///< largest size.
  const char* unit;
};

/// The one table of bounds: every number that arrives is held against it.
const std::vector<FieldBound>& fieldBounds();
double mostOf(Field field);

/// Nothing for what was accepted.
std::optional<InputError> errorOf(monitor::Rejection rejection);

/// What is wrong with a number or vector: not finite, or beyond its bound; nothing if it is good.
std::optional<InputError> outOfBounds(Field field, double x);
std::optional<InputError> outOfBounds(Field field, const core::Vector3& v);
/// The same of the components that were measured.
std::optional<InputError> outOfBounds(Field field, const monitor::MeasuredVector& v);

}  // namespace tether_monitor
