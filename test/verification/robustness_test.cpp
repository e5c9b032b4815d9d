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

// What is called a steady state on the seabed stays where it is.
TEST(RestOnSeabed, NoneMovesInTheNextMinute)
{
  constexpr int STATES = 500;
  int found = 0;
  for (unsigned seed = 1; seed <= STATES; ++seed)
  {
    RandomSource random(7000 + seed);
    const RestOutcome outcome = restOnSeabed(random);
    found += outcome.found;
    EXPECT_LE(outcome.drift, 3e-3) << "seed " << 7000 + seed;
  }
  EXPECT_GE(found, 0.95 * STATES) << "the others drift for longer than ten minutes";
}

}  // namespace tether_monitor::fuzz
