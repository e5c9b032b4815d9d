#include <gtest/gtest.h>

#include <random>
#include <thread>

#include "support/estimator_fixture.h"

namespace tether_monitor::monitor
{
namespace
{
// Everything at once: a body, waves, a seabed, obstacles, a winch, strumming.
Config fullConfig()
{
  Config config = testConfig();
  config.vehicle_mode = VehicleMode::FREE;
  config.vehicle_body = smallVehicle();
  config.vehicle_body.attachment = {0.3, 0.0, 0.1};
  config.drag_amplification = 1.5;
  config.environment.waves.components = {{0.5, 60.0, 0.0, 0.0}};
  config.environment.seabed = core::Seabed();
  config.environment.seabed->depth = 80.0;
  core::Obstacle pile;
  pile.name = "pile";
  pile.shape = core::ObstacleShape::CYLINDER;
  pile.size = {0.5, 200.0, 0.0};
  pile.position = {0.0, -0.5, -40.0};
  pile.friction = 0.3;
  config.environment.obstacles = {pile};
  return config;
}

void drive(EstimatorFixture& feeder, double duration, double& length)
{
  for (int k = 0; k < static_cast<int>(std::round(duration / 0.1)); ++k)
  {
    length += 0.002;
    feeder.estimator.addPayout(feeder.t + 0.1, length, 0.02);
    feeder.vessel.z() = 1.0 + 0.3 * std::sin(feeder.t);
    feeder.run(0.1);
  }
}

std::vector<std::uint8_t> history(double duration)
{
  EstimatorFixture feeder(fullConfig());
  double length = 100.0;
  drive(feeder, duration, length);
  return feeder.estimator.save();
}
}  // namespace

TEST(EstimatorArchive, GoesOnBitForBit)
{
  EstimatorFixture feeder(fullConfig());
  double length = 100.0;
  feeder.estimator.setCurrent(core::CurrentProfile({0.2, 0.1, 0.0}));
  drive(feeder, 3.0, length);
  ASSERT_TRUE(feeder.estimator.setDepth(81.0));
  drive(feeder, 2.0, length);
  ASSERT_TRUE(feeder.estimator.isRunning()) << describe(feeder.estimator.estimate().reason);
  const std::vector<std::uint8_t> saved = feeder.estimator.save();

  EstimatorFixture other(fullConfig());
  ASSERT_TRUE(other.estimator.restore(saved));
  EXPECT_EQ(other.estimator.save(), saved);
  EXPECT_EQ(other.estimator.estimate().vessel_tension, feeder.estimator.estimate().vessel_tension);
  other.t = feeder.t;
  double other_length = length;
  drive(feeder, 5.0, length);
  drive(other, 5.0, other_length);
  EXPECT_NE(feeder.estimator.save(), saved) << "it moved";
  EXPECT_EQ(other.estimator.save(), feeder.estimator.save());
}

TEST(ChosenMesh, HasRoomForWhatIsFixedToTheTether)
{
  Config config = testConfig();
  config.accuracy = 0.1;
  config.elements = 60;
  for (int i = 0; i < 20; ++i)
    config.layout.attachments.push_back({"clamp", 0.5 + 0.5 * i, 0.5, 1e-4, 0.0});
  EstimatorFixture feeder(config);
  feeder.vehicle = {70.0, 0.0, -70.0};
  EXPECT_NO_THROW(feeder.run(2.0));
  EXPECT_TRUE(feeder.estimator.isRunning()) << describe(feeder.estimator.estimate().reason);
}

TEST(ChosenMesh, StaysAsGivenWhereTheTrialsTellNothing)
{
  const core::MeshSelection mesh =
      core::selectMesh([](int) -> core::CableModel { throw std::invalid_argument("never"); },
                       {{0, 0, 0}, {60, 0, -70}, {0, 0, 0}}, 1e-3, core::StepperOptions(), 50);
  EXPECT_EQ(mesh.elements, 50);
  EXPECT_EQ(mesh.step, core::StepperOptions().step);
  EXPECT_FALSE(mesh.converged);
}

TEST(EstimatorArchive, TakesOverAMeshThatWasChosen)
{
  Config config = testConfig();
  config.accuracy = 3e-3;
  EstimatorFixture feeder(config);
  feeder.run(2.0);
  ASSERT_TRUE(feeder.estimator.isRunning());
  EXPECT_NE(feeder.estimator.simulation().model.elements(), config.elements);
  EstimatorFixture other(config);
  ASSERT_TRUE(other.estimator.restore(feeder.estimator.save()));
  EXPECT_EQ(other.estimator.simulation().model.elements(), feeder.estimator.simulation().model.elements());
  other.t = feeder.t;
  EXPECT_EQ(other.run(1.0).vessel_tension, feeder.run(1.0).vessel_tension);
}

TEST(EstimatorArchive, GoesOnAfterALongQuietTime)
{
  // Held ends in smooth motion: nothing that steps carry along may grow.
  EstimatorFixture feeder;
  for (int k = 0; k < 2000; ++k)
  {
    feeder.vessel.z() = 1.0 + 0.2 * std::sin(0.05 * k);
    feeder.run(0.05);
  }
  ASSERT_TRUE(feeder.estimator.simulation().state.allFinite());
  TetherEstimator other(testConfig());
  EXPECT_TRUE(other.restore(feeder.estimator.save()));
}

TEST(EstimatorArchive, GoesOnBitForBitWithFittingsOnAWinch)
{
  Config config = testConfig();
  core::CableSection heavy;
  heavy.from = 40.0;
  heavy.to = 100.0;
  heavy.properties = config.tether;
  heavy.properties.mass_per_length = 0.3;
  config.layout.sections.push_back(heavy);
  config.layout.attachments.push_back({"float", 70.0, 2.0, 0.004, 0.01});
  EstimatorFixture feeder(config);
  double length = 100.0;
  drive(feeder, 20.0, length);
  ASSERT_TRUE(feeder.estimator.isRunning()) << describe(feeder.estimator.estimate().reason);
  EstimatorFixture other(config);
  ASSERT_TRUE(other.estimator.restore(feeder.estimator.save()));
  other.t = feeder.t;
  double other_length = length;
  drive(feeder, 2.0, length);
  drive(other, 2.0, other_length);
  EXPECT_EQ(other.estimator.save(), feeder.estimator.save());
}

TEST(EstimatorArchive, RefusesAStateOfAnotherConfiguration)
{
  Config with = testConfig();
  with.environment.seabed = core::Seabed();
  with.environment.seabed->depth = 90.0;
  EstimatorFixture feeder(with);
  feeder.run(1.0);
  ASSERT_TRUE(feeder.estimator.setDepth(95.0));
  feeder.run(0.5);
  const std::vector<std::uint8_t> saved = feeder.estimator.save();
  TetherEstimator same(with);
  EXPECT_TRUE(same.restore(saved));
  TetherEstimator without(testConfig());
  EXPECT_FALSE(without.restore(saved));
  Config heavier = with;
  heavier.tether.mass_per_length *= 1.1;
  TetherEstimator other(heavier);
  EXPECT_FALSE(other.restore(saved));
}

TEST(EstimatorArchive, RefusesWhatIsNoSuchState)
{
  EstimatorFixture feeder(fullConfig());
  double length = 100.0;
  drive(feeder, 2.0, length);
  const std::vector<std::uint8_t> saved = feeder.estimator.save();
  EstimatorFixture other(fullConfig());
  const std::vector<std::uint8_t> untouched = other.estimator.save();
  EXPECT_FALSE(other.estimator.restore({}));
  for (std::size_t size = 0; size < saved.size(); size += 997)
    EXPECT_FALSE(other.estimator.restore({saved.begin(), saved.begin() + size})) << size;
  std::vector<std::uint8_t> longer = saved;
  longer.push_back(0);
  EXPECT_FALSE(other.estimator.restore(longer));
  EXPECT_EQ(other.estimator.save(), untouched) << "nothing changed";

  Config different = fullConfig();
  different.tether.length = 120.0;
  TetherEstimator third(different);
  EXPECT_FALSE(third.restore(saved)) << "a state of another tether";
}

TEST(EstimatorArchive, RefusesDamagedBytes)
{
  EstimatorFixture feeder(fullConfig());
  double length = 100.0;
  drive(feeder, 2.0, length);
  const std::vector<std::uint8_t> saved = feeder.estimator.save();
  std::mt19937 random(3);
  for (int trial = 0; trial < 100; ++trial)
  {
    std::vector<std::uint8_t> damaged = saved;
    damaged[random() % damaged.size()] ^= static_cast<std::uint8_t>(1u << random() % 8);
    TetherEstimator other(fullConfig());
    EXPECT_FALSE(other.restore(damaged));
  }
}

TEST(EstimatorArchive, SurvivesDamageThatTheChecksumCovers)
{
  EstimatorFixture feeder(fullConfig());
  double length = 100.0;
  drive(feeder, 2.0, length);
  std::vector<std::uint8_t> content = feeder.estimator.save();
  ASSERT_TRUE(core::verifyChecksum(content));
  std::mt19937 random(3);
  for (int trial = 0; trial < 300; ++trial)
  {
    std::vector<std::uint8_t> damaged = content;
    for (int flip = 0; flip < 3; ++flip)
      damaged[random() % damaged.size()] ^= static_cast<std::uint8_t>(1u << random() % 8);
    core::appendChecksum(damaged);
    TetherEstimator other(fullConfig());
    if (!other.restore(damaged))
      continue;
    const TetherEstimate& e = other.tick(feeder.t + 0.05);
    EXPECT_TRUE(e.status == Status::INVALID || std::isfinite(e.vessel_tension));
  }
}

TEST(Determinism, ManyTethersInManyThreadsGiveTheSameBytes)
{
  const std::vector<std::uint8_t> alone = history(4.0);
  std::vector<std::vector<std::uint8_t>> together(6);
  std::vector<std::thread> threads;
  for (std::vector<std::uint8_t>& bytes : together)
    threads.emplace_back([&bytes] { bytes = history(4.0); });
  for (std::thread& thread : threads)
    thread.join();
  for (const std::vector<std::uint8_t>& bytes : together)
    EXPECT_EQ(bytes, alone);
}

}  // namespace tether_monitor::monitor
