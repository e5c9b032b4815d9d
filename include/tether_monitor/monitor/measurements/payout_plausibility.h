#pragma once

#include <limits>

namespace tether_monitor::monitor
{
/// Whether the deployed lengths and rates that a winch reports can be those of a winch: a length is held against
/// the last one and what a winch can turn, rates over a second against the change of length. Plain data.
class PayoutPlausibility
{
 public:
  enum class Verdict
  {
    GOOD,
    DOUBTFUL,   ///< a leap: not to be used.
    REACQUIRED  ///< the last of so many doubtful ones in a row: that is the length.
  };

  /// Checks a report at time t [s], later than the last. @param rate  [m/s]; NaN: not reported.
  Verdict check(double t, double length, double rate);
  /// False while the rate contradicts the lengths.
  bool trustsRate() const { return trusts_rate_; }
  /// When each was last seen [s]; -infinity: never.
  double lastLeap() const { return last_leap_; }
  double lastOther() const { return last_other_; }
  double lastFrozen() const { return last_frozen_; }
  double lastContradiction() const { return last_contradiction_; }
  void clear() { *this = PayoutPlausibility(); }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(has_report_, t_, length_, rate_, leaps_, leap_time_, leap_length_, began_, from_, integrated_, trusts_rate_,
      last_leap_, last_other_, last_frozen_, last_contradiction_);
  }

 private:
  void compareRate(double t, double length, double rate);

  static constexpr double NEVER = -std::numeric_limits<double>::infinity();
  bool has_report_ = false;
  double t_ = 0.0, length_ = 0.0, rate_ = 0.0;  // of the last good report
  int leaps_ = 0;
  double leap_time_ = 0.0, leap_length_ = 0.0;
  double began_ = 0.0, from_ = 0.0, integrated_ = 0.0;  // of a window over which the rate is integrated
  bool trusts_rate_ = true;
  double last_leap_ = NEVER, last_other_ = NEVER, last_frozen_ = NEVER, last_contradiction_ = NEVER;
};

}  // namespace tether_monitor::monitor
