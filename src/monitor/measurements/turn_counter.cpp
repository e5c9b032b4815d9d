#include "tether_monitor/monitor/measurements/turn_counter.h"

#include <cmath>
#include <limits>

namespace tether_monitor::monitor
{
namespace
{
constexpr double UPRIGHT = 0.17;  // horizontal part of a forward axis that has no heading [-]: within 10 degrees

std::optional<double> headingOf(const Eigen::Quaterniond& attitude)
{
  const Eigen::Vector3d forward = attitude * Eigen::Vector3d::UnitX();
  if (!(std::hypot(forward.x(), forward.y()) > UPRIGHT))
    return std::nullopt;
  return std::atan2(forward.y(), forward.x());
}
}  // namespace

void TurnCounter::update(const Eigen::Quaterniond& vessel, const Eigen::Quaterniond& vehicle)
{
  const std::optional<double> of_vessel = headingOf(vessel), of_vehicle = headingOf(vehicle);
  if (!of_vessel || !of_vehicle)
    return;
  const double heading = *of_vehicle - *of_vessel;
  if (heading_)
    turns_ += std::remainder(heading - *heading_, 2.0 * M_PI) / (2.0 * M_PI);
  heading_ = heading;
  is_known_ = true;
}

bool TurnCounter::set(double turns)
{
  if (!std::isfinite(turns))
    return false;
  turns_ = turns;
  is_known_ = true;
  return true;
}

double TurnCounter::turns() const
{
  return is_known_ ? turns_ : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace tether_monitor::monitor
