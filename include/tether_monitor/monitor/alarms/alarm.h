#pragma once

#include <limits>
#include <optional>
#include <string>

#include "tether_monitor/monitor/config/alarm_config.h"

namespace tether_monitor::monitor
{
/// Life of an alarm (after ISA-18.2); the numbers are those of Alarm.msg.
enum class AlarmState
{
  NORMAL = 0,
  UNACKNOWLEDGED = 1,
  ACKNOWLEDGED = 2,
  RETURNED_UNACKNOWLEDGED = 3
};

/// Fixed description of one alarm.
struct AlarmDefinition
{
  std::string name;
  Severity severity = Severity::ALARM;
  Side side = Side::ABOVE;
  double limit = 0.0;  ///< in the unit of the value.
  AlarmTiming timing;
  std::string unit = {};  ///< of value and limit.
};

/// One alarm: watches a value against a limit with delays, deadband, latch and acknowledgement.
class Alarm
{
 public:
  explicit Alarm(AlarmDefinition definition) : definition_(std::move(definition)) {}

  /**
   * Evaluates the value at time t [s].
   *
   * @param value  in the unit of the limit; NaN: unknown, nothing changes; the on-delay goes on, the off-delay
   * starts again.
   * @param s      where along the tether [m]; NaN if nowhere.
   * @return       true if the state changed.
   */
  bool update(double t, double value, double s);
  /// What it watches is not there any more: it returns. @return true if the state changed.
  bool release(double t);
  /// The operator acknowledges it. @return true if the state changed.
  bool acknowledge(double t);
  /// Forgets running delays (the clock jumped); the state stays.
  void resetTimers();

  const AlarmDefinition& definition() const { return definition_; }
  AlarmState state() const { return state_; }
  /// Active or latched: anything but NORMAL.
  bool isAnnunciated() const { return state_ != AlarmState::NORMAL; }
  /// The value is past the limit and was for the on-delay.
  bool isActive() const { return state_ == AlarmState::UNACKNOWLEDGED || state_ == AlarmState::ACKNOWLEDGED; }
  double value() const { return value_; }
  double s() const { return s_; }
  /// The worst value since it became active last, kept after its return; NaN: it never was.
  double peak() const { return peak_; }
  /// When it became active last [s]; NaN: it never was.
  double onset() const { return onset_; }
  /// Time of the last change of state [s]; NaN: it never changed.
  double since() const { return since_; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(state_, value_, s_, since_, peak_, onset_, pending_since_);
  }

 private:
  void enter(AlarmState state, double t);

  AlarmDefinition definition_;
  AlarmState state_ = AlarmState::NORMAL;
  double value_ = 0.0;
  double s_ = 0.0;
  double since_ = std::numeric_limits<double>::quiet_NaN();
  double peak_ = std::numeric_limits<double>::quiet_NaN();
  double onset_ = std::numeric_limits<double>::quiet_NaN();
  std::optional<double> pending_since_;  // start of the delay that is running
};

}  // namespace tether_monitor::monitor
