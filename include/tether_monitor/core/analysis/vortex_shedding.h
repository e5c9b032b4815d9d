#pragma once

#include "tether_monitor/core/assembly/cable_model.h"
#include "tether_monitor/core/cable/cable_state.h"

namespace tether_monitor::core
{
/// Strouhal number of a round tether [-].
constexpr double STROUHAL = 0.2;

/// Vortex-induced transverse vibration (strumming) of a tether in the flow.
struct VortexShedding
{
  double lowest_frequency = 0.0;   ///< of vortex shedding, over the pieces that strum [Hz].
  double highest_frequency = 0.0;  ///< likewise [Hz].
  double fundamental_frequency =
      0.0;              ///< first transverse natural frequency by the time a wave takes along the tether [Hz].
  double length = 0.0;  ///< unstretched length that strums [m].
  double s = 0.0;       ///< where the shedding is fastest [m].

  template <class Archive>
  void serialize(Archive& a)
  {
    a(lowest_frequency, highest_frequency, fundamental_frequency, length, s);
  }
};

/// Frequency of vortex shedding on element `i`: 0.2 |un| / d, un the flow across the tether at its middle [Hz].
double sheddingFrequency(const CableModel& model, const CableState& state, int i);

/**
 * Which part of a tether strums.
 *
 * Model: (M27) of doc/model.md. A piece under water, in pull and in a flow of 5 cm/s or more locks in where its
 * shedding frequency is above 0.75 of the first transverse natural frequency and half a wave of that frequency is
 * at least 20 diameters long. A long tether has a natural frequency near any other, so there is nearly always one
 * to lock in with.
 *
 * @param factor  multiplies the normal drag of the elements that strum, and takes it off the others; 1: changes
 *                nothing.
 */
VortexShedding findLockIn(CableModel& model, const CableState& state, double factor);

}  // namespace tether_monitor::core
