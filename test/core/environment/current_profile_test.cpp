#include "tether_monitor/core/environment/current_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace tether_monitor::core
{
TEST(CurrentProfile, IsLinearBetweenAndConstantBeyond)
{
  const CurrentProfile profile({{10.0, {1.0, 0.0, 0.0}}, {20.0, {0.0, 2.0, 0.0}}});
  EXPECT_EQ(profile.at(5.0), Vector3(1.0, 0.0, 0.0)) << "above the surface";
  EXPECT_EQ(profile.at(-10.0), Vector3(1.0, 0.0, 0.0));
  EXPECT_LT((profile.at(-15.0) - Vector3(0.5, 1.0, 0.0)).norm(), 1e-15);
  EXPECT_EQ(profile.at(-100.0), Vector3(0.0, 2.0, 0.0));
  EXPECT_EQ(CurrentProfile().at(-3.0), Vector3::Zero());
}

using Samples = std::vector<CurrentProfile::Sample>;

TEST(CurrentProfile, RefusesDepthsOutOfOrderAndNumbersThatAreNone)
{
  EXPECT_THROW(CurrentProfile({{10.0, Vector3::Zero()}, {10.0, Vector3::Zero()}}), std::invalid_argument);
  EXPECT_THROW(CurrentProfile(Samples{{NAN, Vector3::Zero()}}), std::invalid_argument);
  EXPECT_THROW(CurrentProfile(Samples{{1.0, Vector3(0.0, NAN, 0.0)}}), std::invalid_argument);
}

TEST(CurrentProfile, OneVelocityHoldsEverywhere)
{
  const CurrentProfile profile(Vector3(0.3, -0.4, 0.0));
  for (const double z : {10.0, 0.0, -1.0, -5000.0})
    EXPECT_EQ(profile.at(z), Vector3(0.3, -0.4, 0.0)) << z;
}

TEST(CurrentProfile, EverySampleAtFaultIsNamed)
{
  const auto found = validate(Samples{{5.0, Vector3::Zero()}, {4.0, Vector3::Zero()}, {6.0, {NAN, 0.0, 0.0}}});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NE(found[0].find("current[1].depth = 4"), std::string::npos) << found[0];
  EXPECT_NE(found[1].find("current[2].velocity"), std::string::npos) << found[1];
  try
  {
    CurrentProfile(Samples{{5.0, Vector3::Zero()}, {4.0, Vector3::Zero()}});
    FAIL() << "accepted";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("current[1].depth"), std::string::npos) << error.what();
  }
}
}  // namespace tether_monitor::core
