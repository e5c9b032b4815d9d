#include "tether_monitor/simulation/simulation_config.h"

#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::simulation
{
namespace
{
constexpr double FASTEST_WINCH = 3.0;  // [m/s]

void checkSensor(const std::string& prefix, const SensorModel& sensor, std::vector<std::string>& all)
{
  core::BoundsCheck check(prefix);
  check.within("rate", sensor.rate, 0.01, 1000.0, "Hz");
  check.notNegative("position_stddev", sensor.position_stddev, "m");
  check.notNegative("velocity_stddev", sensor.velocity_stddev, "m/s");
  check.notNegative("orientation_stddev", sensor.orientation_stddev, "rad");
  check.within("dropout", sensor.dropout, 0.0, 1.0, "[-]");
  check.within("outlier", sensor.outlier, 0.0, 1.0, "[-]");
  check.notNegative("outlier_size", sensor.outlier_size, "m");
  check.check(sensor.outlier_min >= 0.0 && sensor.outlier_min <= sensor.outlier_size, "outlier_min",
              sensor.outlier_min, ">= 0 and <= outlier_size, in m");
  check.notNegative("latency", sensor.latency, "s");
  check.check(sensor.gap_to >= sensor.gap_from, "gap[1]", sensor.gap_to, ">= gap[0], in s");
  all.insert(all.end(), check.problems().begin(), check.problems().end());
}

void checkWaypoints(const std::string& prefix, const std::vector<Waypoint>& waypoints, double acceptance,
                    std::vector<std::string>& all)
{
  core::BoundsCheck check(prefix);
  check.positive("acceptance", acceptance, "m");
  for (std::size_t i = 0; i < waypoints.size(); ++i)
  {
    const std::string name = "waypoints[" + std::to_string(i) + "].";
    check.finite((name + "position (norm)").c_str(), waypoints[i].position.norm(), "m");
    check.notNegative((name + "speed").c_str(), waypoints[i].speed, "m/s");
  }
  all.insert(all.end(), check.problems().begin(), check.problems().end());
}
}  // namespace

std::vector<std::string> validate(const SimulationConfig& c)
{
  std::vector<std::string> all = validate(c.vessel.ship);
  const std::vector<std::string> body = core::validate(c.vehicle.body, "simulation.vehicle.");
  all.insert(all.end(), body.begin(), body.end());
  checkWaypoints("simulation.vessel.", c.vessel.waypoints, c.vessel.acceptance, all);
  checkWaypoints("simulation.vehicle.", c.vehicle.waypoints, c.vehicle.acceptance, all);
  checkSensor("simulation.vessel.sensor.", c.vessel_sensor, all);
  checkSensor("simulation.vehicle.sensor.", c.vehicle_sensor, all);
  core::BoundsCheck check("simulation.");
  check.within("vessel.heave_sensor.rate", c.heave.rate, 0.0, 1000.0, "Hz");
  check.notNegative("vessel.heave_sensor.stddev", c.heave.stddev, "m");
  check.notNegative("vessel.speed", c.vessel.speed, "m/s");
  check.finite("vessel.heading", c.vessel.heading, "rad");
  check.finite("vessel.start (norm)", c.vessel.start.norm(), "m");
  check.finite("vehicle.start (norm)", c.vehicle.start.norm(), "m");
  check.finite("vehicle.thrust (norm)", c.vehicle.thrust.norm(), "N");
  check.positive("vehicle.largest_thrust", c.vehicle.largest_thrust, "N");
  check.positive("winch_acceleration", c.winch_acceleration, "m/s^2");
  check.check(std::isfinite(c.squall.from) && std::isfinite(c.squall.to) && c.squall.wind.norm() < 100.0,
              "squall.wind (norm)", c.squall.wind.norm(), "< 100 m/s, its times finite");
  check.within("payout_rate", c.payout_rate, 0.0, 1000.0, "Hz");
  check.notNegative("payout_stddev", c.payout_stddev, "m");
  check.within("speed", c.speed, 0.01, 1000.0, "[-]");
  check.check(c.clock || !c.lockstep, "lockstep", c.lockstep, "false without clock: true");
  for (std::size_t i = 0; i < c.winch.size(); ++i)
  {
    const std::string name = "winch[" + std::to_string(i) + "].";
    check.check(std::isfinite(c.winch[i].time) && (i == 0 || c.winch[i].time > c.winch[i - 1].time),
                (name + "time").c_str(), c.winch[i].time, "later than that of the order before, in s");
    check.positive((name + "length").c_str(), c.winch[i].length, "m");
    check.check(c.winch[i].rate > 0.0 && c.winch[i].rate <= FASTEST_WINCH, (name + "rate").c_str(),
                c.winch[i].rate, "> 0 and <= 3 m/s");
  }
  all.insert(all.end(), check.problems().begin(), check.problems().end());
  return all;
}

}  // namespace tether_monitor::simulation
