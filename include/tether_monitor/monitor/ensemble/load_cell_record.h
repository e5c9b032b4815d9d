#pragma once

#include <Eigen/Core>
#include <limits>

#include "tether_monitor/monitor/ensemble/fading_memory.h"

namespace tether_monitor::monitor
{
/// Readings of the load cell that were believed, beside what the nominal members had at their times: the last, and
/// the means of half a minute. Plain data: copy it to save it. Allocates nothing after the constructor.
class LoadCellRecord
{
 public:
  explicit LoadCellRecord(int members)
    : nominal_(Eigen::RowVectorXd::Zero(members)), mean_nominal_(Eigen::RowVectorXd::Zero(members))
  {
  }

  /// @param nominal  tensions of the members at the vessel end at time t [N]. Times must not go back.
  void add(double t, double tension, double noise_variance, const Eigen::RowVectorXd& nominal);
  void clear() { *this = LoadCellRecord(static_cast<int>(nominal_.size())); }

  double t() const { return t_; }                           ///< of the last [s]; -infinity: there was none.
  double tension() const { return tension_; }               ///< the last [N].
  double noiseVariance() const { return noise_variance_; }  ///< of the cell alone, without bias [N^2].
  const Eigen::RowVectorXd& nominal() const { return nominal_; }

  /**
   * What has been measured over what a nominal member had, (F7) of doc/theory/forecast.md: 1 where the tension is
   * within the cell's bias, where ten seconds have not been read, and where the last was a minute ago; 0.5 to 2.
   *
   * @param bias  of the cell, as the member has it [N]. @param bias_stddev  of it [N]. @param t  now [s].
   */
  double ratio(int member, double bias, double bias_stddev, double t) const;
  bool isValid(int members) const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(t_, tension_, noise_variance_, nominal_, memory_, mean_tension_, mean_nominal_);
  }

 private:
  double t_ = -std::numeric_limits<double>::infinity();  // [s]
  double tension_ = 0.0, noise_variance_ = 0.0;          // [N, N^2]
  Eigen::RowVectorXd nominal_;                           // [N]
  FadingMemory memory_;
  double mean_tension_ = 0.0;        // [N]
  Eigen::RowVectorXd mean_nominal_;  // [N]
};

}  // namespace tether_monitor::monitor
