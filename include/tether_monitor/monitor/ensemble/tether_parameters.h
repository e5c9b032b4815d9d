#pragma once

#include <vector>

#include "tether_monitor/core/cable/property_variation.h"
#include "tether_monitor/monitor/config/config.h"

namespace tether_monitor::monitor
{
/// What a member of the ensemble has of its own. All are deviations from what is configured.
enum Parameter
{
  DRAG_NORMAL,          ///< logarithm of a factor [-].
  DRAG_TANGENTIAL,      ///< likewise.
  MASS_PER_LENGTH,      ///< relative [-].
  LENGTH,               ///< relative [-].
  AXIAL_STIFFNESS,      ///< logarithm of a factor [-].
  CURRENT_X,            ///< at the surface [m/s].
  CURRENT_Y,            ///< likewise.
  SHEAR_X,              ///< current at the depth to which the shear reaches, less that at the surface [m/s].
  SHEAR_Y,              ///< likewise.
  VEHICLE_DRAG,         ///< logarithm of a factor [-].
  TENSION_BIAS,         ///< of the load cell [N].
  DIRECTION_AZIMUTH,    ///< bias of the measured direction across the vertical plane of the tether [rad].
  DIRECTION_ELEVATION,  ///< bias in that plane, up [rad].
  PARAMETERS
};

using ParameterVector = Eigen::Matrix<double, PARAMETERS, 1>;
/// A column for each member.
using ParameterMatrix = Eigen::Matrix<double, PARAMETERS, Eigen::Dynamic>;

/// What is known of the parameters beforehand: their mean is zero.
struct ParameterPrior
{
  ParameterVector stddev;  ///< >= 0.
  ParameterVector memory;  ///< time in which a parameter forgets what it was [s].
};

ParameterPrior parameterPrior(const Config& config);

/// Those whose prior differs, and drags that are configured otherwise.
std::vector<Parameter> parametersToldAnew(const Config& before, const Config& now);

/// What a member differs by. @param shear_depth  to which the shear reaches [m], > 0.
core::PropertyVariation variationOf(const ParameterVector& parameters, double shear_depth);

/// Name of a parameter in messages and files: "tether.drag_normal".
const char* parameterName(Parameter parameter);

}  // namespace tether_monitor::monitor
