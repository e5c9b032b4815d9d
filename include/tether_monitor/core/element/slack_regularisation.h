#pragma once

#include "tether_monitor/core/cable/cable_properties.h"

namespace tether_monitor::core
{
/// Small stated stiffnesses that keep a slack tether definite; (M3) and (M6) of doc/model.md.
struct SlackRegularisation
{
  double compression_limit;            ///< Pc [N]
  double compression_stiffness_ratio;  ///< kappa [-]: share of EA left in deep compression, 1e-5.
  double bending_stiffness;            ///< EI used [N m^2].
};

/**
 * Regularisation of an element.
 *
 * Model: with w = m g, EI = max(the tether's own, EI_min), EI_min = 0.2 w l^4 / L. A slack bight of radius
 * (EI_min / w)^(1/3) then spans a fair share of an element, and the effect on a taut tether vanishes with the
 * fourth power of the element length, as the discretisation error. Pc = max(1e-3 w L, 4 (w^2 EI)^(1/3), 60 EI /
 * L^2): a thousandth of the dry weight; the compression that bending itself needs, for a bight of a tether with
 * weight w and stiffness EI carries some (w^2 EI)^(1/3), and a law that yielded below that would let the bight
 * shrink; and what a stiff tether bears when its ends are pushed together into a loop.
 *
 * @param p               the tether; its `length` is L, deployed.
 * @param element_length  l [m], > 0.
 * @param gravity         g [m/s^2], >= 0; STANDARD_GRAVITY is used where it is zero.
 */
SlackRegularisation slackRegularisation(const CableProperties& p, double element_length, double gravity);

}  // namespace tether_monitor::core
