#include "tether_monitor/monitor/ensemble/measurement_timing.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double MAX_LATENCY = 33.0;   // [s]
constexpr double MAX_INTERVAL = 10.0;  // [s]
constexpr double SMOOTHING = 0.2;      // weight of the newest
}  // namespace

void MeasurementTiming::add(double t, double now)
{
  if (!(t > newest_))
    return;
  if (!std::isnan(now))
    latency_ += SMOOTHING * (std::clamp(now - t, least_latency_, MAX_LATENCY) - latency_);
  if (std::isfinite(newest_))
    interval_ += (interval_ > 0.0 ? SMOOTHING : 1.0) * (std::min(t - newest_, MAX_INTERVAL) - interval_);
  newest_ = t;
}

}  // namespace tether_monitor::monitor
