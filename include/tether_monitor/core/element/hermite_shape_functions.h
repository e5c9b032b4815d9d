#pragma once

#include <array>

namespace tether_monitor::core
{
/// Values of the four cubic Hermite functions (M1) that multiply r_a, r'_a, r_b, r'_b.
using ShapeValues = std::array<double, 4>;

/**
 * Hermite functions and their derivatives on an element of unstretched length L.
 *
 * Model: r(s) = S1 r_a + S2 r'_a + S3 r_b + S4 r'_b, (M1) of doc/model.md; Blintsov & Trunin (2020), eqs 1-4.
 * The one parametrisation of this package is xi = s / L in [0, 1]; the tables of the kernels are made from these.
 *
 * @param xi  place on the element [-]; 0 <= xi <= 1 (not checked: evaluated as polynomials).
 * @param L   unstretched length of the element [m]; L > 0.
 */
constexpr ShapeValues shapeFunctions(double xi, double L)
{
  const double x2 = xi * xi;
  const double x3 = x2 * xi;
  return {1.0 - 3.0 * x2 + 2.0 * x3, L * (xi - 2.0 * x2 + x3), 3.0 * x2 - 2.0 * x3, L * (x3 - x2)};
}

/// First derivatives with respect to s [1/m, -, 1/m, -]; arguments as shapeFunctions().
constexpr ShapeValues shapeSlopes(double xi, double L)
{
  const double x2 = xi * xi;
  return {6.0 * (x2 - xi) / L, 1.0 - 4.0 * xi + 3.0 * x2, 6.0 * (xi - x2) / L, 3.0 * x2 - 2.0 * xi};
}

/// Second derivatives with respect to s [1/m^2, 1/m, 1/m^2, 1/m]; arguments as shapeFunctions().
constexpr ShapeValues shapeCurvatures(double xi, double L)
{
  return {(12.0 * xi - 6.0) / (L * L), (6.0 * xi - 4.0) / L, (6.0 - 12.0 * xi) / (L * L), (6.0 * xi - 2.0) / L};
}

/// Sum of the shape values times the 3-vectors of an element (rows 0-2, 3-5, 6-8, 9-11 of `e`).
template <typename Coords>
inline auto interpolate(const ShapeValues& s, const Coords& e)
{
  return (s[0] * e.template segment<3>(0) + s[1] * e.template segment<3>(3) + s[2] * e.template segment<3>(6) +
          s[3] * e.template segment<3>(9))
      .eval();
}

}  // namespace tether_monitor::core
