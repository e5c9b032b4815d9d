// Short versions of the campaigns of scripts/fuzz.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "checks.h"

namespace tether_monitor::fuzz
{
TEST(Fuzz, RandomElementsThroughEveryKernel)
{
  constexpr int ELEMENTS = 100;  // in each of rapidcheck's hundred cases, and up to 17 in a row
  EXPECT_TRUE(rc::check("finite coordinates give finite forces, and every kernel the same",
                        [](unsigned seed)
                        {
                          for (unsigned i = 0; i < ELEMENTS; ++i)
                          {
                            Dice dice(seed + i);
                            RC_ASSERT(checkElement(dice) == "");
                          }
                        }));
}

TEST(Fuzz, RandomTethersInRandomMotion)
{
  EXPECT_TRUE(rc::check("an estimate is finite, or INVALID with a reason, within the budget",
                        [](unsigned seed)
                        {
                          Dice dice(seed);
                          RC_ASSERT(checkTether(dice) == "");
                        }));
}

}  // namespace tether_monitor::fuzz
