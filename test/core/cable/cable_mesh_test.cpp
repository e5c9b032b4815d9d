#include "tether_monitor/core/cable/cable_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "support/tethers.h"

namespace tether_monitor::core
{
namespace
{
// Arc length of every node.
std::vector<double> meshNodes(double length, int elements, const CableLayout& layout)
{
  const CableMesh mesh(length, elements, layout);
  std::vector<double> s;
  for (int node = 0; node <= mesh.elements(); ++node)
    s.push_back(mesh.arcLength(node));
  return s;
}
}  // namespace

TEST(MeshNodes, LieOnEveryBoundaryAndAreShortBesideAttachments)
{
  CableLayout layout;
  layout.sections = {{10.0, 35.0, towCable()}};
  layout.attachments = {{"float", 60.0, 1.0, 0.1, 0.0}};
  const std::vector<double> s = meshNodes(100.0, 20, layout);
  ASSERT_EQ(s.size(), 21u);
  EXPECT_EQ(s.front(), 0.0);
  EXPECT_EQ(s.back(), 100.0);
  for (double at : {10.0, 35.0, 60.0})
    EXPECT_NE(std::find(s.begin(), s.end(), at), s.end()) << at;
  EXPECT_TRUE(std::is_sorted(s.begin(), s.end()));
  const auto kink = std::find(s.begin(), s.end(), 60.0);
  EXPECT_LT(kink[1] - kink[0], 1.0);
  EXPECT_LT(kink[0] - kink[-1], 1.0);
  EXPECT_THROW(CableMesh(100.0, 3, layout), std::invalid_argument) << "four pieces";
  EXPECT_NEAR(CableMesh(100.0, 4, CableLayout()).arcLength(1), 25.0, 1e-12);
}

}  // namespace tether_monitor::core
