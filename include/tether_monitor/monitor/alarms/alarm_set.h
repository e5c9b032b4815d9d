#pragma once

#include <vector>

#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"

namespace tether_monitor::monitor
{
/// The alarms of one tether. The limit alarm of a quantity has its name, the warning has "_warning" behind it.
class AlarmSet
{
 public:
  explicit AlarmSet(const Config& config);

  /// Looks at an estimate; values of an INVALID one are unknown, ages are not. @return true if any state changed.
  bool update(const TetherEstimate& estimate);
  /// Acknowledges every alarm at time t [s]. @return how many changed.
  int acknowledge(double t);
  void resetTimers();

  const std::vector<Alarm>& alarms() const { return alarms_; }
  /// The over-tension limit alarm is active or latched.
  bool overTension() const;

  /// States only: the definitions are the configuration's.
  template <class Archive>
  void serialize(Archive& a)
  {
    for (Alarm& alarm : alarms_)
      a(alarm);
  }

 private:
  enum class Quantity
  {
    WORKING_UTILISATION,
    BREAKING_UTILISATION,
    MIN_TENSION,
    BEND_RADIUS,
    AGE
  };

  void define(const char* name, Quantity quantity, Side side, Severity severity, const AlarmConfig& config);

  std::vector<Alarm> alarms_;
  std::vector<Quantity> quantities_;  // of alarms_, same order
};

}  // namespace tether_monitor::monitor
