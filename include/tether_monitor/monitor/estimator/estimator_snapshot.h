#pragma once

#include <cstdint>
#include <vector>

#include "tether_monitor/monitor/estimator/tether_estimator.h"

namespace tether_monitor::monitor
{
/// The saved state of a TetherEstimator: see TetherEstimator::save() and restore().
class EstimatorSnapshot
{
 public:
  static std::vector<std::uint8_t> save(const TetherEstimator& estimator);
  static bool restore(const std::vector<std::uint8_t>& bytes, TetherEstimator& estimator);
  /// Of an estimator whose configuration differs in live settings.
  static bool carryOver(const TetherEstimator& from, TetherEstimator& to);

 private:
  static bool restore(const std::vector<std::uint8_t>& bytes, std::uint64_t configuration,
                      TetherEstimator& estimator);
};

}  // namespace tether_monitor::monitor
