#include "tether_monitor/monitor/measurements/height_record.h"

#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double LONGEST_INTERVAL = 1.0;  // [s] over which two heights make a rate
}

Rejection HeightRecord::check(double t, double height) const
{
  if (!std::isfinite(t) || !std::isfinite(height))
    return Rejection::NOT_FINITE;
  return t <= last_.t ? Rejection::OUT_OF_ORDER : Rejection::NONE;
}

Rejection HeightRecord::add(double t, double height)
{
  const Rejection rejection = check(t, height);
  if (rejection != Rejection::NONE)
    return rejection;
  before_ = last_;
  last_ = {t, height};
  return Rejection::NONE;
}

std::optional<double> HeightRecord::at(double t, double reach) const
{
  if (!(std::abs(t - last_.t) <= reach))
    return std::nullopt;
  const double interval = last_.t - before_.t;
  const double rate = interval <= LONGEST_INTERVAL ? (last_.height - before_.height) / interval : 0.0;
  return last_.height + rate * (t - last_.t);
}

bool HeightRecord::isValid() const
{
  const auto isSample = [](const Sample& s) { return !std::isnan(s.t) && std::isfinite(s.height); };
  return isSample(last_) && isSample(before_) && before_.t <= last_.t;
}

}  // namespace tether_monitor::monitor
