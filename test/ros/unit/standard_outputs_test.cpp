#include "tether_monitor/ros/standard_outputs.h"

#include <gtest/gtest.h>

namespace tether_monitor
{
using core::Vector3;

TEST(StandardOutputs, TheFrameOfAnEndLooksAlongTheTether)
{
  for (const Vector3& away : {Vector3(1, 0, 0), Vector3(1, 2, -3), Vector3(0, 0, -2), Vector3(0, 0, 5)})
  {
    const core::Matrix3 axes = endFrame(away).toRotationMatrix();
    EXPECT_LT((axes.col(0) - away.normalized()).norm(), 1e-9);
    EXPECT_NEAR(axes(2, 1), 0.0, 1e-9) << "y is horizontal";
    EXPECT_NEAR(axes.determinant(), 1.0, 1e-9);
  }
}

}  // namespace tether_monitor
