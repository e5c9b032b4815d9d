#pragma once

#include <functional>

#include "tether_monitor/monitor/ensemble/ensemble_filter.h"
#include "tether_monitor/monitor/measurements/implausibility.h"

namespace tether_monitor::monitor
{
/// What has been learnt of one quantity whose prior is normal with mean zero.
struct LearntQuantity
{
  double mean = 0.0, variance = 0.0;  ///< now.
  double prior_stddev = 0.0;          ///< 0: known, and left out.
};

/**
 * Whether what has been learnt is farther from the prior than chance explains: one mean beyond four standard
 * deviations of what has been learnt, or the squared distance of all together beyond its 0.999 quantile, (E16) of
 * doc/theory/estimation.md.
 */
class JointImprobability
{
 public:
  void add(const LearntQuantity& quantity);
  /// Sum of the squared means, each over its prior variance [-].
  double squaredDistance() const { return squared_distance_; }
  /// What it exceeds once in a thousand, where the prior is right [-].
  double bound() const;
  bool isImprobable() const { return squared_distance_ > bound(); }

 private:
  double squared_distance_ = 0.0;
  double learnt_ = 0.0;  // degrees of freedom for signal: shares of the prior variances that are gone
};

/// Of one quantity alone: its mean is beyond four standard deviations of what it can have learnt, 0.4 of its prior
/// variance at least.
bool isImprobable(const LearntQuantity& quantity);

/// Notes what no chance explains: every quantity that is improbable alone, or where all are together, the one that
/// is farthest off.
void findImprobable(const EnsembleFilter& filter, const std::function<void(Subject, Implausibility)>& note);

}  // namespace tether_monitor::monitor
