#pragma once

#include <limits>

namespace tether_monitor::monitor
{
/// A reading of the load cell beside what the model predicts of it; NaN: there was none.
struct TensionResidual
{
  double t = std::numeric_limits<double>::quiet_NaN();          ///< [s]
  double measured = std::numeric_limits<double>::quiet_NaN();   ///< [N]
  double predicted = std::numeric_limits<double>::quiet_NaN();  ///< [N]
  double stddev = std::numeric_limits<double>::quiet_NaN();     ///< of their difference [N].

  /// The difference over its standard deviation, > 0 where more was measured [-].
  double normalized() const { return (measured - predicted) / stddev; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(t, measured, predicted, stddev);
  }
};

}  // namespace tether_monitor::monitor
