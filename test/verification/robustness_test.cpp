// Short versions of the campaigns of scripts/fuzz. The seed is printed: RandomSource(seed) repeats a failure.
#include <gtest/gtest.h>

#include "verification/robustness_checks.h"

namespace tether_monitor::fuzz
{
/// Checks that run with a range of seeds, a different one in each instance.
class Robustness : public testing::TestWithParam<unsigned>
{
};

TEST_P(Robustness, RandomElementsThroughEveryKernel)
{
  constexpr unsigned ELEMENTS = 100;
  for (unsigned seed = ELEMENTS * GetParam(); seed < ELEMENTS * (GetParam() + 1); ++seed)
  {
    RandomSource random(seed);
    EXPECT_EQ(checkElement(random), "") << "seed " << seed;
  }
}

TEST_P(Robustness, RandomTethersInRandomMotion)
{
  RandomSource random(GetParam());
  EXPECT_EQ(checkTether(random), "") << "seed " << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Seeds, Robustness, testing::Range(1u, 101u),
                         [](const auto& seed) { return "Seed" + std::to_string(seed.param); });

}  // namespace tether_monitor::fuzz
