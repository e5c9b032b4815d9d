#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "tether_monitor/core/assembly/cable_model.h"
#include "tether_monitor/core/assembly/end_forces.h"
#include "tether_monitor/core/solve/adaptive_stepper.h"
#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/measurements/motion_buffer.h"
#include "tether_monitor/simulation/vehicle_autopilot.h"
#include "tether_monitor/simulation/vessel_autopilot.h"

namespace tether_monitor::simulation
{
/**
 * A vessel, a tether and a vehicle that move together in the sea, with the monitor's core: the truth behind a
 * scenario. All three are solved in one implicit system.
 */
class Simulator
{
 public:
  static constexpr double STEP = 0.05;  ///< [s]; the sea changes little in it.

  /**
   * Starts from the steady state of the tether at time zero.
   *
   * @param config      tether, environment and attachments; its vehicle mode does not matter.
   * @param simulation  see SimulationConfig.
   * @throws std::invalid_argument listing every problem; std::runtime_error if there is no steady state.
   */
  Simulator(const monitor::Config& config, const SimulationConfig& simulation);

  /// Epoch of the clock that times count from [s]: waves are those of the clock. Before the first step.
  void setEpoch(double epoch) { model_ = model_.withEnvironment(model_.environment().withTimeOrigin(epoch)); }

  /// Rate that the winch is to pay out at from now on [m/s], instead of its orders; NaN: back to them. Within 3
  /// m/s.
  void commandWinch(double rate) { commanded_rate_ = rate; }
  /// Thrust on the vehicle from now on, its own axes, with VehicleControl::EXTERNAL; cut to its largest.
  void commandThrust(const core::Wrench& thrust);

  /// Steps to time t [s], not before the last. @return false if the solver failed: the simulation has ended.
  bool advance(double t);

  double time() const { return state_.time; }
  /// Reference points: centres of mass.
  monitor::BodyState vessel() const;
  monitor::BodyState vehicle() const;
  core::PayoutState payout() const { return {length(), winch_rate_, 0.0}; }
  const core::Wrench& vehicleThrust() const { return vehicle_thrust_; }
  /// Forces of the tether on its ends [N].
  core::EndForces endForces() const { return core::endForces(model_, state_); }
  const core::CableModel& model() const { return model_; }
  const core::CableState& state() const { return state_; }
  /// Whether there are orders for the winch.
  bool hasOrders() const { return !simulation_.winch.empty(); }
  /// Whether the winch moves at all in this scenario.
  bool hasWinch() const { return simulation_.winch_is_commanded || !simulation_.winch.empty(); }

 private:
  double length() const { return model_.length(state_.deployment); }
  void start();
  double orderedRate(double dt) const;
  core::PayoutTrajectory payOut(double dt);
  void updateWind();

  monitor::Config config_;
  SimulationConfig simulation_;
  core::CableModel model_;
  core::CableState state_;
  std::optional<core::AdaptiveStepper> stepper_;
  std::optional<VesselAutopilot> vessel_autopilot_;
  std::optional<VehicleAutopilot> vehicle_autopilot_;
  core::Wrench vehicle_thrust_;
  double winch_rate_ = 0.0;                                           // [m/s]
  double commanded_rate_ = std::numeric_limits<double>::quiet_NaN();  // [m/s]
  bool in_squall_ = false;
};

}  // namespace tether_monitor::simulation
