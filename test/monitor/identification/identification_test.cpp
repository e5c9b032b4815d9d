#include "tether_monitor/monitor/identification/identification.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/estimator_fixture.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double PRIOR = 0.3, NOISE = 0.2, MEASURED = 1.8;

// A record that measures drag_normal once, with this noise, and nothing else: what a Gaussian filter about the
// configuration would say.
std::optional<std::vector<ParameterEstimate>> measureOnce(const Config& config)
{
  const double drag = config.tether.drag_normal, gain = PRIOR * PRIOR / (PRIOR * PRIOR + NOISE * NOISE);
  const double vehicle = config.vehicle_body.drag_area.x() / 0.4;
  return std::vector<ParameterEstimate>{
      {"tether.drag_normal", drag + gain * (MEASURED - drag), std::sqrt((1.0 - gain)) * PRIOR, drag, PRIOR},
      {"tether.mass_per_length", config.tether.mass_per_length, 0.09, config.tether.mass_per_length, 0.1},
      {"environment.current.x", config.environment.current.at(0.0).x() + 0.2, 0.1,
       config.environment.current.at(0.0).x(), 0.2},
      {"vehicle.drag", 1.5 / vehicle, 0.01 / vehicle, 1.0, 0.2}};
}

Config observed()
{
  Config config = coarseConfig();
  config.vehicle_mode = VehicleMode::OBSERVED;
  config.tether.drag_normal = 1.2;
  config.vehicle_body.drag_area = {0.4, 0.4, 0.4};
  return config;
}
}  // namespace

TEST(Identification, CountsThePriorOnceHoweverManyPassesItTakes)
{
  const double gain = PRIOR * PRIOR / (PRIOR * PRIOR + NOISE * NOISE);
  const double answer = 1.2 + gain * (MEASURED - 1.2);
  for (const int passes : {1, 2, 5})
  {
    const Identification found = identify(observed(), measureOnce, passes);
    const ParameterEstimate* drag = found.find("tether.drag_normal");
    ASSERT_TRUE(drag);
    EXPECT_NEAR(drag->mean, answer, 1e-12) << passes << " passes";
    EXPECT_EQ(drag->configured, 1.2);
    EXPECT_TRUE(drag->isTold());
    EXPECT_NEAR(drag->surprise(), (answer - 1.2) / PRIOR, 1e-12);
  }
}

TEST(Identification, EndsWhenNothingChangesAndSaysWhatTheRecordDoesNotTell)
{
  const Identification found = identify(observed(), measureOnce, 10);
  EXPECT_TRUE(found.has_settled);
  EXPECT_LT(found.passes, 10);
  EXPECT_FALSE(identify(observed(), measureOnce, 1).has_settled) << "one pass cannot know";
  EXPECT_FALSE(found.find("tether.mass_per_length")->isTold());
  EXPECT_EQ(found.find("tether.colour"), nullptr);
}

// Its factor is one on the drag areas of the pass: what is said is one on those that the user configured.
TEST(Identification, AFactorOnTheVehiclesDragIsAboutWhatIsConfigured)
{
  const ParameterEstimate* drag = nullptr;
  const Identification found = identify(observed(), measureOnce, 4);
  drag = found.find("vehicle.drag");
  ASSERT_TRUE(drag);
  EXPECT_NEAR(drag->mean, 1.5, 0.01);
  EXPECT_NEAR(drag->configured, 1.0, 1e-12);
  EXPECT_NEAR(drag->stddev, 0.01, 1e-4);
}

TEST(Identification, WithoutAnEstimateThereIsNone)
{
  EXPECT_TRUE(identify(
                  observed(), [](const Config&) { return std::nullopt; }, 3)
                  .parameters.empty());
}

}  // namespace tether_monitor::monitor
