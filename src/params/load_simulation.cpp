#include "tether_monitor/params/load_simulation.h"

#include "tether_monitor/params/load_bodies.h"
#include "tether_monitor/params/load_config.h"
#include "tether_monitor/params/parameter_reader.h"

namespace tether_monitor::params
{
namespace
{
using simulation::SensorModel;
using simulation::SimulationConfig;
using simulation::VehicleControl;
using simulation::Waypoint;

SensorModel loadSensor(ParameterReader in)
{
  SensorModel sensor;
  sensor.rate = in.number("rate", sensor.rate);
  sensor.position_stddev = in.number("position_stddev", sensor.position_stddev);
  sensor.velocity_stddev = in.number("velocity_stddev", sensor.velocity_stddev);
  sensor.orientation_stddev = in.number("orientation_stddev", sensor.orientation_stddev);
  sensor.velocity = in.boolean("velocity", sensor.velocity);
  sensor.dropout = in.number("dropout", sensor.dropout);
  sensor.outlier = in.number("outlier", sensor.outlier);
  sensor.outlier_size = in.number("outlier_size", sensor.outlier_size);
  sensor.outlier_min = in.number("outlier_min", sensor.outlier_size);
  sensor.latency = in.number("latency", sensor.latency);
  const core::Vector3 gap = in.vector2("gap", core::Vector3::Zero());
  sensor.gap_from = gap.x();
  sensor.gap_to = gap.y();
  in.finish();
  return sensor;
}

std::vector<Waypoint> loadWaypoints(ParameterReader& in, bool on_surface)
{
  std::vector<Waypoint> waypoints;
  for (ParameterReader& entry : in.list("waypoints"))
  {
    Waypoint waypoint;
    waypoint.position = on_surface ? entry.vector2("position") : entry.vector("position");
    waypoint.speed = entry.number("speed", waypoint.speed);
    entry.finish();
    waypoints.push_back(waypoint);
  }
  return waypoints;
}

void loadVessel(ParameterReader in, SimulationConfig& config)
{
  simulation::VesselPlan& plan = config.vessel;
  plan.ship.length = in.number("length", plan.ship.length);
  plan.ship.beam = in.number("beam", plan.ship.beam);
  plan.ship.draft = in.number("draft", plan.ship.draft);
  plan.ship.height = in.number("height", plan.ship.height);
  plan.start = in.vector2("start", plan.start);
  plan.heading = in.number("heading", plan.heading);
  plan.speed = in.number("speed", plan.speed);
  plan.acceptance = in.number("acceptance", plan.acceptance);
  plan.waypoints = loadWaypoints(in, true);
  config.vessel_sensor = loadSensor(in.child("sensor"));
  ParameterReader heave = in.child("heave_sensor");
  config.heave.rate = heave.number("rate", config.heave.rate);
  config.heave.stddev = heave.number("stddev", config.heave.stddev);
  heave.finish();
  in.finish();
}

void loadVehicle(ParameterReader in, SimulationConfig& config)
{
  simulation::VehiclePlan& plan = config.vehicle;
  plan.body = loadRigidBody(in);
  const std::string control = in.text("control", "none");
  if (control == "thrust")
    plan.control = VehicleControl::THRUST;
  else if (control == "station_keeping")
    plan.control = VehicleControl::STATION_KEEPING;
  else if (control == "external")
    plan.control = VehicleControl::EXTERNAL;
  else if (control != "none")
    in.addError("control", " = '" + control + "' (must be none, thrust, station_keeping or external)");
  if (plan.control == VehicleControl::STATION_KEEPING || plan.control == VehicleControl::EXTERNAL)
    plan.start = in.vector("start");
  plan.thrust = in.vector("thrust", plan.thrust);
  plan.largest_thrust = in.number("largest_thrust", plan.largest_thrust);
  plan.acceptance = in.number("acceptance", plan.acceptance);
  plan.waypoints = loadWaypoints(in, false);
  config.vehicle_sensor = loadSensor(in.child("sensor"));
  in.finish();
}
}  // namespace

SimulationConfig loadSimulation(const Value& tree, const std::string& where)
{
  ParameterReader root(tree);
  SimulationConfig config;
  ParameterReader in = root.child("simulation");
  loadVessel(in.child("vessel"), config);
  loadVehicle(in.child("vehicle"), config);
  for (ParameterReader& entry : in.list("winch"))
  {
    config.winch.push_back({entry.number("time"), entry.number("length"), entry.number("rate")});
    entry.finish();
  }
  config.winch_acceleration = in.number("winch_acceleration", config.winch_acceleration);
  config.winch_is_commanded = in.boolean("winch_command", config.winch_is_commanded);
  ParameterReader squall = in.child("squall");
  config.squall.from = squall.number("from", config.squall.from);
  config.squall.to = squall.number("to", config.squall.to);
  config.squall.wind = squall.vector("wind", config.squall.wind);
  squall.finish();
  config.payout_rate = in.number("payout_rate", config.payout_rate);
  config.payout_stddev = in.number("payout_stddev", config.payout_stddev);
  config.publish_obstacles = in.boolean("publish_obstacles", config.publish_obstacles);
  config.seed = static_cast<unsigned>(in.integer("seed", static_cast<int>(config.seed)));
  config.clock = in.boolean("clock", config.clock);
  config.speed = in.number("speed", config.speed);
  config.lockstep = in.boolean("lockstep", config.lockstep);
  in.finish();
  if (root.errors().empty())
    root.addErrors(simulation::validate(config));
  if (!root.errors().empty())
    throw ParameterError(where, root.errors());
  return config;
}

}  // namespace tether_monitor::params
