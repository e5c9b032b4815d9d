#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <std_msgs/Bool.h>
#include <tether_monitor/TetherState.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cmath>

#include "common/main.h"

using tether_monitor::TetherState;

TEST(NominalBag, TheRunIsFollowedFromEndToEnd)
{
  ros::NodeHandle nh;
  std::vector<TetherState> states;
  geometry_msgs::PointStamped marker;
  std::vector<double> distances;
  int forces = 0, markers = 0;
  const auto on_state = [&](const TetherState::ConstPtr& s)
  {
    states.push_back(*s);
    if (s->status == TetherState::STATUS_INVALID || marker.header.stamp.isZero())
      return;
    const auto hi = std::upper_bound(s->s.begin(), s->s.end(), 1.2) - s->s.begin();
    const double x = (1.2 - s->s[hi - 1]) / (s->s[hi] - s->s[hi - 1]);
    const auto &a = s->position[hi - 1], &b = s->position[hi];
    distances.push_back(std::hypot(a.x + x * (b.x - a.x) - marker.point.x, a.y + x * (b.y - a.y) - marker.point.y,
                                   a.z + x * (b.z - a.z) - marker.point.z));
  };
  const std::string node = "/rov1/tether_monitor/";
  ros::Subscriber state = nh.subscribe<TetherState>(node + "state", 1000, on_state);
  ros::Subscriber measured = nh.subscribe<geometry_msgs::PointStamped>(
      "/rov1/marker/measured", 1000, [&](const geometry_msgs::PointStamped::ConstPtr& m) { marker = *m; });
  ros::Subscriber force = nh.subscribe<geometry_msgs::WrenchStamped>(
      node + "vehicle_end/force", 1000,
      [&](const geometry_msgs::WrenchStamped::ConstPtr& f)
      { forces += std::isfinite(f->wrench.force.x) && f->header.frame_id == "map"; });
  ros::Subscriber picture = nh.subscribe<visualization_msgs::MarkerArray>(
      node + "markers", 1000,
      [&](const visualization_msgs::MarkerArray::ConstPtr& m) { markers += !m->markers.empty(); });

  const ros::WallTime limit = ros::WallTime::now() + ros::WallDuration(60.0);
  ros::WallRate rate(500.0);
  while (ros::ok() && ros::WallTime::now() < limit &&
         (states.empty() || states.back().header.stamp.toSec() < 27.5))
  {
    ros::spinOnce();
    rate.sleep();
  }
  ASSERT_GT(states.size(), 200u);
  EXPECT_EQ(states.back().status, TetherState::STATUS_OK);
  EXPECT_LT(std::count_if(states.begin(), states.end(),
                          [](const TetherState& s) { return s.status == TetherState::STATUS_INVALID; }),
            5);
  EXPECT_GT(std::count_if(states.begin(), states.end(),
                          [](const TetherState& s) { return s.status == TetherState::STATUS_OK; }),
            static_cast<long>(0.95 * states.size()));
  EXPECT_GT(forces, 200);
  EXPECT_GT(markers, 200);
  ASSERT_GT(distances.size(), 200u);
  std::sort(distances.begin(), distances.end());
  EXPECT_LT(distances[distances.size() / 2], 0.110);
  EXPECT_LT(distances[distances.size() * 95 / 100], 0.170);
}
