#pragma once

#include <cstddef>
#include <vector>

namespace tether_monitor
{
/// Quantiles of the last samples of a time. add() allocates nothing.
class LatencyStatistics
{
 public:
  static constexpr std::size_t CAPACITY = 2000;

  LatencyStatistics() { samples_.reserve(CAPACITY); }
  void add(double seconds);
  std::size_t count() const { return samples_.size(); }
  /// @param share  of the samples below it, 0..1. NaN without samples.
  double quantile(double share) const;
  /// The largest one ever; 0 without samples.
  double most() const { return most_; }

 private:
  std::vector<double> samples_;
  std::size_t next_ = 0;
  double most_ = 0.0;
};

/// How punctual cycles are.
class CycleStatistics
{
 public:
  /// @param period  between cycles [s], > 0.
  explicit CycleStatistics(double period);

  /// A cycle that came `lateness` [s] after its time; a period or more: those in between are missed.
  void add(double lateness);
  long cycles() const { return cycles_; }
  long missed() const { return missed_; }
  /// Share of the cycles of the last ten seconds that were missed, or later than half a period.
  double lateShare() const;
  const LatencyStatistics& lateness() const { return lateness_; }

 private:
  void note(bool is_late);

  double period_;
  long cycles_ = 0, missed_ = 0;
  LatencyStatistics lateness_;
  std::vector<char> late_;  // of the last ten seconds
  std::size_t next_ = 0, late_count_ = 0, noted_ = 0;
};

}  // namespace tether_monitor
