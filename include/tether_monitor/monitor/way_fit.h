#pragma once

#include <array>
#include <cstddef>

namespace tether_monitor::monitor
{
/// One measured coordinate of a vessel at one time.
struct WaySample
{
  double t = 0.0;       ///< [s]
  double value = 0.0;   ///< [m]
  double stddev = 0.0;  ///< of its noise [m], >= 0.

  template <class Archive>
  void archive(Archive& a)
  {
    a(t, value, stddev);
  }
};

/// How likely it is that there is no wave (the first), or one of each frequency of a grid; adds up to 1.
using WaveOdds = std::array<double, 33>;
/// As likely as not there are waves, of whatever frequency.
WaveOdds anyWave();

/// The straight way of a coordinate at one time, and the wave on top.
struct Way
{
  double position = 0.0;  ///< [m]
  double velocity = 0.0;  ///< [m/s]
  double velocity_stddev =
      0.0;                   ///< of it: noise, waves that are too long to be told from a way, or no sines [m/s].
  double wave_rate = 0.0;    ///< of the likeliest wave [rad/s]; 0: more likely there is none.
  double wave_height = 0.0;  ///< standard deviation of the motion in it [m].
  WaveOdds odds{};           ///< after the samples.
};

constexpr std::size_t MOST_WAY_SAMPLES = 256;  ///< that fitWay() looks at.

/**
 * The straight way under the motion in the waves, (E11) of doc/estimation.md: a line, or a line and one wave.
 *
 * A line alone takes part of a wave for a speed as long as the samples span a period or two. Bayes' regression for
 * every frequency of a grid; the way is the mean over them, weighted with their evidence. Samples far off are left
 * out.
 *
 * @param samples  in order of time, `count` > 0 of them, finite.
 * @param t        when the way is wanted [s], near the last sample.
 * @param level    true: the way has no velocity.
 * @param odds     before the samples: of the same vessel's heave, say, for a ship surges and sways with the waves
 *                 that she heaves in.
 */
Way fitWay(const WaySample* samples, std::size_t count, double t, bool level, const WaveOdds& odds = anyWave());

}  // namespace tether_monitor::monitor
