#include "tether_monitor/ros/transform_input.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor
{
namespace
{
const ros::Time NOW(1000.0);

tf2_msgs::TFMessage message(const ros::Time& stamp)
{
  tf2_msgs::TFMessage m;
  m.transforms.resize(1);
  m.transforms[0].header.stamp = stamp;
  m.transforms[0].header.frame_id = "map";
  m.transforms[0].child_frame_id = "site";
  m.transforms[0].transform.rotation.w = 1.0;
  return m;
}
}  // namespace

TEST(TransformInput, AGoodTransformIsKnownAfterwards)
{
  tf2::BufferCore buffer;
  EXPECT_EQ(addTransforms(message(NOW), false, NOW, buffer), std::nullopt);
  EXPECT_TRUE(buffer.canTransform("map", "site", NOW));
}

TEST(TransformInput, WhatWouldEndTheNodeOrDriveOutTheOthersIsRefused)
{
  tf2::BufferCore buffer;
  ASSERT_EQ(addTransforms(message(NOW), false, NOW, buffer), std::nullopt);
  for (const ros::Time& stamp : {ros::Time(2147483700u, 0), ros::Time(4294967295u, 0), NOW + ros::Duration(60.0)})
    EXPECT_TRUE(addTransforms(message(stamp), false, NOW, buffer)) << stamp;
  for (const ros::Time& stamp : {ros::Time(4294967295u, 0), ros::Time(1, 0)})
    EXPECT_NO_THROW(addTransforms(message(stamp), true, NOW, buffer)) << stamp;
  tf2_msgs::TFMessage bad = message(NOW);
  bad.transforms[0].transform.translation.x = NAN;
  EXPECT_TRUE(addTransforms(bad, false, NOW, buffer));
  bad = message(NOW);
  bad.transforms[0].transform.rotation.w = 0.0;
  EXPECT_TRUE(addTransforms(bad, false, NOW, buffer));
  bad = message(NOW);
  bad.transforms[0].child_frame_id = "map";
  EXPECT_TRUE(addTransforms(bad, false, NOW, buffer));
  EXPECT_TRUE(buffer.canTransform("map", "site", NOW));
}

}  // namespace tether_monitor
