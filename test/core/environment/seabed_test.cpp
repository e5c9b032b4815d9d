#include "tether_monitor/core/environment/seabed.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "support/matrix_compare.h"

namespace tether_monitor::core
{
TEST(Seabed, APlaneAndAGridOfThatPlaneAgree)
{
  Seabed plane;
  plane.depth = 80.0;
  plane.slope = {0.05, -0.1};
  auto grid = std::make_shared<DepthGrid>();
  grid->x0 = -100.0;
  grid->y0 = -50.0;
  grid->dx = 10.0;
  grid->dy = 5.0;
  grid->depth = Eigen::MatrixXd(21, 21);
  for (int i = 0; i < 21; ++i)
    for (int j = 0; j < 21; ++j)
      grid->depth(i, j) = 80.0 + 0.05 * (-100.0 + 10.0 * i) - 0.1 * (-50.0 + 5.0 * j);
  Seabed gridded;
  gridded.grid = grid;
  for (const auto& [x, y] : {std::pair(3.0, 4.0), {-77.7, 21.3}, {50.0, -30.0}})
  {
    EXPECT_NEAR(gridded.at(x, y).z, plane.at(x, y).z, 1e-9);
    EXPECT_TRUE(matricesNear(gridded.at(x, y).normal, plane.at(x, y).normal, 1e-9));
  }
  EXPECT_NEAR(gridded.at(1000.0, 0.0).z, gridded.at(100.0, 0.0).z, 1e-9) << "constant beyond the rim";
}

TEST(Seabed, NormalOfAGridIsThatOfItsSurface)
{
  auto grid = std::make_shared<DepthGrid>();
  grid->depth = Eigen::MatrixXd::Random(6, 5);
  Seabed seabed;
  seabed.grid = grid;
  const double h = 1e-6, x = 2.3, y = 1.6;
  const Vector3 n = seabed.at(x, y).normal;
  EXPECT_NEAR(-n.x() / n.z(), (seabed.at(x + h, y).z - seabed.at(x - h, y).z) / (2 * h), 1e-7);
  EXPECT_NEAR(-n.y() / n.z(), (seabed.at(x, y + h).z - seabed.at(x, y - h).z) / (2 * h), 1e-7);
}

}  // namespace tether_monitor::core
