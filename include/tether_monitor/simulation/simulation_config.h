#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/core/bodies/rigid_body.h"
#include "tether_monitor/simulation/box_ship.h"

namespace tether_monitor::simulation
{
/// A place to go to and the speed until there.
struct Waypoint
{
  core::Vector3 position = core::Vector3::Zero();  ///< [m]; of a vessel, x and y count.
  double speed = 1.0;                              ///< [m/s], >= 0.
};

/// The simulated vessel and where it goes.
struct VesselPlan
{
  ShipProperties ship;
  core::Vector3 start = core::Vector3::Zero();  ///< [m]; z is not used.
  double heading = 0.0;                         ///< at the start, from x towards y [rad].
  double speed = 0.0;                           ///< at the start [m/s].
  std::vector<Waypoint> waypoints;              ///< in order; then it stops at the last.
  double acceptance = 15.0;                     ///< distance at which a waypoint is reached [m], > 0.
};

/// What drives the simulated vehicle.
enum class VehicleControl
{
  NONE,             ///< towed: only its constant force.
  THRUST,           ///< a constant thrust in its own axes.
  STATION_KEEPING,  ///< a pilot who takes it from waypoint to waypoint and keeps it there.
  EXTERNAL          ///< commands from outside; it begins as with STATION_KEEPING, with what keeps it there.
};

/// The simulated vehicle and what it does.
struct VehiclePlan
{
  core::RigidBody body;
  VehicleControl control = VehicleControl::NONE;
  core::Vector3 start =
      core::Vector3::Zero();  ///< [m], with STATION_KEEPING and EXTERNAL; else it hangs where the tether lets it.
  core::Vector3 thrust = core::Vector3::Zero();  ///< [N], body axes, with THRUST.
  double largest_thrust = 1000.0;                ///< [N], likewise, > 0.
  std::vector<Waypoint> waypoints;               ///< with STATION_KEEPING.
  double acceptance = 1.0;                       ///< [m], > 0.
};

/// Another wind for a time.
struct Squall
{
  double from = 0.0, to = 0.0;                 ///< [s] since the start; to <= from: there is none.
  core::Vector3 wind = core::Vector3::Zero();  ///< [m/s]
};

/// From `time` on the winch goes to `length` at `rate`.
struct WinchCommand
{
  double time = 0.0;    ///< [s] since the start, increasing.
  double length = 0.0;  ///< [m], > 0.
  double rate = 0.0;    ///< [m/s], 0 < rate <= 3.
};

/// A sensor of a body: how often and how well it measures.
struct SensorModel
{
  double rate = 20.0;               ///< [Hz], > 0.
  double position_stddev = 0.0;     ///< [m], >= 0.
  double velocity_stddev = 0.0;     ///< [m/s], >= 0.
  double orientation_stddev = 0.0;  ///< [rad], >= 0.
  bool velocity = true;             ///< whether velocities are measured too.
  double dropout = 0.0;             ///< share of measurements that get lost [-], 0..1.
  double outlier = 0.0;             ///< share of positions that are `outlier_size` off [-], 0..1.
  double outlier_size = 10.0;       ///< [m], >= 0: the largest.
  double outlier_min = 10.0;        ///< the smallest, evenly distributed in between [m], 0..outlier_size.
  double latency = 0.0;  ///< [s] from measurement to message, >= 0; the stamp is that of the measurement.
  double gap_from = 0.0, gap_to = 0.0;  ///< [s] since the start: nothing is measured in between.
};

/// A motion sensor that measures the height of the vessel's reference point, between the satellite positions.
struct HeavePlan
{
  double rate = 0.0;    ///< [Hz]; 0: there is none.
  double stddev = 0.0;  ///< [m], >= 0.
};

/// The key `simulation` of a scenario.
struct SimulationConfig
{
  VesselPlan vessel;
  VehiclePlan vehicle;
  std::vector<WinchCommand> winch;
  double winch_acceleration = 0.2;  ///< [m/s^2], > 0.
  bool winch_is_commanded = false;  ///< the winch also obeys rates from outside.
  Squall squall;
  SensorModel vessel_sensor, vehicle_sensor;
  HeavePlan heave;             ///< with it, the vessel's measurements are published as odometry with covariance.
  double payout_rate = 10.0;   ///< reports of the winch per second [Hz]; 0: none.
  double payout_stddev = 0.0;  ///< [m], >= 0.
  bool publish_obstacles = false;  ///< tell the monitor of the obstacles live.
  unsigned seed = 1;
  bool clock = false;     ///< the simulation owns the clock.
  double speed = 1.0;     ///< simulated seconds per second then, at most, > 0.
  bool lockstep = false;  ///< time waits then for every cycle of the monitor, at most ten seconds (one, before
                          ///< its first), and for those that command, at most one.
};

/// Every bound of SimulationConfig that `config` violates, one sentence each, named as in the parameter tree.
std::vector<std::string> validate(const SimulationConfig& config);

}  // namespace tether_monitor::simulation
