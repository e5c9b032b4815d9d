#include "tether_monitor/monitor/measurements/thrust_buffer.h"

#include <gtest/gtest.h>

namespace tether_monitor::monitor
{
namespace
{
core::Wrench ahead(double force)
{
  return {{force, 0.0, 0.0}, core::Vector3::Zero()};
}
}  // namespace

TEST(ThrustBuffer, EachCountsFromItsOwnTimeOn)
{
  ThrustBuffer thrust;
  EXPECT_FALSE(thrust.age(0.0));
  thrust.add(1.0, ahead(10.0));
  thrust.add(2.0, ahead(20.0));  // stamped ahead of the clock
  EXPECT_EQ(thrust.at(0.5).force.x(), 0.0);
  EXPECT_EQ(thrust.at(1.5).force.x(), 10.0);
  EXPECT_EQ(thrust.at(2.0).force.x(), 20.0);
  EXPECT_EQ(*thrust.age(1.5), 0.0);
  EXPECT_EQ(*thrust.age(3.5), 1.5);
  thrust.add(0.7, ahead(99.0));  // late
  EXPECT_EQ(thrust.latest().force.x(), 20.0);
  EXPECT_EQ(*thrust.age(3.5), 1.5);
}

TEST(ThrustBuffer, KeepsTheLatestHoweverManyCome)
{
  ThrustBuffer thrust;
  for (int i = 0; i < 1000; ++i)
    thrust.add(0.01 * i, ahead(i));
  EXPECT_EQ(thrust.at(9.99).force.x(), 999.0);
  EXPECT_EQ(thrust.at(9.705).force.x(), 970.0);
  EXPECT_TRUE(thrust.isValid());
}

}  // namespace tether_monitor::monitor
