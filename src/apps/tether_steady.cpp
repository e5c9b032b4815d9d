#include <cmath>
#include <iostream>
#include <sstream>

#include "command_line.h"
#include "tether_monitor/core/base/bounds_check.h"
#include "tether_monitor/monitor/config/suspicious_values.h"
#include "tether_monitor/params/load_config.h"
#include "tether_monitor/replay/result_files.h"
#include "tether_monitor/replay/steady_state_run.h"

namespace
{
using tether_monitor::core::Vector3;

constexpr int NO_STEADY_STATE = 2;

Vector3 parseVector(const std::string& name, const std::string& text)
{
  Vector3 v;
  std::istringstream in(text);
  char comma1 = 0, comma2 = 0;
  if (!(in >> v.x() >> comma1 >> v.y() >> comma2 >> v.z()) || comma1 != ',' || comma2 != ',' ||
      !(in >> std::ws).eof() || !v.allFinite())
    throw std::runtime_error(name + " = '" + text + "' is not three numbers like 0,0,-5");
  return v;
}

struct Arguments
{
  std::string config, out;
  std::string vessel_position = "0,0,0";
  std::string vehicle_position;
  std::string vessel_velocity = "0,0,0";
  int modes = 0;
  bool quiet = false;
};

void printSummary(const tether_monitor::replay::SteadyState& steady, const Arguments& arguments)
{
  const tether_monitor::monitor::TetherEstimate& estimate = steady.estimate;
  std::cout << describe(estimate.status) << " "
            << (estimate.reason == tether_monitor::monitor::Reason::NONE ? "" : describe(estimate.reason)) << " "
            << tether_monitor::monitor::advice(estimate.reason) << "\ntension at the vessel end "
            << estimate.vessel_tension << " N, at the vehicle end " << estimate.vehicle_tension << " N, largest "
            << estimate.max_tension << " N at s = " << estimate.max_tension_s << " m\n";
  if (estimate.seabed_contact_length > 0.0)
    std::cout << estimate.seabed_contact_length << " m lie on the seabed, from s = " << estimate.touchdown_s
              << " m on\n";
  const tether_monitor::core::VortexShedding& shedding = steady.vortex_shedding;
  if (shedding.length > 0.0)
    std::cout << "vortices may shake " << shedding.length << " m of it at " << shedding.lowest_frequency << " to "
              << shedding.highest_frequency << " Hz; its first transverse frequency is some "
              << shedding.fundamental_frequency << " Hz\n";
  if (arguments.modes > static_cast<int>(steady.modes.size()))
    std::cout << "only " << steady.modes.size() << " of " << arguments.modes << " modes exist or were found\n";
  std::cout << "wrote ends.csv"
            << (arguments.modes > 0 ? ", shape.csv, modes.csv and mode_shapes.csv" : " and shape.csv") << " to "
            << arguments.out << "\n";
}

// An end of the tether must be in the water or the air.
void checkPlace(const tether_monitor::monitor::Config& config, const std::string& end, const Vector3& place)
{
  namespace core = tether_monitor::core;
  const auto refuse = [&](double depth, const std::string& where)
  {
    throw std::runtime_error("the " + end + " end of the tether lies " +
                             core::formatNumber(std::round(1e3 * depth) / 1e3) + " m " + where);
  };
  if (config.environment.seabed)
  {
    const double below = config.environment.seabed->at(place.x(), place.y()).z - place.z();
    if (below > 0.0)
      refuse(below, "below the seabed");
  }
  for (const core::Obstacle& obstacle : config.environment.obstacles)
  {
    const double inside = -core::signedDistance(obstacle, place - obstacle.position).distance;
    if (inside > 0.0)
      refuse(inside, "inside the obstacle '" + obstacle.name + "'");
  }
}

int findSteadyState(const Arguments& arguments)
{
  using namespace tether_monitor;
  const monitor::Config config = params::loadConfigFile(arguments.config);
  const bool is_free = config.vehicle_mode == monitor::VehicleMode::FREE;
  if (is_free && !arguments.vehicle_position.empty())
    throw std::runtime_error("--vehicle-position cannot be given for a free vehicle: it finds its own");
  if (!is_free && arguments.vehicle_position.empty())
    throw std::runtime_error("--vehicle-position is required unless vehicle.mode is free");
  const Vector3 velocity = parseVector("--vessel-velocity", arguments.vessel_velocity);
  const Vector3 vessel = parseVector("--vessel-position", arguments.vessel_position);
  const Vector3 vehicle = is_free ? vessel : parseVector("--vehicle-position", arguments.vehicle_position);
  checkPlace(config, "vessel", vessel + config.vessel.attachment);
  if (!is_free)
    checkPlace(config, "vehicle", vehicle + config.vehicle.attachment);
  files::makeFolder(arguments.out);

  if (!config.environment.waves.isCalm() && !arguments.quiet)
    std::cout << "notice: waves are left out of a steady state\n";
  if (velocity.z() != 0.0 && !arguments.quiet)
    std::cout << "notice: the vertical velocity is left out of a steady state: it cannot last\n";

  for (const std::string& value : monitor::suspiciousValues(config))
    std::cerr << "warning: suspicious: " << value << "\n";
  const replay::SteadyState steady = replay::findSteadyState(config, vessel, vehicle, velocity, arguments.modes);
  const monitor::TetherEstimate& estimate = steady.estimate;
  if (!estimate.has_stations || !steady.report.converged())
  {
    if (steady.report.converged())
      std::cerr << "tether_steady: no steady state that a tether can have: " << describe(estimate.reason) << "\n";
    else
      std::cerr << "tether_steady: no steady state: " << core::describe(steady.report.status) << ", residual "
                << steady.report.residual << " N after " << steady.report.iterations << " iterations\n";
    return NO_STEADY_STATE;
  }
  replay::EndsFile ends(arguments.out, replay::VehicleColumns::RELATIVE);
  ends.write(estimate);
  ends.close();
  replay::ShapeFile shape(arguments.out);
  shape.write(estimate);
  shape.close();
  if (arguments.modes > 0)
    replay::writeModes(arguments.out, steady.modes, steady.node_s);
  if (!arguments.quiet)
    printSummary(steady, arguments);
  return 0;
}
}  // namespace

int main(int argc, char** argv)
{
  namespace options = boost::program_options;
  tether_monitor::apps::CommandLine line(
      "tether_steady",
      "Finds the steady state of a tether whose ends move together: both held, or with a simulated vehicle.");
  Arguments a;
  line.add()("config", options::value(&a.config)->required(), "YAML file with the parameter tree of the node")(
      "vessel-position", options::value(&a.vessel_position)->default_value(a.vessel_position),
      "X,Y,Z of the vessel [m]")("vehicle-position", options::value(&a.vehicle_position),
                                 "X,Y,Z of the vehicle [m], unless vehicle.mode is free")(
      "vessel-velocity", options::value(&a.vessel_velocity)->default_value(a.vessel_velocity),
      "VX,VY,VZ of both [m/s]")("modes", options::value(&a.modes)->default_value(a.modes),
                                "number of natural modes to write to modes.csv and mode_shapes.csv")(
      "out", options::value(&a.out)->required(), "folder for the results, made if needed")(
      "quiet", options::bool_switch(&a.quiet), "print nothing but errors");
  return tether_monitor::apps::runProgram("tether_steady", line, argc, argv,
                                          [&]
                                          {
                                            tether_monitor::apps::checkNotNegative("modes", a.modes);
                                            return findSteadyState(a);
                                          });
}
