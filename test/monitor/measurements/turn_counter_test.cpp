#include "tether_monitor/monitor/measurements/turn_counter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::monitor
{
Eigen::Quaterniond heading(double turns)
{
  return Eigen::Quaterniond(Eigen::AngleAxisd(2.0 * M_PI * turns, Eigen::Vector3d::UnitZ()));
}

TEST(TurnCounter, FollowsTheVehicleThroughFullTurns)
{
  TurnCounter counter;
  EXPECT_TRUE(std::isnan(counter.turns()));
  for (double x = 0.0; x <= 3.25; x += 0.1)
    counter.update(heading(0.0), heading(0.3 + x));
  EXPECT_NEAR(counter.turns(), 3.2, 1e-9);
  for (double x = 3.2; x >= -1.01; x -= 0.1)
    counter.update(heading(0.0), heading(0.3 + x));
  EXPECT_NEAR(counter.turns(), -1.0, 1e-9);
}

TEST(TurnCounter, AVesselThatTurnsTakesThemOut)
{
  TurnCounter counter;
  for (double x = 0.0; x <= 1.05; x += 0.1)
    counter.update(heading(x), heading(0.0));
  EXPECT_NEAR(counter.turns(), -1.0, 1e-9);
  for (double x = 0.0; x <= 2.05; x += 0.1)
    counter.update(heading(1.0 + x), heading(x));
  EXPECT_NEAR(counter.turns(), -1.0, 1e-9) << "both together twist nothing";
}

TEST(TurnCounter, AnUprightVehicleHasNoHeading)
{
  TurnCounter counter;
  counter.update(heading(0.0), heading(0.0));
  counter.update(heading(0.0),
                 heading(0.4) * Eigen::Quaterniond(Eigen::AngleAxisd(M_PI_2, Eigen::Vector3d::UnitY())));
  EXPECT_DOUBLE_EQ(counter.turns(), 0.0);
  counter.update(heading(0.0), heading(0.2));
  EXPECT_NEAR(counter.turns(), 0.2, 1e-12);
}

TEST(TurnCounter, APilotsCountIsGoneOnFrom)
{
  TurnCounter counter;
  EXPECT_FALSE(counter.set(NAN));
  EXPECT_TRUE(std::isnan(counter.turns()));
  EXPECT_TRUE(counter.set(-4.0));
  counter.update(heading(0.0), heading(0.9));
  counter.update(heading(0.0), heading(1.15));
  EXPECT_NEAR(counter.turns(), -3.75, 1e-12);
}

}  // namespace tether_monitor::monitor
