#include "tether_monitor/ros/message_bounds.h"

#include <cmath>
#include <cstdio>

namespace tether_monitor
{
namespace
{
const FieldBound& boundOf(Field field)
{
  return fieldBounds()[static_cast<std::size_t>(field)];
}
}  // namespace

const std::vector<FieldBound>& fieldBounds()
{
  static const std::vector<FieldBound> bounds{
      {Field::POSITION, "position", 2e7, "m"},
      {Field::VELOCITY, "velocity", 50.0, "m/s"},
      {Field::ANGULAR_VELOCITY, "angular velocity", 100.0, "rad/s"},
      {Field::FORCE, "force", 1e8, "N"},
      {Field::TORQUE, "torque", 1e9, "N m"},
      {Field::LENGTH, "length", 1e5, "m"},
      {Field::PAYOUT_RATE, "rate of pay-out", 50.0, "m/s"},
      {Field::DEPTH, "depth", 12000.0, "m"},
      {Field::WATER_VELOCITY, "velocity of the water", 20.0, "m/s"},
      {Field::OBSTACLE_SIZE, "size of an obstacle", 1e5, "m"},
      {Field::MASS, "mass of an obstacle", 1e9, "kg"},
      {Field::FRICTION, "friction", 10.0, "[-]"},
      {Field::OBSTACLES, "number of obstacles", 200.0, "[-]"},
      {Field::PAST, "age of a stamp", 86400.0, "s"},
      {Field::FUTURE, "time of a stamp ahead of the clock", 1.0, "s"},
  };
  return bounds;
}

double mostOf(Field field)
{
  return boundOf(field).most;
}

std::optional<InputError> errorOf(monitor::Rejection rejection)
{
  return rejection == monitor::Rejection::NONE ? std::nullopt
                                               : std::optional<InputError>(monitor::describe(rejection));
}

std::optional<InputError> outOfBounds(Field field, double x)
{
  const FieldBound& bound = boundOf(field);
  if (!std::isfinite(x))
    return std::string(bound.name) + " is not finite";
  if (std::abs(x) <= bound.most)
    return std::nullopt;
  char text[160];
  std::snprintf(text, sizeof(text), "%s = %.6g %s is beyond what can be (%g)", bound.name, x, bound.unit,
                bound.most);
  return text;
}

std::optional<InputError> outOfBounds(Field field, const core::Vector3& v)
{
  for (int i = 0; i < 3; ++i)
    if (std::optional<InputError> error = outOfBounds(field, v[i]))
      return error;
  return std::nullopt;
}

std::optional<InputError> outOfBounds(Field field, const monitor::MeasuredVector& v)
{
  for (int i = 0; i < 3; ++i)
    if (v.isMeasured(i))
      if (std::optional<InputError> error = outOfBounds(field, v.value()[i]))
        return error;
  return std::nullopt;
}

}  // namespace tether_monitor
