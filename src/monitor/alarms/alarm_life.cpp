#include "tether_monitor/monitor/alarms/alarm_life.h"

namespace tether_monitor::monitor
{
namespace
{
using State = AlarmState;
using Next = std::optional<AlarmState>;

// Back in its limit, and seen by the operator.
State settled(const AlarmCondition& condition)
{
  return condition.manual_reset ? State::LATCHED : State::NORMAL;
}

State announced(const AlarmCondition& condition)
{
  return condition.is_past ? State::UNACKNOWLEDGED : State::NORMAL;
}

Next afterReturn(State state, const AlarmCondition& condition)
{
  if (state == State::ACKNOWLEDGED)
    return settled(condition);
  if (state != State::UNACKNOWLEDGED)
    return std::nullopt;
  return condition.latch || condition.manual_reset ? State::RETURNED_UNACKNOWLEDGED : State::NORMAL;
}

Next afterAcknowledgement(State state, const AlarmCondition& condition)
{
  if (state == State::UNACKNOWLEDGED)
    return State::ACKNOWLEDGED;
  return state == State::RETURNED_UNACKNOWLEDGED ? Next(settled(condition)) : std::nullopt;
}

bool isOf(State state, State one, State other)
{
  return state == one || state == other;
}
}  // namespace

Next nextState(State state, AlarmAction action, const AlarmCondition& condition)
{
  switch (action)
  {
    case AlarmAction::RAISE:
      return isOf(state, State::NORMAL, State::LATCHED) || state == State::RETURNED_UNACKNOWLEDGED
                 ? Next(State::UNACKNOWLEDGED)
                 : std::nullopt;
    case AlarmAction::RETURN:
      return afterReturn(state, condition);
    case AlarmAction::REALARM:
      return state == State::ACKNOWLEDGED ? Next(State::UNACKNOWLEDGED) : std::nullopt;
    case AlarmAction::ACKNOWLEDGE:
      return afterAcknowledgement(state, condition);
    case AlarmAction::RESET:
      return state == State::LATCHED ? Next(State::NORMAL) : std::nullopt;
    case AlarmAction::SHELVE:
      return isOf(state, State::SUPPRESSED_BY_DESIGN, State::OUT_OF_SERVICE) ? std::nullopt : Next(State::SHELVED);
    case AlarmAction::UNSHELVE:
      return state == State::SHELVED ? Next(announced(condition)) : std::nullopt;
    case AlarmAction::SUPPRESS_BY_DESIGN:
      return isOf(state, State::SUPPRESSED_BY_DESIGN, State::OUT_OF_SERVICE) ? std::nullopt
                                                                             : Next(State::SUPPRESSED_BY_DESIGN);
    case AlarmAction::REMOVE_FROM_SERVICE:
      return state == State::OUT_OF_SERVICE ? std::nullopt : Next(State::OUT_OF_SERVICE);
    case AlarmAction::RETURN_TO_SERVICE:
      return isOf(state, State::SUPPRESSED_BY_DESIGN, State::OUT_OF_SERVICE) ? Next(announced(condition))
                                                                             : std::nullopt;
  }
  return std::nullopt;
}

bool isPutAside(State state)
{
  return state == State::SHELVED || isOf(state, State::SUPPRESSED_BY_DESIGN, State::OUT_OF_SERVICE);
}

const char* constantName(State state)
{
  switch (state)
  {
    case State::NORMAL:
      return "NORMAL";
    case State::UNACKNOWLEDGED:
      return "UNACKNOWLEDGED";
    case State::ACKNOWLEDGED:
      return "ACKNOWLEDGED";
    case State::RETURNED_UNACKNOWLEDGED:
      return "RETURNED_UNACKNOWLEDGED";
    case State::LATCHED:
      return "LATCHED";
    case State::SHELVED:
      return "SHELVED";
    case State::SUPPRESSED_BY_DESIGN:
      return "SUPPRESSED_BY_DESIGN";
    case State::OUT_OF_SERVICE:
      return "OUT_OF_SERVICE";
  }
  return "UNKNOWN";
}

const char* describe(State state)
{
  switch (state)
  {
    case State::NORMAL:
      return "normal";
    case State::UNACKNOWLEDGED:
      return "ACTIVE";
    case State::ACKNOWLEDGED:
      return "active, acknowledged";
    case State::RETURNED_UNACKNOWLEDGED:
      return "back in limits, not acknowledged";
    case State::LATCHED:
      return "back in limits, to be reset";
    case State::SHELVED:
      return "shelved";
    case State::SUPPRESSED_BY_DESIGN:
      return "suppressed by design";
    case State::OUT_OF_SERVICE:
      return "out of service";
  }
  return "unknown";
}

std::optional<AlarmAction> alarmAction(const std::string& name)
{
  const std::pair<const char*, AlarmAction> names[] = {{"acknowledge", AlarmAction::ACKNOWLEDGE},
                                                       {"reset", AlarmAction::RESET},
                                                       {"shelve", AlarmAction::SHELVE},
                                                       {"unshelve", AlarmAction::UNSHELVE},
                                                       {"suppress_by_design", AlarmAction::SUPPRESS_BY_DESIGN},
                                                       {"out_of_service", AlarmAction::REMOVE_FROM_SERVICE},
                                                       {"return", AlarmAction::RETURN_TO_SERVICE}};
  for (const auto& [known, action] : names)
    if (name == known)
      return action;
  return std::nullopt;
}

}  // namespace tether_monitor::monitor
