#include "tether_monitor/monitor/forecast/vessel_plan.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double FASTEST = 50.0;       // [m/s]
constexpr double STOPPING_TIME = 2.0;  // in which a winch comes to its length [s]

core::Vector3 velocityBetween(const VesselPlan::Point& a, const VesselPlan::Point& b)
{
  core::Vector3 velocity = (b.position - a.position) / (b.t - a.t);
  velocity.z() = 0.0;
  return velocity;
}

std::string problemOf(const std::vector<VesselPlan::Point>& points)
{
  if (points.size() == 1)
    return "a plan has at least two poses";
  if (points.size() > VesselPlan::MOST_POINTS)
    return "a plan has at most " + std::to_string(VesselPlan::MOST_POINTS) + " poses";
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!std::isfinite(points[i].t) || !points[i].position.allFinite())
      return "pose " + std::to_string(i) + " is not finite";
    if (i > 0 && !(points[i].t > points[i - 1].t))
      return "the stamp of pose " + std::to_string(i) + " is not later than that before it";
    if (i > 0 && !(velocityBetween(points[i - 1], points[i]).norm() <= FASTEST))
      return "pose " + std::to_string(i) + " cannot be reached at 50 m/s";
  }
  return "";
}
}  // namespace

std::string VesselPlan::set(const std::vector<Point>& points)
{
  const std::string problem = problemOf(points);
  if (problem.empty())
    points_ = points;
  return problem;
}

std::optional<core::Vector3> VesselPlan::velocity(double t) const
{
  if (points_.empty() || t < points_.front().t || t > points_.back().t)
    return std::nullopt;
  const auto next = std::upper_bound(points_.begin() + 1, points_.end() - 1, t,
                                     [](double time, const Point& point) { return time < point.t; });
  return velocityBetween(*(next - 1), *next);
}

bool VesselPlan::isValid() const
{
  return problemOf(points_).empty();
}

double PayoutPlan::rateAt(double now, double deployed, double present) const
{
  if (now < t)
    return present;
  if (std::isnan(length))
    return rate;
  const double missing = length - deployed;
  return std::copysign(std::min(std::abs(rate), std::abs(missing) / STOPPING_TIME), missing);
}

}  // namespace tether_monitor::monitor
