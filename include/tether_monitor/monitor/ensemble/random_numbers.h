#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace tether_monitor::monitor
{
/// Normally distributed numbers, the same on every machine: SplitMix64 (Steele, Lea and Flood 2014) and the method
/// of Box and Muller. Plain data: copy it to save it.
class RandomNumbers
{
 public:
  explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}

  /// Mean 0, variance 1.
  double normal();
  /// Of every row mean 0 and variance 1 over the columns, and no correlation between rows, exactly; more columns
  /// than rows. Allocates nothing. @param sample  out.
  void fillUncorrelated(Eigen::Ref<Eigen::MatrixXd> sample);

  template <class Archive>
  void serialize(Archive& a)
  {
    a(state_);
  }

 private:
  double uniform();

  std::uint64_t state_;
};

}  // namespace tether_monitor::monitor
