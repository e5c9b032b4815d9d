#pragma once

#include <vector>

#include "tether_monitor/monitor/alarms/alarm.h"
#include "tether_monitor/monitor/alarms/alarm_quantities.h"

namespace tether_monitor::monitor
{
/// The alarms of one tether: a limit alarm and a warning for each of alarmQuantities() that has them.
class AlarmSet
{
 public:
  explicit AlarmSet(const Config& config);

  /// Evaluates an estimate; values of an INVALID one are unknown, ages are not. @return true if any state changed.
  bool update(const TetherEstimate& estimate);
  /// Acknowledges every alarm at time t [s]. @return how many changed.
  int acknowledge(double t);
  void resetTimers();

  const std::vector<Alarm>& alarms() const { return alarms_; }
  /// The limit alarm of over_tension or of breaking is active or latched.
  bool overTension() const;

  /// States only: the definitions are the configuration's.
  template <class Archive>
  void serialize(Archive& a)
  {
    for (Alarm& alarm : alarms_)
      a(alarm);
  }

 private:
  std::vector<Alarm> alarms_;
  std::vector<const AlarmQuantity*> quantities_;  // of alarms_, same order
};

}  // namespace tether_monitor::monitor
