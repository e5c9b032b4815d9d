#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

namespace tether_monitor
{
/// How the messages of one topic come in: at what rate, how their stamps lie to their receipt, from whom.
class InputStatistics
{
 public:
  /// Stamp less receipt [s]: > 0 is a stamp ahead of the clock.
  struct Offset
  {
    double mean = 0.0, least = 0.0, most = 0.0;
  };
  static constexpr double WINDOW = 5.0;  ///< [s] of receipt that the figures are about.

  /// A message received at time t [s]. @param offset  stamp less receipt [s]; NaN: it has no stamp.
  void add(double t, double offset, const std::string& publisher);
  /// The clock has started again.
  void clear() { *this = InputStatistics(); }

  /**
   * Whether a message received at time t has no time of its own: it has no stamp, and came in the same instant as
   * the one before it, as a burst does where time is simulated. Counts those that were.
   */
  bool isWithoutTime(double t, double offset);

  long count() const { return count_; }
  long withoutTime() const { return without_time_; }
  /// Messages a second over the last complete window [1/s]; 0 before.
  double rate() const { return rate_; }
  /// Of the last complete window; hasOffset() must hold.
  const Offset& offset() const { return offset_; }
  bool hasOffset() const { return has_offset_; }
  /// Who has published within the last window at time t [s].
  std::vector<std::string> publishers(double t) const;
  std::size_t publisherCount(double t) const;

 private:
  struct Window
  {
    double began = std::numeric_limits<double>::quiet_NaN();
    long count = 0, stamped = 0;
    double sum = 0.0, least = std::numeric_limits<double>::infinity(),
           most = -std::numeric_limits<double>::infinity();
  };
  static constexpr std::size_t MOST_PUBLISHERS = 8;

  Window window_;
  long count_ = 0, without_time_ = 0;
  double last_received_ = std::numeric_limits<double>::quiet_NaN();  // [s]
  double rate_ = 0.0;
  Offset offset_;
  bool has_offset_ = false;
  std::map<std::string, double> last_heard_;  // of each publisher [s]
};

}  // namespace tether_monitor
