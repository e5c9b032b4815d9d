#include "tether_monitor/monitor/estimator/obstacle_tracker.h"

#include <gtest/gtest.h>

#include "support/ball.h"
#include "support/estimator_fixture.h"
#include "support/matrix_compare.h"

namespace tether_monitor::monitor
{
namespace
{
using core::Vector3;

core::Obstacle drifting(const std::string& name)
{
  core::Obstacle obstacle = core::ball(2.0, Vector3(50.0, 5.0, -30.0));
  obstacle.name = name;
  obstacle.velocity = {1.0, 0.0, -0.5};
  return obstacle;
}

// A tether along x in 30 m of depth that is in motion at 12 s.
void start(CableSimulation& simulation)
{
  core::NodeField shape(21);
  for (int i = 0; i <= 20; ++i)
    shape[i] << 5.0 * i, 0.0, -30.0, 1.0, 0.0, 0.0;
  simulation.state = core::CableState(12.0, shape, Vector3::Zero());
  core::initializeContact(simulation.model, simulation.state);
}

class ObstacleTrackerTest : public ::testing::Test
{
 protected:
  CableSimulation simulation{testConfig()};
  std::unique_ptr<VehicleEnd> vehicle = makeVehicleEnd(testConfig());
  ObstacleTracker tracker;
};
}  // namespace

TEST_F(ObstacleTrackerTest, AnObstacleGoesOnFromWhereTheMessageHadIt)
{
  ASSERT_TRUE(tracker.set(10.0, {drifting("buoy")}, false, simulation, *vehicle).empty());
  const std::vector<core::Obstacle> later = tracker.at(14.0, simulation);
  ASSERT_EQ(later.size(), 1u);
  EXPECT_TRUE(matricesNear(later[0].position, Vector3(54.0, 5.0, -32.0), 1e-12));
  EXPECT_EQ(later[0].velocity, Vector3(1.0, 0.0, -0.5));
  EXPECT_TRUE(matricesNear(tracker.at(10.0, simulation)[0].position, Vector3(50.0, 5.0, -30.0), 1e-12));
}

TEST_F(ObstacleTrackerTest, FaultsAreNamedAndChangeNothing)
{
  ASSERT_TRUE(tracker.set(10.0, {drifting("buoy")}, false, simulation, *vehicle).empty());
  core::Obstacle bad = drifting("bad");
  bad.size[0] = 0.0;
  const auto faults = tracker.set(11.0, {drifting("good"), bad}, false, simulation, *vehicle);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].find("obstacles[1].size[0]"), std::string::npos) << faults[0];
  const std::vector<core::Obstacle> kept = tracker.at(14.0, simulation);
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].name, "buoy");
  EXPECT_TRUE(matricesNear(kept[0].position, Vector3(54.0, 5.0, -32.0), 1e-12));
}

TEST_F(ObstacleTrackerTest, ATetherInMotionGetsThePlacesOfItsOwnTime)
{
  tracker.set(12.0, {drifting("buoy")}, false, simulation, *vehicle);
  start(simulation);
  ASSERT_TRUE(tracker.set(10.0, {drifting("buoy")}, true, simulation, *vehicle).empty());
  ASSERT_EQ(simulation.state.obstacles.size(), 1u);
  EXPECT_TRUE(matricesNear(simulation.state.obstacles[0].position, Vector3(52.0, 5.0, -31.0), 1e-12));
  EXPECT_EQ(simulation.state.obstacles[0].velocity, Vector3(1.0, 0.0, -0.5));
  EXPECT_TRUE(matricesNear(tracker.at(14.0, simulation)[0].position, Vector3(54.0, 5.0, -32.0), 1e-12));
}

TEST_F(ObstacleTrackerTest, FrictionStaysOnAnObstacleOfTheSameName)
{
  tracker.set(12.0, {drifting("buoy")}, false, simulation, *vehicle);
  start(simulation);
  ASSERT_FALSE(simulation.state.contact.obstacle.empty()) << "precondition";
  const Vector3 mark(0.1, 0.2, 0.3);
  simulation.state.contact.obstacle[5] = mark;
  tracker.set(12.0, {drifting("buoy")}, true, simulation, *vehicle);
  EXPECT_EQ(simulation.state.contact.obstacle[5], mark);
  tracker.set(12.0, {drifting("another")}, true, simulation, *vehicle);
  EXPECT_NE(simulation.state.contact.obstacle[5], mark);
  EXPECT_EQ(tracker.at(12.0, simulation)[0].name, "another");
}

TEST_F(ObstacleTrackerTest, AnObstacleThatIsPushedIsWhereItWasLast)
{
  core::Obstacle buoy = drifting("buoy");
  buoy.mass = 20.0;
  tracker.set(12.0, {buoy}, false, simulation, *vehicle);
  start(simulation);
  tracker.begin(12.0);
  simulation.state.time = 13.0;
  simulation.state.obstacles[0].position = Vector3(48.0, 6.0, -29.0);
  EXPECT_TRUE(matricesNear(tracker.at(13.5, simulation)[0].position, Vector3(48.0, 6.0, -29.0), 1e-12));
}
}  // namespace tether_monitor::monitor
