#include "tether_monitor/core/base/lane_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tether_monitor::core
{
namespace
{
constexpr int LANES = 2;
typedef double Lanes __attribute__((vector_size(LANES * sizeof(double))));

class LaneMath : public ::testing::Test
{
 protected:
  Lanes random(double low, double high)
  {
    Lanes x{};
    for (int i = 0; i < LANES; ++i)
      x[i] = std::uniform_real_distribution<double>(low, high)(generator_);
    return x;
  }

 private:
  std::mt19937 generator_{7};
};
}  // namespace

TEST_F(LaneMath, EveryLaneIsTheNumber)
{
  for (int round = 0; round < 1000; ++round)
  {
    const Lanes a = random(-10.0, 10.0), b = random(-10.0, 10.0), positive = random(0.0, 1e6);
    const Lanes larger = lanes::max(a, b), smaller = lanes::min(a, b), size = lanes::abs(a);
    const Lanes root = lanes::sqrt(positive);
    for (int i = 0; i < LANES; ++i)
    {
      const double x = a[i], y = b[i], z = positive[i];
      ASSERT_EQ(larger[i], std::max(x, y));
      ASSERT_EQ(smaller[i], std::min(x, y));
      ASSERT_EQ(size[i], std::abs(x));
      ASSERT_EQ(root[i], std::sqrt(z));
      ASSERT_EQ(lanes::max(x, y), larger[i]);
      ASSERT_EQ(lanes::min(x, y), smaller[i]);
      ASSERT_EQ(lanes::abs(x), size[i]);
      ASSERT_EQ(lanes::sqrt(z), root[i]);
    }
  }
}

TEST_F(LaneMath, DotSumsThreeProductsInEveryLane)
{
  const double a[3] = {1.0, 2.0, 3.0}, b[3] = {4.0, -5.0, 6.0};
  EXPECT_EQ(lanes::dot(a, b), 12.0);
  const Lanes x[3] = {{1.0, 0.0}, {2.0, 1.0}, {3.0, 0.0}}, y[3] = {{4.0, 9.0}, {-5.0, 7.0}, {6.0, 8.0}};
  const Lanes sum = lanes::dot(x, y);
  EXPECT_EQ(sum[0], 12.0);
  EXPECT_EQ(sum[1], 7.0);
}

TEST_F(LaneMath, BroadcastFillsAndAnyFindsOneLane)
{
  const Lanes all = lanes::broadcast<Lanes>(2.5);
  EXPECT_EQ(all[0], 2.5);
  EXPECT_EQ(all[1], 2.5);
  EXPECT_EQ(lanes::broadcast<double>(2.5), 2.5);
  const Lanes first{3.0, 1.0}, last{1.0, 3.0}, none{1.0, 2.5};
  EXPECT_TRUE(lanes::any(first > all));
  EXPECT_TRUE(lanes::any(last > all));
  EXPECT_FALSE(lanes::any(none > all));
  EXPECT_TRUE(lanes::any(true));
  EXPECT_FALSE(lanes::any(false));
}
}  // namespace tether_monitor::core
