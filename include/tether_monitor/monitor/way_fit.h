#pragma once

#include <cstddef>

namespace tether_monitor::monitor
{
/// One measured coordinate of a vessel at one time.
struct WaySample
{
  double t = 0.0;      ///< [s]
  double value = 0.0;  ///< [m]
};

/// The straight way of a coordinate at one time.
struct Way
{
  double position = 0.0;         ///< [m]
  double velocity = 0.0;         ///< [m/s]
  double velocity_stddev = 0.0;  ///< what waves that are no sine may add to the velocity [m/s].
  double wave_rate = 0.0;        ///< of the wave on top [rad/s]; 0: none was found.
  double wave_height = 0.0;      ///< standard deviation of the motion in it [m].
};

/**
 * The straight way under the motion in the waves: least squares of a line and one wave, (E11) of
 * doc/estimation.md.
 *
 * A line alone takes part of a wave for a speed as long as the samples span a period or two; the frequency is the
 * one of a grid that leaves the least. Samples far off are left out.
 *
 * @param samples  in order of time, `count` > 0 of them.
 * @param t        when the way is wanted [s], near the last sample.
 * @param level    true: the way has no velocity.
 */
Way fitWay(const WaySample* samples, std::size_t count, double t, bool level);

}  // namespace tether_monitor::monitor
