#include "tether_monitor/monitor/vessel/position_window.h"

#include <array>
#include <cmath>

namespace tether_monitor::monitor
{
void PositionWindow::add(const TrackSample& sample)
{
  if (!empty() && sample.t < samples_.back().t + SPACING)
  {
    if (sample.t >= samples_.back().t && sample.stddev < samples_.back().stddev)
      samples_.back() = sample;
    return;
  }
  while (!empty() && samples_.front().t < sample.t - MEMORY)
    samples_.popFront();
  samples_.emplaceBack() = sample;
}

double PositionWindow::span(double t) const
{
  for (std::size_t i = 0; i < samples_.size(); ++i)
    if (samples_[i].t >= t - MEMORY)
      return samples_[samples_.size() - 1].t - samples_[i].t;
  return -1.0;
}

TrackFit PositionWindow::fit(double t, bool level, const WaveProbabilities& probabilities) const
{
  std::array<TrackSample, MAX_TRACK_SAMPLES> samples;
  for (std::size_t i = 0; i < samples_.size(); ++i)
    samples[i] = samples_[i];
  return fitTrackAndWave(samples.data(), samples_.size(), t, level, probabilities);
}

bool PositionWindow::isValid() const
{
  bool sound = samples_.isValid(MAX_TRACK_SAMPLES);
  for (std::size_t i = 0; sound && i < samples_.size(); ++i)
    sound = std::isfinite(samples_[i].t) && std::isfinite(samples_[i].value) && samples_[i].stddev >= 0.0 &&
            (i == 0 || samples_[i].t >= samples_[i - 1].t);
  return sound;
}

}  // namespace tether_monitor::monitor
