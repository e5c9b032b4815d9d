#pragma once

#include <optional>
#include <vector>

#include "tether_monitor/core/assembly/cable_model.h"
#include "tether_monitor/monitor/config/config.h"

namespace tether_monitor::monitor
{
/// The model of a configuration, with its simulated vehicle if it has one. @throws std::invalid_argument listing
/// problems.
core::CableModel makeModel(const Config& config);

/// Whether a configuration can be meshed with another deployed length [m] in so many elements. What is fixed to
/// the tether keeps its distance from the vehicle end; what has come aboard is left out.
bool canMesh(const Config& config, double length, int elements);

/// The model of a configuration at another deployed length [m], canMesh() must hold, in so many elements.
/// @throws std::invalid_argument if it does not.
core::CableModel makeModel(const Config& config, double length, int elements);

/// What changes in a model while it is in use: pay-out, strumming, current, obstacles, depth, clock.
struct ModelSnapshot
{
  double reference_length = 0.0;  ///< [m] that the mesh was made for.
  int elements = 0;
  core::PayoutState payout;
  std::vector<double> drag_normal;  ///< of every element [-].
  std::vector<core::CurrentProfile::Sample> current;
  std::vector<core::Obstacle> obstacles;
  double epoch = 0.0;    ///< of the waves [s].
  core::Vector3 origin;  ///< of the model's coordinates [m].

  template <class Archive>
  void serialize(Archive& a)
  {
    a(reference_length, elements, payout, drag_normal, current, obstacles, epoch, origin);
  }
};

/// What a model has come to since it was made.
ModelSnapshot snapshotOf(const core::CableModel& model);

/// The model of a configuration as `memory` remembers it; nothing if that cannot be.
std::optional<core::CableModel> restoreModel(const Config& config, const ModelSnapshot& memory);

/// True for a state that the model can be stepped from.
bool isStateOf(const core::CableState& state, const core::CableModel& model);

}  // namespace tether_monitor::monitor
