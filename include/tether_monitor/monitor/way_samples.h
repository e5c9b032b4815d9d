#pragma once

#include "tether_monitor/monitor/ring.h"
#include "tether_monitor/monitor/way_fit.h"

namespace tether_monitor::monitor
{
/// The positions of one coordinate over the last 20 s, thinned out to what fitWay() needs: however fast they come.
/// Allocates only in the constructor.
class WaySamples
{
 public:
  static constexpr double MEMORY = 20.0;                        ///< [s]
  static constexpr double SPACING = MEMORY / MOST_WAY_SAMPLES;  ///< least time between two that are kept [s].

  WaySamples() : samples_(MOST_WAY_SAMPLES) {}

  /// Takes a sample, if it is later than the last by SPACING, or else better.
  void add(const WaySample& sample);
  void clear() { samples_.clear(); }
  bool empty() const { return samples_.empty(); }
  /// Time that the samples span that are no older than MEMORY at time t [s]; negative if there are none.
  double span(double t) const;
  /// See fitWay(); not empty.
  Way fit(double t, bool level, const WaveOdds& odds) const;
  bool isSound() const;

  template <class Archive>
  void archive(Archive& a)
  {
    a(samples_);
  }

 private:
  Ring<WaySample> samples_;
};

}  // namespace tether_monitor::monitor
