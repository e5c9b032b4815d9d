#pragma once

#include <array>
#include <cstddef>

namespace tether_monitor::monitor
{
/// One measured coordinate of a vessel at one time.
struct TrackSample
{
  double t = 0.0;       ///< [s]
  double value = 0.0;   ///< [m]
  double stddev = 0.0;  ///< of its noise [m], >= 0.

  template <class Archive>
  void serialize(Archive& a)
  {
    a(t, value, stddev);
  }
};

/// How likely it is that there is no wave (the first), or one of each frequency of a grid; adds up to 1.
using WaveProbabilities = std::array<double, 33>;
/// As likely as not there are waves, of whatever frequency.
WaveProbabilities uniformWavePrior();

/// The straight track of a coordinate at one time, and the wave on top.
struct TrackFit
{
  double position = 0.0;  ///< [m]
  double velocity = 0.0;  ///< [m/s]
  double velocity_stddev =
      0.0;  ///< of it: noise, waves that are too long to be distinguished from a track, or no sines [m/s].
  double wave_frequency = 0.0;        ///< of the likeliest wave [rad/s]; 0: more likely there is none.
  double wave_stddev = 0.0;           ///< standard deviation of the motion in it [m].
  WaveProbabilities probabilities{};  ///< after the samples.
};

constexpr std::size_t MAX_TRACK_SAMPLES = 256;  ///< that fitTrackAndWave() uses.

/**
 * The straight track under the motion in the waves, (E11) of doc/theory/estimation.md: a line, or a line and one
 * wave.
 *
 * A line alone takes part of a wave for a speed as long as the samples span a period or two. Bayes' regression for
 * every frequency of a grid; the track is the mean over them, weighted with their evidence. Samples far off are
 * left out.
 *
 * @param samples  in order of time, `count` > 0 of them, finite.
 * @param t        when the track is wanted [s], near the last sample.
 * @param level    true: the track has no velocity.
 * @param probabilities     before the samples: of the same vessel's heave, say, for a ship surges and sways with
 * the waves that she heaves in.
 */
TrackFit fitTrackAndWave(const TrackSample* samples, std::size_t count, double t, bool level,
                         const WaveProbabilities& probabilities = uniformWavePrior());

}  // namespace tether_monitor::monitor
