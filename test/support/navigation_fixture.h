#pragma once

#include <cmath>
#include <random>

#include "support/estimator_fixture.h"

namespace tether_monitor::monitor
{
using core::Vector3;

inline Config observedConfig()
{
  Config c = testConfig();
  c.elements = 10;
  c.tether.working_load = 5000.0;
  c.tether.breaking_load = 20000.0;
  c.vehicle_mode = VehicleMode::OBSERVED;
  c.vehicle_body.mass = 400.0;
  c.vehicle_body.volume = 0.35;
  c.vehicle_body.inertia = {40.0, 60.0, 60.0};
  c.vehicle_body.drag_area = {0.6, 0.8, 0.8};
  c.vehicle_body.added_mass = Vector3::Constant(200.0);
  c.vehicle_body.rotational_drag = Vector3::Constant(100.0);
  c.navigation.position_stddev = 0.2;
  c.vessel.position_stddev = 0.02;
  c.invalid_timeout = 20.0;
  c.uncertainty.members = 64;
  return c;
}

// A vessel at rest over a vehicle that sways under it; measurements with the noise of a seed.
class NavigationFixture
{
 public:
  explicit NavigationFixture(const Config& config = observedConfig()) : estimator(config) {}

  Vector3 vehicleAt(double time) const { return {aside + 0.5 * std::sin(0.05 * time), 0.0, depth}; }

  const TetherEstimate& run(double duration)
  {
    for (const double end = t + duration; t < end - 1e-9;)
    {
      t += 0.05;
      ++ticks;
      if (ticks % 4 == 0)
        estimator.addVessel(PoseMeasurement{t, Vector3(vessel + 0.02 * noise())});
      if (ticks % 20 == 0)
        fix(t - lateness);
      estimator.tick(t);
    }
    return estimator.estimate();
  }
  Rejection fix(double when)
  {
    PoseMeasurement pose{when, Vector3(vehicleAt(when) + 0.2 * noise())};
    last_fix = pose;
    return vehicle_alive ? estimator.addVehicle(pose) : Rejection::NONE;
  }
  Vector3 noise()
  {
    const double x = normal(generator), y = normal(generator), z = normal(generator);
    return {x, y, z};
  }

  TetherEstimator estimator;
  double t = 0.0, lateness = 0.0;
  int ticks = 0;
  bool vehicle_alive = true;
  double depth = -99.05;  // where it hangs
  double aside = 0.0;
  Vector3 vessel{0.0, 0.0, 1.0};
  PoseMeasurement last_fix;
  std::mt19937 generator{7};
  std::normal_distribution<double> normal;
};
}  // namespace tether_monitor::monitor
