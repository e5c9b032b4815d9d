#pragma once

#include <optional>
#include <string>

namespace tether_monitor::monitor
{
/// Where an alarm is in its life (ISA-18.2, IEC 62682); the numbers are those of Alarm.msg.
enum class AlarmState
{
  NORMAL = 0,
  UNACKNOWLEDGED = 1,           ///< past its limit, nobody has acknowledged it.
  ACKNOWLEDGED = 2,             ///< past its limit, acknowledged.
  RETURNED_UNACKNOWLEDGED = 3,  ///< back within its limit, kept until it is acknowledged.
  LATCHED = 4,                  ///< back within its limit, acknowledged, kept until it is reset.
  SHELVED = 5,                  ///< put aside by the operator for a time.
  SUPPRESSED_BY_DESIGN = 6,     ///< put aside because it means nothing in this situation.
  OUT_OF_SERVICE = 7            ///< put aside for maintenance.
};

/// What can happen to an alarm.
enum class AlarmAction
{
  RAISE,                ///< the value has passed the limit, for the on-delay.
  RETURN,               ///< the value has come back, for the off-delay.
  REALARM,              ///< it was acknowledged long ago and is still there.
  ACKNOWLEDGE,          ///< the operator has seen it.
  RESET,                ///< the operator releases a latched one.
  SHELVE,               ///< the operator puts it aside for a time.
  UNSHELVE,             ///< he takes it back, or the time is over.
  SUPPRESS_BY_DESIGN,   ///< a procedure puts it aside.
  REMOVE_FROM_SERVICE,  ///< maintenance puts it aside.
  RETURN_TO_SERVICE     ///< ends the last two.
};

constexpr int ALARM_STATES = 8, ALARM_ACTIONS = 10;

/// What the next state depends on beside state and action.
struct AlarmCondition
{
  bool is_past = false;       ///< the value is past the limit, after the action.
  bool latch = false;         ///< a returned alarm stays until it is acknowledged.
  bool manual_reset = false;  ///< and, acknowledged, until it is reset.
};

/// The state that an action leads to; nothing where the state does not know the action, as NORMAL nothing to
/// acknowledge.
std::optional<AlarmState> nextState(AlarmState state, AlarmAction action, const AlarmCondition& condition);

/// True if it was put aside: it is watched, but not announced.
bool isPutAside(AlarmState state);

/// The word of the message constant: "RETURNED_UNACKNOWLEDGED".
const char* constantName(AlarmState state);
/// Words for people: "back in limits, not acknowledged".
const char* describe(AlarmState state);

/// Actions of an operator by the name that `~alarm_action` knows: acknowledge, reset, shelve, unshelve,
/// suppress_by_design, out_of_service, return. Nothing for another name.
std::optional<AlarmAction> alarmAction(const std::string& name);

}  // namespace tether_monitor::monitor
