#pragma once

#include "tether_monitor/core/cable/cable_properties.h"

namespace tether_monitor::core
{
/// Small stated stiffnesses that keep a slack tether definite; (M3) and (M6) of doc/model.md.
struct SlackRegularisation
{
  double compression_limit;  ///< Pc [N]: the larger of 0.1 % of the dry weight and 4 (w^2 EI)^(1/3), w = m g.
  double residual;           ///< kappa [-]: share of EA left in deep compression, 1e-5.
  double bending_stiffness;  ///< EI used [N m^2]: the larger of the tether's own and the smallest that the mesh
                             ///< carries.
};

/**
 * SlackRegularisation of an element.
 *
 * Model: EI_min = 0.2 m g l^4 / L. A slack bight of radius (EI_min / m g)^(1/3) then spans a fair share of an
 * element, and the effect on a taut tether vanishes with the fourth power of the element length, as the
 * discretisation error. Pc covers the push that bending itself needs: a bight of a tether with weight w and
 * stiffness EI carries some (w^2 EI)^(1/3), and a law that gave way below that would let the bight shrink.
 *
 * @param p               the tether.
 * @param element_length  l [m], > 0.
 * @param gravity         g [m/s^2], >= 0; 9.81 is used where it is zero.
 */
SlackRegularisation slackRegularisation(const CableProperties& p, double element_length, double gravity);

}  // namespace tether_monitor::core
