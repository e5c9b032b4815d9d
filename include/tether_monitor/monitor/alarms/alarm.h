#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>

#include "tether_monitor/monitor/alarms/alarm_life.h"
#include "tether_monitor/monitor/config/alarm_config.h"

namespace tether_monitor::monitor
{
/// Fixed description of one alarm.
struct AlarmDefinition
{
  std::string name;
  Severity severity = Severity::ALARM;
  Side side = Side::ABOVE;
  double limit = 0.0;  ///< in the unit of the value.
  AlarmTiming timing;
  std::string unit = {};    ///< of value and limit.
  std::string advice = {};  ///< what to do, a sentence.
};

/**
 * One alarm: watches a value against a limit with delays, deadband, latch and acknowledgement.
 *
 * One that chatters (raised CHATTER_COUNT times within CHATTER_WINDOW) holds on: its off-delay is at least
 * `chatter_hold` until it has been quiet for the window. One that is put aside is watched all the same.
 */
class Alarm
{
 public:
  static constexpr int CHATTER_COUNT = 3;
  static constexpr double CHATTER_WINDOW = 60.0;       ///< [s]
  static constexpr double LONGEST_SHELVING = 43200.0;  ///< [s]

  explicit Alarm(AlarmDefinition definition);

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
  /// An operator's action. @param seconds  for SHELVE: how long, in (0, LONGEST_SHELVING]. @return false, and
  /// nothing changes, where nextState() knows none or `seconds` cannot be.
  bool act(AlarmAction action, double t, double seconds = 0.0);
  /// The operator acknowledges it. @return true if the state changed.
  bool acknowledge(double t) { return act(AlarmAction::ACKNOWLEDGE, t); }
  /// Forgets running delays and ends shelving (the clock jumped). @return true if the state changed.
  bool resetTimers(double t);

  const AlarmDefinition& definition() const { return definition_; }
  AlarmState state() const { return state_; }
  /// To be shown: anything but NORMAL and what was put aside.
  bool isAnnunciated() const { return state_ != AlarmState::NORMAL && !isPutAside(state_); }
  /// The value is past the limit and was for the on-delay, put aside or not.
  bool isActive() const { return is_past_; }
  bool isChattering() const { return is_chattering_; }
  double value() const { return value_; }
  double s() const { return s_; }
  /// The worst value since it became active last, kept after its return; NaN: it never was.
  double peak() const { return peak_; }
  /// When it became active last [s]; NaN: it never was.
  double onset() const { return onset_; }
  /// Time of the last change of state [s]; NaN: it never changed.
  double since() const { return since_; }
  /// End of the shelving [s]; NaN: it is not shelved.
  double shelvedUntil() const { return shelved_until_; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(state_, is_past_, is_chattering_, value_, s_, since_, peak_, onset_, shelved_until_, pending_since_,
      raised_);
  }

 private:
  AlarmCondition condition() const;
  bool apply(AlarmAction action, double t);
  void noteRaise(double t);
  double offDelay() const;
  bool tend(double t);

  AlarmDefinition definition_;
  AlarmState state_ = AlarmState::NORMAL;
  bool is_past_ = false;
  bool is_chattering_ = false;
  double value_ = 0.0;
  double s_ = 0.0;
  double since_ = std::numeric_limits<double>::quiet_NaN();
  double peak_ = std::numeric_limits<double>::quiet_NaN();
  double onset_ = std::numeric_limits<double>::quiet_NaN();
  double shelved_until_ = std::numeric_limits<double>::quiet_NaN();
  std::optional<double> pending_since_;         // start of the delay that is running
  std::array<double, CHATTER_COUNT> raised_{};  // times of the last ones, oldest first
};

}  // namespace tether_monitor::monitor
