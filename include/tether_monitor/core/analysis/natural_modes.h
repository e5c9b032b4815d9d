#pragma once

#include <vector>

#include "tether_monitor/core/assembly/cable_model.h"
#include "tether_monitor/core/cable/cable_state.h"

namespace tether_monitor::core
{
/// What moves in a mode of vibration.
enum class ModeKind
{
  TRANSVERSE,
  AXIAL
};

/// A natural mode of a tether about a steady state.
struct Mode
{
  ModeKind kind = ModeKind::TRANSVERSE;  ///< where more than half of the kinetic energy is.
  double frequency = 0.0;                ///< [Hz]
  NodeField shape;                       ///< displacement of nodes and slopes; the largest displacement is 1.
};

/**
 * The lowest natural modes of a tether about a steady state, without damping.
 *
 * Model: K x = w^2 M x with the tension-stiffened tangent and the mass with added mass at that state, (M26) of
 * doc/model.md; subspace iteration. A body at an end is a point of its mass and added mass; its rotation is
 * locked. Contact counts as it is: what lies on the seabed stays there.
 *
 * @param state  steady; waves are taken away.
 * @param count  modes wanted, >= 1; fewer are returned if there are fewer.
 * @return       in order of frequency; empty if no factor of the matrix exists. Motions that would grow (w^2 < 0)
 * are left out.
 */
std::vector<Mode> naturalModes(const CableModel& model, const CableState& state, int count);

}  // namespace tether_monitor::core
