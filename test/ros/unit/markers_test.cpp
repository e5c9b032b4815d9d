#include "tether_monitor/ros/markers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/estimator_fixture.h"

namespace tether_monitor
{
TEST(Markers, KeepTheirIdsAndAreDeletedWhileInvalid)
{
  monitor::TetherEstimator estimator(monitor::coarseConfig());
  const auto names = [](const visualization_msgs::MarkerArray& array)
  {
    std::vector<std::pair<std::string, int>> ids;
    for (const auto& m : array.markers)
      ids.emplace_back(m.ns, m.id);
    return ids;
  };
  const auto invalid = markers(std_msgs::Header(), estimator, RecentFixes());
  EXPECT_EQ(invalid.markers[0].action, visualization_msgs::Marker::DELETE);
  estimator.begin(0.0, {{{0, 0, 0}, {0, 0, 0}}, {{50, 0, -60}, {0, 0, 0}}, 0.0, 0.0});
  const auto valid = markers(std_msgs::Header(), estimator, RecentFixes());
  EXPECT_EQ(names(invalid), names(valid));
  EXPECT_EQ(valid.markers[0].action, visualization_msgs::Marker::ADD);
  EXPECT_EQ(valid.markers[0].points.size(), valid.markers[0].colors.size());
}

TEST(Markers, ALineOfTheForecastIsThereOrDeleted)
{
  const visualization_msgs::Marker line =
      forecastLine(std_msgs::Header(), {{0.0, 0.0, 0.0}, {3.0, 4.0, 0.0}, {3.0, 4.0, -5.0}});
  EXPECT_EQ(line.action, visualization_msgs::Marker::ADD);
  ASSERT_EQ(line.points.size(), 3u);
  EXPECT_EQ(line.points[2].z, -5.0);
  EXPECT_GT(line.scale.x, 0.0);
  EXPECT_EQ(forecastLine(std_msgs::Header(), {}).action, visualization_msgs::Marker::DELETE);
}

TEST(UtilisationColour, GoesFromBlueOverYellowToRed)
{
  EXPECT_GT(utilisationColour(0.0, 0.8).b, 0.9);
  EXPECT_LT(utilisationColour(0.0, 0.8).r, 0.4);
  EXPECT_GT(utilisationColour(0.8, 0.8).r, 0.9);
  EXPECT_GT(utilisationColour(0.8, 0.8).g, 0.8);
  EXPECT_LT(utilisationColour(0.8, 0.8).b, 0.3);
  for (const double u : {1.2, std::nan("")})
  {
    EXPECT_GT(utilisationColour(u, 0.8).r, 0.85);
    EXPECT_LT(utilisationColour(u, 0.8).g, 0.2);
  }
}

}  // namespace tether_monitor
