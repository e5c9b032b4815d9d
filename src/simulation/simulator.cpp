#include "tether_monitor/simulation/simulator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tether_monitor/core/assembly/deployed_cable.h"
#include "tether_monitor/core/base/bounds_check.h"
#include "tether_monitor/core/bodies/rigid_body_dynamics.h"
#include "tether_monitor/core/solve/steady_state_solver.h"

namespace tether_monitor::simulation
{
namespace
{
constexpr double FASTEST_WINCH = 3.0;  // [m/s]

core::CableModel checkedModel(const monitor::Config& config, const SimulationConfig& simulation)
{
  std::vector<std::string> faults = validate(config);
  for (const std::string& fault : validate(simulation))
    faults.push_back(fault);
  core::throwIfInvalid("scenario", faults);
  return core::CableModel(config.tether, config.elements, config.environment, config.layout);
}
}  // namespace

Simulator::Simulator(const monitor::Config& config, const SimulationConfig& simulation)
  : config_(config), simulation_(simulation), model_(checkedModel(config, simulation))
{
  start();
}

void Simulator::start()
{
  const VesselPlan& plan = simulation_.vessel;
  core::RigidBody ship = makeBoxShip(plan.ship, config_.environment.water_density);
  ship.attachment = config_.vessel.attachment;
  core::RigidBody body = simulation_.vehicle.body;
  body.attachment = config_.vehicle.attachment;

  core::AttitudeState turned;
  turned.orientation = Eigen::AngleAxisd(plan.heading, core::Vector3::UnitZ());
  const core::Vector3 velocity = plan.speed * (turned.orientation * core::Vector3::UnitX());
  const core::Vector3 centre(plan.start.x(), plan.start.y(), equilibriumHeight(plan.ship));
  core::SteadyEnds ends;
  ends.vessel = centre + turned.orientation * ship.attachment;
  ends.velocity = velocity;
  const bool is_external = simulation_.vehicle.control == VehicleControl::EXTERNAL;
  const bool holds = is_external || simulation_.vehicle.control == VehicleControl::STATION_KEEPING;
  ends.vehicle = simulation_.vehicle.start + body.attachment;
  if (simulation_.vehicle.control == VehicleControl::THRUST)
  {
    vehicle_thrust_.force = simulation_.vehicle.thrust;
    body.force += simulation_.vehicle.thrust;  // level, its axes those of the world
  }
  if (!holds)
    model_ = model_.withBodies({std::nullopt, body});
  core::NodeField shape;
  core::SteadyStateSolver statics(model_.nodes());
  const core::SolveReport found = statics.solve(model_, ends, shape);
  if (!found.converged())
    throw std::runtime_error(std::string("the scenario has no steady state to start from: ") +
                             core::describe(found.status));
  state_ = core::CableState(0.0, shape, velocity);
  state_.vessel = turned;
  core::initializeContact(model_, state_);
  if (holds)
  {
    const core::Vector3 others =
        core::steadyForce(body, model_.environment().withoutWaves(), ends.vehicle, velocity);
    const core::Vector3 balance = -others - core::endForces(model_, state_).vehicle;
    if (is_external)
      vehicle_thrust_.force = balance;  // level, its axes those of the world
    else
      vehicle_autopilot_.emplace(simulation_.vehicle, balance);
  }
  body.force = simulation_.vehicle.body.force;
  model_ = model_.withBodies({ship, body});
  vessel_autopilot_.emplace(plan, ship, config_.environment.water_density);
  core::StepperOptions options = config_.solver;
  options.scheme = core::Scheme::GENERALIZED_ALPHA;
  stepper_.emplace(model_, options);
}

monitor::BodyState Simulator::vessel() const
{
  return monitor::BodyState::ofNode(state_, 0, state_.vessel, config_.vessel.attachment);
}

monitor::BodyState Simulator::vehicle() const
{
  return monitor::BodyState::ofNode(state_, state_.q.size() - 1, state_.vehicle, config_.vehicle.attachment);
}

double Simulator::orderedRate(double dt) const
{
  if (!std::isnan(commanded_rate_))
    return std::clamp(commanded_rate_, -FASTEST_WINCH, FASTEST_WINCH);
  const WinchCommand* order = nullptr;
  for (const WinchCommand& candidate : simulation_.winch)
    if (candidate.time <= state_.time)
      order = &candidate;
  const double left = order ? order->length - length() : 0.0;
  if (!order || std::abs(left) <= 1e-6)
    return 0.0;
  const double a = simulation_.winch_acceleration;
  return std::copysign(std::min({order->rate, std::sqrt(a * std::abs(left)), std::abs(left) / dt}), left);
}

core::PayoutTrajectory Simulator::payOut(double dt)
{
  const double wanted = orderedRate(dt), a = simulation_.winch_acceleration;
  const double before = winch_rate_;
  winch_rate_ = before + std::clamp(wanted - before, -a * dt, a * dt);
  const double after = length() + 0.5 * dt * (before + winch_rate_);
  return core::PayoutTrajectory::between(state_.time, {length(), before, 0.0}, state_.time + dt,
                                         {after, winch_rate_, 0.0});
}

void Simulator::commandThrust(const core::Wrench& thrust)
{
  if (simulation_.vehicle.control != VehicleControl::EXTERNAL)
    return;
  vehicle_thrust_ = thrust;
  const double size = thrust.force.norm(), largest = simulation_.vehicle.largest_thrust;
  if (size > largest)
    vehicle_thrust_.force *= largest / size;
}

void Simulator::updateWind()
{
  const Squall& squall = simulation_.squall;
  const bool in_squall = state_.time >= squall.from && state_.time < squall.to;
  if (in_squall == in_squall_)
    return;
  in_squall_ = in_squall;
  model_ =
      model_.withEnvironment(model_.environment().withWind(in_squall ? squall.wind : config_.environment.wind));
}

bool Simulator::advance(double t)
{
  while (state_.time < t - 1e-9)
  {
    const double dt = std::min(STEP, t - state_.time);
    core::BoundaryConditions drive;
    updateWind();
    drive.vessel_thrust = vessel_autopilot_->steer(vessel(), dt);
    if (vehicle_autopilot_)
      vehicle_thrust_ = vehicle_autopilot_->steer(vehicle(), dt);
    drive.vehicle_thrust = vehicle_thrust_;
    if (hasWinch())
    {
      const core::PayoutTrajectory path = payOut(dt);
      if (model_.canRepresentLength(path.at(state_.time + dt).length))
        drive.payout = path;
      else
      {
        winch_rate_ = 0.0;
        drive.payout = core::PayoutTrajectory::constant(length());
      }
    }
    if (!stepper_->advance(model_, drive, state_.time + dt, state_).converged())
      return false;
  }
  return true;
}

}  // namespace tether_monitor::simulation
