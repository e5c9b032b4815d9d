#pragma once

#include "tether_monitor/monitor/estimator/tether_estimator.h"

namespace tether_monitor::monitor
{
/// A 100 m tether in 20 elements, monitored with short delays.
inline Config testConfig()
{
  Config c;
  c.tether.length = 100.0;
  c.tether.diameter = 0.012;
  c.tether.mass_per_length = 0.2;
  c.tether.axial_stiffness = 1.0e6;
  c.tether.drag_normal = 1.35;
  c.tether.drag_tangential = 0.04;
  c.tether.working_load = 1000.0;
  c.tether.breaking_load = 5000.0;
  c.elements = 20;
  return c;
}

/// The same in 10 elements.
inline Config coarseConfig()
{
  Config c = testConfig();
  c.elements = 10;
  return c;
}

/// A simulated vehicle that hangs from it.
inline core::RigidBody smallVehicle()
{
  core::RigidBody body;
  body.mass = 150.0;
  body.volume = 0.1;
  body.inertia = {5.0, 20.0, 20.0};
  body.drag_area = {0.1, 0.4, 0.4};
  return body;
}

/// Feeds level poses to both tracks and ticks, at 20 Hz of a clock that it owns.
class EstimatorFixture
{
 public:
  explicit EstimatorFixture(const Config& config = testConfig()) : estimator(config) {}

  const TetherEstimate& run(double duration)
  {
    for (const double end = t + duration; t < end - 1e-9;)
    {
      t += 0.05;
      if (vessel_alive)
        estimator.addVessel(PoseMeasurement{t, vessel, Eigen::Quaterniond::Identity()});
      if (vehicle_alive)
      {
        vehicle += 0.05 * vehicle_velocity;
        estimator.addVehicle(PoseMeasurement{t, vehicle, Eigen::Quaterniond::Identity()});
      }
      estimator.tick(t);
    }
    return estimator.estimate();
  }

  TetherEstimator estimator;
  double t = 100.0;
  core::Vector3 vessel{0.0, 0.0, 1.0};
  core::Vector3 vehicle{60.0, 0.0, -70.0};
  core::Vector3 vehicle_velocity = core::Vector3::Zero();
  bool vessel_alive = true;
  bool vehicle_alive = true;
};

}  // namespace tether_monitor::monitor
