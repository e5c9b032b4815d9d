#include "tether_monitor/monitor/ensemble/improbability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace tether_monitor::monitor
{
TEST(JointImprobability, OneAloneBeyondFourStandardDeviations)
{
  EXPECT_FALSE(isImprobable({3.9 * 0.2, 0.0, 0.2}));
  EXPECT_TRUE(isImprobable({-4.1 * 0.2, 0.0, 0.2}));
  EXPECT_FALSE(isImprobable({2.5 * 0.2, 0.04, 0.2})) << "next to nothing is known";
  EXPECT_TRUE(isImprobable({3.0 * 0.2, 0.5 * 0.04, 0.2})) << "beyond what so little knowledge can say";
  EXPECT_FALSE(isImprobable({7.0, 0.0, 0.0})) << "known: not learnt";
}

// None of four is remarkable; together they are no chance.
TEST(JointImprobability, ManyTogether)
{
  JointImprobability joint, few;
  for (int k = 0; k < 4; ++k)
    joint.add({2.9, 0.1, 1.0});
  few.add({2.9, 0.1, 1.0});
  for (int k = 0; k < 3; ++k)
    few.add({0.9, 0.1, 1.0});
  EXPECT_NEAR(joint.squaredDistance(), 4 * 2.9 * 2.9, 1e-12);
  EXPECT_TRUE(joint.isImprobable());
  EXPECT_FALSE(few.isImprobable());
}

// Means that are learnt from noisy data, of quantities that are as told: at most about once in a thousand.
TEST(JointImprobability, IsRareWhereThePriorIsRight)
{
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  for (const int learnt : {1, 3, 10})
  {
    constexpr int TRIALS = 200000;
    constexpr double NOISE = 0.5;
    int improbable = 0;
    for (int trial = 0; trial < TRIALS; ++trial)
    {
      JointImprobability joint;
      for (int k = 0; k < 16; ++k)
      {
        const double gain = k < learnt ? 1.0 / (1.0 + NOISE * NOISE) : 0.0;
        joint.add({gain * (normal(generator) + NOISE * normal(generator)), 1.0 - gain, 1.0});
      }
      improbable += joint.isImprobable();
    }
    EXPECT_LE(improbable, 2 * TRIALS / 1000) << learnt;
  }
}
}  // namespace tether_monitor::monitor
