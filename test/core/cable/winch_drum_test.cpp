#include <gtest/gtest.h>

#include <cmath>

#include "tether_monitor/core/cable/winch_drum.h"

namespace tether_monitor::core
{
TEST(WinchDrum, LayersByHand)
{
  // 0.6 m of drum, 30 mm of tether: 20 turns a layer.
  const WinchDrum drum({0.5, 0.6, 3}, 0.03);
  EXPECT_DOUBLE_EQ(drum.turns(), 60.0);
  EXPECT_NEAR(drum.capacity(), M_PI * 20.0 * (0.53 + 0.59 + 0.65), 1e-12);
  EXPECT_NEAR(drum.paidOut(20.0), M_PI * 20.0 * 0.65, 1e-12) << "the outer layer first";
  EXPECT_NEAR(drum.paidOut(60.0), drum.capacity(), 1e-12);
  EXPECT_NEAR(drum.bendRadius(), 0.265, 1e-12);
  EXPECT_NEAR(drum.lengthPerTurn(5.0), M_PI * 0.65, 1e-12);
  EXPECT_NEAR(drum.lengthPerTurn(59.0), M_PI * 0.53, 1e-12);
}

TEST(WinchDrum, TurnsAndLengthAreInverse)
{
  const WinchDrum drum({0.5, 0.61, 12}, 0.03);
  for (double turns = 0.0; turns <= drum.turns(); turns += 7.3)
    EXPECT_NEAR(drum.turnsFor(drum.paidOut(turns)), turns, 1e-9);
}

TEST(WinchRefuses, WhatCannotBe)
{
  EXPECT_FALSE(validate(WinchProperties{0.0, 0.6, 3}, 0.03, 0.0, 0.0).empty());
  EXPECT_FALSE(validate(WinchProperties{0.5, 0.02, 3}, 0.03, 0.0, 0.0).empty());
  EXPECT_FALSE(validate(WinchProperties{0.5, 0.6, 0}, 0.03, 0.0, 0.0).empty());
  EXPECT_FALSE(validate(WinchProperties{0.5, 0.6, 3}, 0.03, 0.0, 0.4).empty()) << "bends too tightly";
  EXPECT_FALSE(validate(WinchProperties{0.5, 0.6, 3}, 0.03, 400.0, 0.0).empty()) << "does not hold it";
  EXPECT_TRUE(validate(WinchProperties{0.5, 0.6, 12}, 0.03, 400.0, 0.26).empty());
}

}  // namespace tether_monitor::core
