#include "tether_monitor/monitor/estimator/snag_locator.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double SHAPE_ERROR = 0.3;   // relative error of a tension that a shallow catenary leaves
constexpr double PLACE_ERROR = 0.15;  // relative error of a place, beside: deeper sag, other velocities
constexpr double LEAST_CHORD = 0.5;   // of a piece over its length: less is no shallow catenary
}  // namespace

SnagLocator::SnagLocator(const Config& config)
  : stiffness_(config.tether.axial_stiffness),
    weight_(std::abs(config.tether.mass_per_length -
                     config.environment.water_density * config.tether.displacedArea()) *
            config.environment.gravity),
    drag_(0.5 * config.environment.water_density * config.tether.drag_normal * config.tether.diameter)
{
}

void SnagLocator::remember(const TetherEstimate& e)
{
  s_.assign(e.stations.s.begin(), e.stations.s.end());
  position_.assign(e.stations.position.begin(), e.stations.position.end());
}

SnagPlace SnagLocator::find(const core::Vector3& vessel_end, const core::Vector3& velocity, double tension,
                            double stddev) const
{
  SnagPlace place;
  if (s_.empty() || !(tension > 0.0))
    return place;
  const double drag = drag_ * velocity.squaredNorm() / 3.0;  // the speed falls to none at the place
  const auto excess = [&](std::size_t k, double pull)
  {
    const core::Vector3 chord = position_[k] - vessel_end;
    const double d = chord.norm(), level = std::hypot(chord.x(), chord.y()) / std::max(d, 1e-9);
    if (d < LEAST_CHORD * s_[k])
      return -1.0;
    const double sag = std::hypot(weight_ * level, drag) * s_[k] / pull;
    return d / s_[k] - 1.0 - pull / stiffness_ + sag * sag / 24.0;
  };
  const double spread = std::hypot(2.0 * stddev, SHAPE_ERROR * tension);
  const double low = std::max(tension - spread, 0.3 * tension), high = tension + spread;
  double nearest_miss = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < s_.size(); ++k)
  {
    const double miss = std::abs(excess(k, tension));
    if (miss < nearest_miss)
    {
      nearest_miss = miss;
      place.s = s_[k];
    }
    const bool fits = excess(k, low) >= 0.0 && excess(k, high) <= 0.0;
    if (!fits)
      continue;
    if (std::isnan(place.nearest))
      place.nearest = s_[k];
    place.farthest = s_[k];
  }
  if (std::isnan(place.nearest))
    place.nearest = place.farthest = place.s;
  place.nearest = (1.0 - PLACE_ERROR) * place.nearest;
  place.farthest = std::min((1.0 + PLACE_ERROR) * place.farthest, s_.back());
  return place;
}

}  // namespace tether_monitor::monitor
