#pragma once

#include <optional>

#include "tether_monitor/core/assembly/deployed_cable.h"
#include "tether_monitor/core/cable/cable_state.h"
#include "tether_monitor/core/solve/adaptive_stepper.h"
#include "tether_monitor/core/solve/mesh_convergence.h"
#include "tether_monitor/core/solve/steady_state_solver.h"
#include "tether_monitor/monitor/config/config.h"

namespace tether_monitor::monitor
{
/// What stepping has cost since the start.
struct StepCount
{
  long steps = 0;
  long rejected = 0;
  long iterations = 0;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(steps, rejected, iterations);
  }
};

/// What a mesh was selected for: it serves as long as the tether is about as long, as taut and as fast.
struct MeshPurpose
{
  double length = 0.0;  ///< [m]
  double chord = 0.0;   ///< [m]
  core::Vector3 velocity = core::Vector3::Zero();

  /// Whether it serves for a tether of `length_now` [m] between other ends.
  bool serves(double length_now, const core::SteadyEnds& ends) const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(length, chord, velocity);
  }
};

/// The simulated tether: model, state, and all that has memory for them. A copy is independent.
struct CableSimulation
{
  explicit CableSimulation(const Config& config);

  /// Another model, cut and stepped as `selection` says; the state must be set anew.
  void setModel(const core::CableModel& other, const core::MeshSelection& selection);
  /// Another deployed length [m] of a tether that is not in motion, with more elements if it takes them.
  /// @return false, and nothing changes, if it cannot be.
  bool setLength(const Config& config, double length);
  /// Deployed length [m].
  double length() const { return model.length(state.deployment); }
  /// Place of the model's coordinates in the world [m].
  const core::Vector3& origin() const { return model.environment().origin(); }
  /// `cable` at the state's deployment. Allocates nothing.
  const core::DeployedCable& updatedCable()
  {
    cable.update(model, state.deployment);
    return cable;
  }

  core::CableModel model;
  core::CableState state;  ///< relative to origin().
  core::AdaptiveStepper stepper;
  core::SteadyStateSolver steady_solver;
  core::DeployedCable cable;
  core::MeshSelection mesh;
  std::optional<MeshPurpose> mesh_purpose;
  std::optional<double> reported_depth;  ///< of the sea, where a message has replaced the configuration's [m].
  StepCount count;
  core::SolveReport last_solve;

 private:
  core::StepperOptions options_;
};

}  // namespace tether_monitor::monitor
