#include "tether_monitor/monitor/alarms/alarm_life.h"

#include <gtest/gtest.h>

#include <map>

namespace tether_monitor::monitor
{
// The life of an alarm after ISA-18.2, written down a second time: rows are states, columns actions in their order
// (raise, return, realarm, acknowledge, reset, shelve, unshelve, suppress, remove, return to service). "." is: not
// known there. N normal, U unacknowledged, A acknowledged, R returned unacknowledged, L latched, S shelved, D
// suppressed by design, O out of service; r: as the latch says, a: as the manual reset says, c: U if it is past
// its limit, else N.
const char* const LIFE[ALARM_STATES] = {
    "U....S.DO.",  // normal
    ".r.A.S.DO.",  // unacknowledged
    ".aU..S.DO.",  // acknowledged
    "U..a.S.DO.",  // returned, unacknowledged
    "U...NS.DO.",  // latched
    ".....ScDO.",  // shelved
    "........Oc",  // suppressed by design
    ".........c",  // out of service
};

char expected(int state, int action, const AlarmCondition& condition)
{
  const char entry = LIFE[state][action];
  if (entry == 'r')
    return condition.latch || condition.manual_reset ? 'R' : 'N';
  if (entry == 'a')
    return condition.manual_reset ? 'L' : 'N';
  if (entry == 'c')
    return condition.is_past ? 'U' : 'N';
  return entry;
}

TEST(AlarmLife, EveryStateWithEveryActionUnderEveryCondition)
{
  const std::string letters = "NUARLSDO";
  for (int state = 0; state < ALARM_STATES; ++state)
    for (int action = 0; action < ALARM_ACTIONS; ++action)
      for (int bits = 0; bits < 8; ++bits)
      {
        const AlarmCondition condition{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
        const auto next = nextState(static_cast<AlarmState>(state), static_cast<AlarmAction>(action), condition);
        const char found = next ? letters[static_cast<int>(*next)] : '.';
        EXPECT_EQ(found, expected(state, action, condition))
            << "state " << letters[state] << ", action " << action << ", condition " << bits;
      }
}

TEST(AlarmLife, OnlyWhatWasPutAsideIsPutAside)
{
  const std::string letters = "NUARLSDO";
  for (int state = 0; state < ALARM_STATES; ++state)
  {
    EXPECT_EQ(isPutAside(static_cast<AlarmState>(state)), std::string("SDO").find(letters[state]) < 3) << state;
    EXPECT_STRNE(describe(static_cast<AlarmState>(state)), "unknown");
  }
}

TEST(AlarmLife, KnowsTheNamesOfAnOperatorsActionsOnly)
{
  EXPECT_EQ(alarmAction("acknowledge"), AlarmAction::ACKNOWLEDGE);
  EXPECT_EQ(alarmAction("reset"), AlarmAction::RESET);
  EXPECT_EQ(alarmAction("shelve"), AlarmAction::SHELVE);
  EXPECT_EQ(alarmAction("unshelve"), AlarmAction::UNSHELVE);
  EXPECT_EQ(alarmAction("suppress_by_design"), AlarmAction::SUPPRESS_BY_DESIGN);
  EXPECT_EQ(alarmAction("out_of_service"), AlarmAction::REMOVE_FROM_SERVICE);
  EXPECT_EQ(alarmAction("return"), AlarmAction::RETURN_TO_SERVICE);
  EXPECT_FALSE(alarmAction("raise"));
  EXPECT_FALSE(alarmAction(""));
}

}  // namespace tether_monitor::monitor
