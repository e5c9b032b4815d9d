#include "tether_monitor/monitor/way_samples.h"

#include <array>
#include <cmath>

namespace tether_monitor::monitor
{
void WaySamples::add(const WaySample& sample)
{
  if (!empty() && sample.t < samples_.back().t + SPACING)
  {
    if (sample.t >= samples_.back().t && sample.stddev < samples_.back().stddev)
      samples_.back() = sample;
    return;
  }
  while (!empty() && samples_.front().t < sample.t - MEMORY)
    samples_.dropFront();
  samples_.extend() = sample;
}

double WaySamples::span(double t) const
{
  for (std::size_t i = 0; i < samples_.size(); ++i)
    if (samples_[i].t >= t - MEMORY)
      return samples_[samples_.size() - 1].t - samples_[i].t;
  return -1.0;
}

Way WaySamples::fit(double t, bool level, const WaveOdds& odds) const
{
  std::array<WaySample, MOST_WAY_SAMPLES> samples;
  for (std::size_t i = 0; i < samples_.size(); ++i)
    samples[i] = samples_[i];
  return fitWay(samples.data(), samples_.size(), t, level, odds);
}

bool WaySamples::isSound() const
{
  bool sound = samples_.isSound(MOST_WAY_SAMPLES);
  for (std::size_t i = 0; sound && i < samples_.size(); ++i)
    sound = std::isfinite(samples_[i].t) && std::isfinite(samples_[i].value) && samples_[i].stddev >= 0.0 &&
            (i == 0 || samples_[i].t >= samples_[i - 1].t);
  return sound;
}

}  // namespace tether_monitor::monitor
