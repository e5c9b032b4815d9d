#include "tether_monitor/monitor/ensemble/reading_statistics.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double LEAST_INTERVAL = 1e-3;       // [s]
constexpr double TENSION_SPREAD_TIME = 30.0;  // [s]
}  // namespace

void ReadingRate::note(double t)
{
  if (!(t > last_))
    return;
  interval_ = t - last_;
  last_ = t;
}

double ReadingRate::repeatsIn(double memory) const
{
  return memory / std::clamp(interval_, LEAST_INTERVAL, memory);
}

void TensionSpread::add(double tension, double dt)
{
  if (std::isnan(mean))
    mean = tension;
  const double share = 1.0 - std::exp(-dt / TENSION_SPREAD_TIME);
  variance += share * (std::pow(tension - mean, 2) - variance);
  mean += share * (tension - mean);
}

}  // namespace tether_monitor::monitor
