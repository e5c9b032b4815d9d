#include "tether_monitor/ros/recent_fixes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tether_monitor
{
namespace
{
monitor::PoseMeasurement at(double t, const monitor::MeasuredVector& position)
{
  monitor::PoseMeasurement pose;
  pose.t = t;
  pose.position = position;
  return pose;
}

std::vector<RecentFixes::Fix> listed(const RecentFixes& fixes, double t)
{
  std::vector<RecentFixes::Fix> all;
  fixes.forEach(t, [&](const RecentFixes::Fix& fix) { all.push_back(fix); });
  return all;
}
}  // namespace

TEST(RecentFixes, AreThoseOfTheLastHalfMinuteOldestFirst)
{
  RecentFixes fixes;
  for (int i = 0; i < 1000; ++i)
    fixes.add(at(0.1 * i, core::Vector3(i, 0.0, -5.0)));
  const std::vector<RecentFixes::Fix> last = listed(fixes, 99.9);
  ASSERT_EQ(last.size(), RecentFixes::MOST);
  EXPECT_NEAR(last.front().t, 70.0, 0.51);
  EXPECT_NEAR(last.back().t, 99.5, 1e-9);
  EXPECT_EQ(listed(fixes, 110.0).size(), 40u) << "older ones are forgotten";
  EXPECT_TRUE(listed(fixes, 60.0).empty()) << "those of the time after are not shown where time ran backwards";
}

TEST(RecentFixes, WithoutAHorizontalPlaceAreNone)
{
  RecentFixes fixes;
  monitor::MeasuredVector depth(core::Vector3(0.0, 0.0, -5.0));
  depth.setNotMeasured(0);
  depth.setNotMeasured(1);
  fixes.add(at(1.0, depth));
  EXPECT_TRUE(listed(fixes, 1.0).empty());

  auto flat = monitor::MeasuredVector::withStddev({1.0, 2.0, 0.0}, {0.3, 0.4, 1.0});
  flat.setNotMeasured(2);
  fixes.add(at(1.0, flat));
  ASSERT_EQ(listed(fixes, 1.0).size(), 1u);
  EXPECT_TRUE(std::isnan(listed(fixes, 1.0)[0].place.z()));
  EXPECT_NEAR(listed(fixes, 1.0)[0].stddev.y(), 0.4, 1e-12);
}

}  // namespace tether_monitor
