#include "tether_monitor/core/environment/sea_state.h"

#include <gtest/gtest.h>

namespace tether_monitor::core
{
TEST(SeaState, NoHeightIsCalm)
{
  SeaState waves;
  EXPECT_TRUE(waves.isCalm());
  waves.components = {WaveProperties(), WaveProperties()};
  EXPECT_TRUE(waves.isCalm());
  waves.components[1].amplitude = 0.2;
  EXPECT_FALSE(waves.isCalm());
  waves.components[0].amplitude = 0.3;
  EXPECT_DOUBLE_EQ(waves.largestElevation(), 0.5);
}

TEST(SeaState, FaultsNameTheComponent)
{
  SeaState waves;
  waves.components = {{0.5, 60.0, 0.0, 0.0}, {9.0, 60.0, 0.0, 0.0}};
  const std::vector<std::string> found = validate(waves, 9.81);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].find("environment.waves[1].amplitude"), std::string::npos);
  EXPECT_EQ(validate(waves, 0.0).size(), 2u) << "waves need gravity";
  waves.components.resize(MOST_WAVES + 1);
  waves.components[1] = WaveProperties();
  EXPECT_EQ(validate(waves, 9.81).size(), 1u);
}

}  // namespace tether_monitor::core
