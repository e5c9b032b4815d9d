#pragma once

#include <array>

namespace tether_monitor::monitor
{
/**
 * How much a measured coordinate scatters, from the coordinate alone: fifth differences of evenly spaced values
 * leave hardly anything of a motion that the rate resolves (six samples a wave), and all of the noise, (E13) of
 * doc/theory/estimation.md. Plain data.
 */
class DifferenceNoiseEstimator
{
 public:
  static constexpr double UNKNOWN = 0.05;  ///< until it has been measured [m].
  static constexpr double LEAST = 1e-4;    ///< [m]

  /// Accepts a value at time t [s]. Uneven spacing begins a new series.
  void add(double t, double value);
  /// True once there were values enough.
  bool isKnown() const { return samples_ >= ENOUGH; }
  /// Standard deviation of the noise.
  double stddev() const;

  /// False for what no values can have made.
  bool isValid() const { return count_ >= 0 && count_ <= POINTS && samples_ >= 0; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(t_, value_, count_, samples_, variance_);
  }

 private:
  static constexpr int POINTS = 6;
  static constexpr int ENOUGH = 4;  // differences before the answer counts
  std::array<double, POINTS> t_{}, value_{};
  int count_ = 0;    // of the series, at most POINTS
  int samples_ = 0;  // differences taken, at most MOST
  double variance_ = 0.0;
};

}  // namespace tether_monitor::monitor
