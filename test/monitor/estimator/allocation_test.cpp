// Counts what the stepping path takes from the heap, by standing in for malloc in this executable: operator new
// and Eigen come through there.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "support/estimator_fixture.h"

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#define COUNTS_ALLOCATIONS 1
namespace
{
thread_local long allocations = 0;
}

extern "C"
{
  void* __libc_malloc(std::size_t);
  void* __libc_calloc(std::size_t, std::size_t);
  void* __libc_realloc(void*, std::size_t);
  void* __libc_memalign(std::size_t, std::size_t);

  void* malloc(std::size_t size)
  {
    ++allocations;
    return __libc_malloc(size);
  }
  void* calloc(std::size_t count, std::size_t size)
  {
    ++allocations;
    return __libc_calloc(count, size);
  }
  void* realloc(void* memory, std::size_t size)
  {
    ++allocations;
    return __libc_realloc(memory, size);
  }
  void* aligned_alloc(std::size_t alignment, std::size_t size)
  {
    ++allocations;
    return __libc_memalign(alignment, size);
  }
  int posix_memalign(void** memory, std::size_t alignment, std::size_t size)
  {
    ++allocations;
    *memory = __libc_memalign(alignment, size);
    return *memory ? 0 : 12;
  }
}
#endif

#ifdef COUNTS_ALLOCATIONS
namespace tether_monitor::monitor
{
TEST(Allocation, TheCounterCounts)
{
  const long before = allocations;
  const std::vector<double> some(10);
  EXPECT_GT(allocations, before);
  const Eigen::MatrixXd other = Eigen::MatrixXd::Zero(some.size(), 3);
  EXPECT_GT(allocations, before + 1) << other.rows();
}

TEST(Allocation, ATickTakesNothingFromTheHeapAfterTheStart)
{
  EstimatorFixture feeder;
  ASSERT_EQ(feeder.run(2.0).status, Status::OK) << "precondition";
  feeder.vehicle_velocity = {0.15, 0.1, -0.1};  // taut, alarms and all
  const long before = allocations;
  feeder.run(60.0);
  EXPECT_EQ(allocations - before, 0);
  EXPECT_TRUE(feeder.estimator.overTension()) << "it did something";
}

TEST(Allocation, NorDoesAnObservedVehicle)
{
  Config config = testConfig();
  config.vehicle_mode = VehicleMode::OBSERVED;
  config.vehicle_body = smallVehicle();
  TetherEstimator estimator(config);
  const auto run = [&](int from, int to)
  {
    for (int i = from; i < to; ++i)
    {
      const double t = 0.05 * i, wave = std::sin(0.7 * t);
      estimator.addVessel(PoseMeasurement{t, core::Vector3(0.0, 0.0, 1.0 + 0.3 * wave)});
      if (i % 5 == 0)  // satellites a little late
        estimator.addVessel(
            PoseMeasurement{t - 0.07, core::Vector3(0.0, 0.0, 1.0 + 0.3 * std::sin(0.7 * (t - 0.07)))});
      if (i % 20 == 0)  // a position a second late, some far off
        estimator.addVehicle(
            PoseMeasurement{t - 1.0, core::Vector3(i % 200 == 0 ? 30.0 : 0.3 * wave, 0.01 * wave, -98.9)});
      estimator.tick(t);
    }
  };
  run(0, 600);
  ASSERT_NE(estimator.estimate().status, Status::INVALID) << "precondition";
  const long before = allocations;
  run(600, 3000);
  EXPECT_EQ(allocations - before, 0);
  EXPECT_GT(estimator.vehicle().ensemble()->innovations().refused, 3);
}

TEST(Allocation, NorDoBodiesSurfacesWavesAndTheWinch)
{
  Config config = testConfig();
  config.elements = 60;
  config.vehicle_mode = VehicleMode::FREE;
  config.vehicle_body = smallVehicle();
  config.drag_amplification = 1.5;
  config.environment.waves.components = {{0.5, 60.0, 0.0, 0.0}};
  config.environment.wind = {5.0, 0.0, 0.0};
  config.environment.seabed = core::Seabed();
  config.environment.seabed->depth = 80.0;
  core::Obstacle pile, buoy;
  pile.shape = core::ObstacleShape::CYLINDER;
  pile.size = {0.5, 200.0, 0.0};
  pile.position = {0.0, -0.5, -40.0};
  pile.friction = 0.3;
  buoy.size = {1.0, 0.0, 0.0};
  buoy.position = {-1.0, 0.0, -60.0};
  buoy.mass = 50.0;
  config.environment.obstacles = {pile, buoy};
  EstimatorFixture feeder(config);
  feeder.vehicle_alive = false;
  double length = 100.0;
  const auto pay = [&](double duration, double rate)
  {
    for (int k = 0; k < static_cast<int>(std::round(duration / 0.1)); ++k)
    {
      length += 0.1 * rate;
      feeder.estimator.addPayout(feeder.t + 0.1, length, rate);
      feeder.run(0.1);
    }
  };
  pay(1.0, 0.0);
  const TetherEstimate& e = feeder.estimator.estimate();
  ASSERT_NE(e.status, Status::INVALID) << describe(e.reason);
  const long before = allocations;
  pay(10.0, 0.02);
  EXPECT_EQ(allocations - before, 0);
  ASSERT_NE(e.status, Status::INVALID) << describe(e.reason);
  EXPECT_GT(e.seabed_contact_length, 0.0) << "precondition: it lies";
  EXPECT_GT(e.contact.obstacles[0].total, 0.0) << "precondition: it leans on the pile";
}

}  // namespace tether_monitor::monitor
#endif
