#pragma once

#include <vector>

#include "tether_monitor/monitor/alarms/alarm.h"
#include "tether_monitor/monitor/alarms/alarm_log.h"
#include "tether_monitor/monitor/alarms/alarm_quantities.h"

namespace tether_monitor::monitor
{
/// The alarms of one tether: a limit alarm and a warning for each of alarmQuantities() that has them.
class AlarmSet
{
 public:
  explicit AlarmSet(const Config& config);

  /// Evaluates an estimate; values of an INVALID one are unknown, ages are not. @return true if any state changed.
  bool update(const TetherEstimate& estimate, const AlarmInputs& inputs);
  /// Acknowledges every alarm at time t [s]. @return how many changed.
  int acknowledge(double t);
  /// An operator's action on the alarm of a name. @param seconds  for SHELVE. @return why it cannot be; empty if
  /// it was done. Allocates.
  std::string act(const std::string& name, AlarmAction action, double t, double seconds = 0.0);
  /// The clock jumped to t [s]: see Alarm::resetTimers().
  void resetTimers(double t);

  const std::vector<Alarm>& alarms() const { return alarms_; }
  /// The limit alarm of over_tension or of breaking is active or latched. To put one aside hides nothing from a
  /// control loop: while the tension is past its limit this stays true.
  bool overTension() const;
  /// The one that came first, until none is announced any more; < 0: none is.
  int firstOut() const { return first_out_; }
  const AlarmLog& log() const { return log_; }
  /// False for what no update can have made.
  bool isValid() const;

  /// States and log; the definitions are the configuration's.
  template <class Archive>
  void serialize(Archive& a)
  {
    for (Alarm& alarm : alarms_)
      a(alarm);
    a(log_, first_out_);
  }

 private:
  template <typename Change>
  bool noted(std::size_t i, double t, const Change& change);
  void updateFirstOut(std::size_t i);

  std::vector<Alarm> alarms_;
  std::vector<const AlarmQuantity*> quantities_;  // of alarms_, same order
  AlarmLog log_;
  int first_out_ = -1;
};

}  // namespace tether_monitor::monitor
