#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/core/cable/axial_stiffening.h"

namespace tether_monitor::core
{
/**
 * Constants of a uniform tether, as a data sheet gives them. Members without a comment on their default must be
 * set. Drag forces per unstretched metre are 1/2 rho d Cn |un| un and 1/2 rho d Ct |ut| ut: both coefficients
 * refer to d * length. A tangential coefficient on the wetted surface pi d length (MoorDyn, OrcaFlex) is
 * multiplied by pi first.
 */
struct CableProperties
{
  double length = 0.0;           ///< L [m], unstretched and deployed, > 0.
  double diameter = 0.0;         ///< d [m], > 0.
  double mass_per_length = 0.0;  ///< m [kg/m], dry, in air, > 0.
  double axial_stiffness = 0.0;  ///< EA [N] per Green-Lagrange strain, > 0 (a catalogue's per engineering strain).
  AxialStiffening axial_stiffening;  ///< of larger strains, from axialCurve(); default none.
  double bending_stiffness = 0.0;    ///< EI [N m^2], >= 0; default 0 (a stated regularisation acts inside, (M6)).
  double axial_damping = 1.0e-3;     ///< tau [s], >= 0; default 1 ms.
  double drag_normal = 0.0;          ///< Cn [-], >= 0.
  double drag_tangential = 0.0;      ///< Ct [-], >= 0.
  double added_mass_normal = 1.0;    ///< Can [-], times the displaced mass, >= 0; default 1.
  double added_mass_tangential = 0.0;    ///< Cat [-], likewise, for motion along the tether, >= 0; default 0.
  double hydrostatic_compression = 0.0;  ///< loss of diameter per metre of depth, over the diameter [1/m], 0 to
                                         ///< 1e-3; meant for losses up to a half.
  double permanent_elongation = 0.0;  ///< [m/m], >= 0: the tether is longer by this without load. s, the mass and
                                      ///< the section stay those of before.
  double working_load = 0.0;          ///< SWL (WLL) [N], > 0 and <= breaking_load.
  double breaking_load = 0.0;         ///< MBL [N], > 0.
  std::optional<double>
      contact_diameter;                   ///< dc [m], > 0: what touches floor and obstacles; default the diameter.
  std::optional<double> load_area;        ///< [m^2] carrying the load, > 0; default pi d^2 / 4.
  std::optional<double> min_bend_radius;  ///< [m], > 0; default none.

  /// Cross-section that displaces water, pi d^2 / 4 [m^2].
  double displacedArea() const;
  /// Cross-section that carries the load [m^2]: load_area or pi d^2 / 4.
  double stressArea() const;
};

/// Every bound of CableProperties that `p` violates, one sentence each, beginning with the member's name.
std::vector<std::string> validate(const CableProperties& p);

}  // namespace tether_monitor::core
