#include "tether_monitor/monitor/ensemble/parameter_report.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
struct Moments
{
  double mean = 0.0, stddev = 0.0;
};

Moments momentsOf(const Eigen::RowVectorXd& x)
{
  return {x.mean(), std::sqrt(varianceOf(x))};
}
}  // namespace

const ParameterEstimate* findParameter(const std::vector<ParameterEstimate>& parameters, const std::string& name)
{
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const ParameterEstimate& p) { return p.name == name; });
  return found == parameters.end() ? nullptr : &*found;
}

std::vector<ParameterEstimate> parameterReport(const TetherEnsemble& ensemble, const Config& config, double length,
                                               const core::Vector3& current)
{
  const ParameterMatrix& parameters = ensemble.filter().parameters();
  const UncertaintyConfig& told = config.uncertainty;
  std::vector<ParameterEstimate> report;
  const auto add = [&](const std::string& name, const Eigen::RowVectorXd& values, double configured, double stddev)
  {
    const Moments m = momentsOf(values);
    report.push_back({name, m.mean, m.stddev, configured, stddev});
  };
  const auto addFactor = [&](Parameter p, double configured, double relative)
  {
    add(parameterName(p), configured * parameters.row(p).array().exp().matrix(), configured,
        relative * configured);
  };
  const auto addRelative = [&](Parameter p, double configured, double relative)
  {
    add(parameterName(p), configured * (1.0 + parameters.row(p).array()).matrix(), configured,
        relative * configured);
  };
  const auto addOffset = [&](Parameter p, double configured, double stddev)
  { add(parameterName(p), (configured + parameters.row(p).array()).matrix(), configured, stddev); };
  addFactor(DRAG_NORMAL, config.tether.drag_normal, told.drag_normal);
  addFactor(DRAG_TANGENTIAL, config.tether.drag_tangential, told.drag_tangential);
  addRelative(MASS_PER_LENGTH, config.tether.mass_per_length, told.mass_per_length);
  addRelative(LENGTH, length, told.length);
  addOffset(CURRENT_X, current.x(), told.current);
  addOffset(CURRENT_Y, current.y(), told.current);
  addFactor(VEHICLE_DRAG, 1.0, config.navigation.drag_stddev);
  const MotionErrorFilter& error = ensemble.filter().motionError();
  const char* const axes[] = {"vehicle.force.x", "vehicle.force.y", "vehicle.force.z"};
  for (int axis = 0; axis < 3; ++axis)
  {
    const int row = MotionErrorFilter::SLOW + axis;
    const Moments m = momentsOf(error.means().row(row));
    report.push_back({axes[axis], m.mean, std::sqrt(m.stddev * m.stddev + error.covariance()(row, row)),
                      config.vehicle_body.force[axis], error.force().slow_stddev});
    report.back().mean += config.vehicle_body.force[axis];
  }
  addOffset(TENSION_BIAS, 0.0, told.tension_bias * config.tether.working_load);
  return report;
}

}  // namespace tether_monitor::monitor
