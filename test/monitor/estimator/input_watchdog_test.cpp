#include "tether_monitor/monitor/estimator/input_watchdog.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/estimator_fixture.h"

namespace tether_monitor::monitor
{
TetherEstimate ages(double vessel, double vehicle, double payout)
{
  TetherEstimate e;
  e.vessel_age = vessel;
  e.vehicle_age = e.vehicle_overdue = vehicle;
  e.payout_age = payout;
  return e;
}

TEST(InputWatchdog, NamesTheInputThatIsLate)
{
  const InputWatchdog watchdog(testConfig());
  EXPECT_EQ(watchdog.lateReason(ages(1.0, 1.0, 1.0), false), Reason::NONE) << "at the timeout";
  EXPECT_EQ(watchdog.lateReason(ages(1.1, 2.0, 2.0), false), Reason::VESSEL_STALE);
  EXPECT_EQ(watchdog.lateReason(ages(0.0, 1.1, 2.0), false), Reason::VEHICLE_STALE);
  EXPECT_EQ(watchdog.lateReason(ages(0.0, 1.1, 2.0), true), Reason::PAYOUT_STALE) << "the vehicle coasts";
  EXPECT_EQ(watchdog.invalidReason(ages(5.1, 0.0, NAN), false), Reason::VESSEL_STALE);
  EXPECT_EQ(watchdog.invalidReason(ages(INFINITY, 9.0, NAN), false), Reason::NO_INPUT);
  EXPECT_EQ(watchdog.invalidReason(ages(0.0, 0.0, NAN), false), Reason::NONE) << "no winch reports";
}

TEST(InputWatchdog, RemembersARefusalForAWhile)
{
  InputWatchdog watchdog(testConfig());
  EXPECT_FALSE(watchdog.hasRejectedInput(0.0));
  watchdog.noteRejectedInput(10.0);
  EXPECT_TRUE(watchdog.hasRejectedInput(11.0));
  EXPECT_FALSE(watchdog.hasRejectedInput(11.1));
  EXPECT_FALSE(watchdog.hasRejectedInput(9.0));
  watchdog.clear();
  EXPECT_FALSE(watchdog.hasRejectedInput(10.0));
}

}  // namespace tether_monitor::monitor
