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
  EXPECT_EQ(watchdog.lateReasons(ages(1.0, 1.0, 1.0), false).gravest(), Reason::NONE) << "at the timeout";
  EXPECT_EQ(watchdog.lateReasons(ages(1.1, 2.0, 2.0), false).gravest(), Reason::VESSEL_STALE);
  EXPECT_EQ(watchdog.lateReasons(ages(0.0, 1.1, 2.0), false).gravest(), Reason::VEHICLE_STALE);
  EXPECT_EQ(watchdog.lateReasons(ages(0.0, 1.1, 2.0), true).gravest(), Reason::PAYOUT_STALE)
      << "the vehicle coasts";
  EXPECT_EQ(watchdog.invalidReasons(ages(5.1, 0.0, NAN), false).gravest(), Reason::VESSEL_STALE);
  EXPECT_EQ(watchdog.invalidReasons(ages(INFINITY, 9.0, NAN), false).gravest(), Reason::NO_INPUT);
  EXPECT_EQ(watchdog.invalidReasons(ages(0.0, 0.0, NAN), false).gravest(), Reason::NONE) << "no winch reports";
  const ReasonSet all = watchdog.lateReasons(ages(2.0, 2.0, 2.0), false);
  EXPECT_TRUE(all.has(Reason::VESSEL_STALE) && all.has(Reason::VEHICLE_STALE) && all.has(Reason::PAYOUT_STALE));
  EXPECT_EQ(all.bits(), (1u << 3) | (1u << 4) | (1u << 5));
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
