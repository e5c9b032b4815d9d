#include "tether_monitor/core/cable/winch_drum.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
WinchDrum::WinchDrum(const WinchProperties& drum, double tether_diameter)
  : core_diameter_(drum.core_diameter),
    diameter_(tether_diameter),
    turns_per_layer_(std::floor(drum.width / tether_diameter + 1e-9)),
    layers_(drum.layers)
{
  throwIfInvalid("winch", validate(drum, tether_diameter, 0.0, 0.0));
  turns_ = turns_per_layer_ * layers_;
  capacity_ = wound(turns_);
}

double WinchDrum::wound(double turns_on) const
{
  // Full layers: the mean diameter of k layers is core + k d.
  const double full = std::floor(turns_on / turns_per_layer_);
  const double rest = turns_on - full * turns_per_layer_;
  return M_PI * (full * turns_per_layer_ * (core_diameter_ + full * diameter_) +
                 rest * (core_diameter_ + (2.0 * full + 1.0) * diameter_));
}

double WinchDrum::paidOut(double turns_out) const
{
  return capacity_ - wound(std::clamp(turns_ - turns_out, 0.0, turns_));
}

double WinchDrum::turnsFor(double length) const
{
  double left = std::clamp(capacity_ - length, 0.0, capacity_);  // stays on the drum
  double turns_on = 0.0;
  for (int layer = 0; layer < layers_; ++layer)
  {
    const double per_turn = M_PI * (core_diameter_ + (2.0 * layer + 1.0) * diameter_);
    const double turns = std::min(left / per_turn, turns_per_layer_);
    turns_on += turns;
    left -= turns * per_turn;
  }
  return turns_ - turns_on;
}

double WinchDrum::lengthPerTurn(double turns_out) const
{
  const double on = std::clamp(turns_ - turns_out, 0.0, turns_);
  const double layer = std::min(std::ceil(on / turns_per_layer_ - 1e-12) - 1.0, layers_ - 1.0);
  return M_PI * (core_diameter_ + (2.0 * std::max(layer, 0.0) + 1.0) * diameter_);
}

std::vector<std::string> validate(const WinchProperties& drum, double tether_diameter, double length,
                                  double min_bend_radius)
{
  BoundsCheck check("winch.");
  check.positive("core_diameter", drum.core_diameter, "m");
  check.check(drum.width >= tether_diameter && std::isfinite(drum.width), "width", drum.width,
              ">= tether.diameter, in m");
  check.within("layers", drum.layers, 1, 1000, "[-]");
  check.check(!(0.5 * (drum.core_diameter + tether_diameter) < min_bend_radius), "core_diameter",
              drum.core_diameter, "enough for tether.min_bend_radius = " + formatNumber(min_bend_radius) + " m");
  std::vector<std::string> found = check.problems();
  if (!found.empty() || !(tether_diameter > 0.0))
    return found;
  const double capacity = length > 0.0 ? WinchDrum(drum, tether_diameter).capacity() : 0.0;
  if (length > capacity)
    found.push_back("tether.length = " + formatNumber(length) + " (must be at most what the winch holds, " +
                    formatNumber(std::floor(100.0 * capacity) / 100.0) + " m)");
  return found;
}

}  // namespace tether_monitor::core
