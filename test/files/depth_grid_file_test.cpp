#include "tether_monitor/files/depth_grid_file.h"

#include <gtest/gtest.h>

#include "support/text_files.h"

namespace tether_monitor::files
{
namespace
{
std::string faultOf(const std::string& text)
{
  const std::string path = ownFile("grid.csv", text);
  const std::string error = errorOf([&] { readDepthGrid(path); });
  EXPECT_NE(error.find(path), std::string::npos) << error;
  return error.substr(error.find(path) + path.size());
}
}  // namespace

TEST(DepthGridFile, NodesMayStandInAnyOrder)
{
  const core::DepthGrid grid =
      readDepthGrid(ownFile("grid.csv", "depth,x,y\n16,30,5\n11,10,0\n12,20,0\n15,20,5\n13,30,0\n14,10,5\n"));
  EXPECT_EQ(grid.x0, 10.0);
  EXPECT_EQ(grid.y0, 0.0);
  EXPECT_EQ(grid.dx, 10.0);
  EXPECT_EQ(grid.dy, 5.0);
  Eigen::MatrixXd expected(3, 2);
  expected << 11, 14, 12, 15, 13, 16;
  EXPECT_EQ(grid.depth, expected);
}

TEST(DepthGridFile, FaultsAreNamed)
{
  EXPECT_NE(faultOf("x,y,depth,name\n0,0,1,2\n").find("the header does not name the columns"), std::string::npos);
  EXPECT_NE(faultOf("x,depth\n0,1\n").find("columns x, y and depth"), std::string::npos);
  EXPECT_NE(faultOf("x,y,depth\n").find("no rows"), std::string::npos);
  EXPECT_NE(faultOf("x,y,depth\n0,0,1\n0,1,1\n").find("column x has fewer than two"), std::string::npos);
  EXPECT_NE(faultOf("x,y,depth\n0,0,1\n0,1,1\n1,0,1\n").find("2 by 2 nodes are expected, some are missing"),
            std::string::npos);
  EXPECT_EQ(faultOf("x,y,depth\n0,0,1\n0,1,1\n1,0,1\n1,0,1\n"), ", line 5: the node is there twice");
  EXPECT_EQ(faultOf("x,y,depth\n0,0,1\n0,1,1\n1,0,1\n1,1,1\n3,0,1\n3,1,1\n"),
            ", line 4: the node is not on an evenly spaced grid");
}

TEST(DepthGridFile, AnAbsolutePathNeedsNoFolder)
{
  EXPECT_EQ(fileBeside("/data/site", "grid.csv"), "/data/site/grid.csv");
  EXPECT_EQ(fileBeside("/data/site", "/other/grid.csv"), "/other/grid.csv");
  EXPECT_EQ(fileBeside("", "grid.csv"), "grid.csv");
}
}  // namespace tether_monitor::files
