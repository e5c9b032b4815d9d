#pragma once

#include <limits>

namespace tether_monitor::monitor
{
/// How often readings of one kind come.
class ReadingRate
{
 public:
  void note(double t);
  /// Readings in so many seconds [-], at least 1.
  double repeatsIn(double memory) const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(last_, interval_);
  }

 private:
  double last_ = -std::numeric_limits<double>::infinity();
  double interval_ = std::numeric_limits<double>::infinity();
};

/// How much a tension varies in the waves.
struct TensionSpread
{
  double mean = std::numeric_limits<double>::quiet_NaN();  ///< of the last half minute [N].
  double variance = 0.0;                                   ///< [N^2]

  void add(double tension, double dt);

  template <class Archive>
  void serialize(Archive& a)
  {
    a(mean, variance);
  }
};

}  // namespace tether_monitor::monitor
