#include "tether_monitor/monitor/ensemble/tether_parameters.h"

#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double CURRENT_MEMORY = 1200.0, SENSOR_MEMORY = 3600.0, BUILT_MEMORY = 36000.0;  // [s]
constexpr double SHEAR_SHARE = 0.5;  // of the current's standard deviation

// Standard deviation of the logarithm of a factor whose own is `relative`.
double ofLogarithm(double relative)
{
  return std::sqrt(std::log1p(relative * relative));
}
}  // namespace

ParameterPrior parameterPrior(const Config& config)
{
  const UncertaintyConfig& u = config.uncertainty;
  ParameterPrior prior;
  const auto set = [&](Parameter p, double stddev, double memory)
  {
    prior.stddev[p] = stddev;
    prior.memory[p] = memory;
  };
  set(DRAG_NORMAL, ofLogarithm(u.drag_normal), u.fouling_memory);
  set(DRAG_TANGENTIAL, ofLogarithm(u.drag_tangential), u.fouling_memory);
  set(MASS_PER_LENGTH, u.mass_per_length, BUILT_MEMORY);
  set(LENGTH, u.length, BUILT_MEMORY);
  set(AXIAL_STIFFNESS, ofLogarithm(u.axial_stiffness), BUILT_MEMORY);
  set(CURRENT_X, u.current, CURRENT_MEMORY);
  set(CURRENT_Y, u.current, CURRENT_MEMORY);
  set(SHEAR_X, SHEAR_SHARE * u.current, CURRENT_MEMORY);
  set(SHEAR_Y, SHEAR_SHARE * u.current, CURRENT_MEMORY);
  set(VEHICLE_DRAG, ofLogarithm(config.navigation.drag_stddev), u.fouling_memory);
  set(TENSION_BIAS, u.tension_bias * config.tether.working_load, SENSOR_MEMORY);
  set(DIRECTION_AZIMUTH, u.direction_stddev, SENSOR_MEMORY);
  set(DIRECTION_ELEVATION, u.direction_stddev, SENSOR_MEMORY);
  return prior;
}

std::vector<Parameter> parametersToldAnew(const Config& before, const Config& now)
{
  const ParameterPrior old = parameterPrior(before), prior = parameterPrior(now);
  const auto isOtherDrag = [&](int k)
  {
    return (k == DRAG_NORMAL && now.tether.drag_normal != before.tether.drag_normal) ||
           (k == DRAG_TANGENTIAL && now.tether.drag_tangential != before.tether.drag_tangential);
  };
  std::vector<Parameter> told;
  for (int k = 0; k < PARAMETERS; ++k)
    if (isOtherDrag(k) || prior.stddev[k] != old.stddev[k])
      told.push_back(static_cast<Parameter>(k));
  return told;
}

core::PropertyVariation variationOf(const ParameterVector& p, double shear_depth)
{
  core::PropertyVariation v;
  v.drag_normal = std::exp(p[DRAG_NORMAL]);
  v.drag_tangential = std::exp(p[DRAG_TANGENTIAL]);
  v.mass_per_length = 1.0 + p[MASS_PER_LENGTH];
  v.length = 1.0 + p[LENGTH];
  v.axial_stiffness = std::exp(p[AXIAL_STIFFNESS]);
  v.vehicle_drag = std::exp(p[VEHICLE_DRAG]);
  v.current = {p[CURRENT_X], p[CURRENT_Y], 0.0};
  v.shear = core::Vector3(p[SHEAR_X], p[SHEAR_Y], 0.0) / shear_depth;
  v.shear_depth = shear_depth;
  return v;
}

const char* parameterName(Parameter parameter)
{
  switch (parameter)
  {
    case DRAG_NORMAL:
      return "tether.drag_normal";
    case DRAG_TANGENTIAL:
      return "tether.drag_tangential";
    case MASS_PER_LENGTH:
      return "tether.mass_per_length";
    case LENGTH:
      return "tether.length";
    case AXIAL_STIFFNESS:
      return "tether.axial_stiffness";
    case CURRENT_X:
      return "environment.current.x";
    case CURRENT_Y:
      return "environment.current.y";
    case SHEAR_X:
      return "environment.current_shear.x";
    case SHEAR_Y:
      return "environment.current_shear.y";
    case VEHICLE_DRAG:
      return "vehicle.drag";
    case TENSION_BIAS:
      return "tension.bias";
    case DIRECTION_AZIMUTH:
      return "direction.azimuth_bias";
    case DIRECTION_ELEVATION:
      return "direction.elevation_bias";
    case PARAMETERS:
      break;
  }
  return "";
}

}  // namespace tether_monitor::monitor
