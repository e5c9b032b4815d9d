#pragma once

#include <vector>

#include "tether_monitor/core/assembly/deployed_cable.h"

namespace tether_monitor::core
{
/// Strouhal number of a round tether [-].
constexpr double STROUHAL = 0.2;

/// Vortex-induced vibration (VIV, at sea: strumming) of a tether in the flow.
struct VortexShedding
{
  double lowest_frequency = 0.0;       ///< of vortex shedding, over the pieces that are locked in [Hz].
  double highest_frequency = 0.0;      ///< the largest of them [Hz].
  double fundamental_frequency = 0.0;  ///< first transverse natural frequency by the time that a wave takes along
                                       ///< the tether [Hz].
  double length = 0.0;                 ///< unstretched length that is locked in [m].
  double s = 0.0;                      ///< where the shedding is fastest [m].

  template <class Archive>
  void serialize(Archive& a)
  {
    a(lowest_frequency, highest_frequency, fundamental_frequency, length, s);
  }
};

/// Frequency of vortex shedding on element `i`: 0.2 |un| / d, un the flow across the tether at its middle [Hz].
double sheddingFrequency(const DeployedCable& cable, const CableState& state, int i);

/**
 * Which part of a tether is locked in.
 *
 * Model: (M27) of doc/model.md. A piece under water, in tension and in a flow of 5 cm/s or more locks in where its
 * shedding frequency is above 0.75 of the first transverse natural frequency and half a wave of that frequency is
 * at least 20 diameters long. A long tether has a natural frequency near any other, so there is nearly always one
 * to lock in with.
 *
 * @param amplification  of the normal drag where it is locked in [-], >= 1.
 * @param drag_factor    out: of every element, see Deployment; unchanged if the amplification is 1.
 */
VortexShedding findLockIn(const DeployedCable& cable, const CableState& state, double amplification,
                          std::vector<double>& drag_factor);

}  // namespace tether_monitor::core
