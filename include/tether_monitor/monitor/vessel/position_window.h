#pragma once

#include "tether_monitor/monitor/measurements/ring_buffer.h"
#include "tether_monitor/monitor/vessel/track_wave_regression.h"

namespace tether_monitor::monitor
{
/// The positions of one coordinate over the last 20 s, thinned out to what fitTrackAndWave() needs: however fast
/// they come. Allocates only in the constructor.
class PositionWindow
{
 public:
  static constexpr double MEMORY = 20.0;                         ///< [s]
  static constexpr double SPACING = MEMORY / MAX_TRACK_SAMPLES;  ///< least time between two that are kept [s].

  PositionWindow() : samples_(MAX_TRACK_SAMPLES) {}

  /// Accepts a sample, if it is later than the last by SPACING, or else better.
  void add(const TrackSample& sample);
  void clear() { samples_.clear(); }
  bool empty() const { return samples_.empty(); }
  /// Time that the samples span that are no older than MEMORY at time t [s]; negative if there are none.
  double span(double t) const;
  /// See fitTrackAndWave(); not empty.
  TrackFit fit(double t, bool level, const WaveProbabilities& probabilities) const;
  bool isValid() const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(samples_);
  }

 private:
  RingBuffer<TrackSample> samples_;
};

}  // namespace tether_monitor::monitor
