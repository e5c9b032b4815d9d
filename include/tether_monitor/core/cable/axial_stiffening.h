#pragma once

#include <array>
#include <string>
#include <vector>

namespace tether_monitor::core
{
/// One row of a measured curve of a rope.
struct StrainTension
{
  double strain = 0.0;   ///< elongation over the unstretched length [-], > 0.
  double tension = 0.0;  ///< [N], > 0.
};

/**
 * How the axial stiffness changes with the strain, beyond that of small strains: N(eps) = EA eps + sum of
 * change_k max(eps - strain_k, 0). A plain array: it is copied on the stepping path.
 *
 * Model: (M32) of doc/model.md.
 */
struct AxialStiffening
{
  static constexpr int MOST = 7;

  int count = 0;                      ///< changes, 0 ..  MOST.
  std::array<double, MOST> strain{};  ///< Green-Lagrange strain of each [-], > 0, increasing.
  std::array<double, MOST> change{};  ///< of the stiffness there [N].

  double force(double eps) const;    ///< what is added to EA eps [N].
  double modulus(double eps) const;  ///< what is added to EA [N].
  double energy(double eps) const;   ///< integral of force() from 0 [N].
  double largestModulus() const;     ///< the largest of modulus(), >= 0 [N].
};

/// A tension curve as the axial law uses it: the stiffness of small strains, and its changes.
struct AxialCurve
{
  double stiffness = 0.0;  ///< EA up to the first row [N] per Green-Lagrange strain.
  AxialStiffening stiffening;
};

/**
 * The curve that passes through the rows, and through zero; beyond the last row it goes on as before it.
 *
 * @param rows  valid according to validate().
 */
AxialCurve axialCurve(const std::vector<StrainTension>& rows);

/// What is wrong with the rows of a curve, one sentence each: 1 .. MOST + 1 rows, strain and tension finite, > 0
/// and increasing, and the tension over (1 + strain) as well, without which the rope would not stay in one piece.
std::vector<std::string> validate(const std::vector<StrainTension>& rows);

}  // namespace tether_monitor::core
