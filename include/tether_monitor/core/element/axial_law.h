#pragma once

#include <cmath>

namespace tether_monitor::core
{
/// Constants of the axial law of one element.
struct AxialParameters
{
  double stiffness = 0.0;          ///< EA [N] per Green-Lagrange strain, > 0.
  double damping = 0.0;            ///< tau [s], >= 0: N = N(eps) + tau EA d eps/dt, (M5), in pull and push alike.
  double compression_limit = 0.0;  ///< Pc [N], > 0: largest push that the law carries, apart from the residual.
  double residual = 0.0;           ///< kappa [-], 0 <= kappa < 1: share of EA left in deep compression.
};

/// Result of the axial law at one point.
struct AxialLaw
{
  double energy;   ///< psi(eps) [N] = J per unstretched metre; >= 0.
  double force;    ///< N(eps) = d psi / d eps [N]; the physical tension is N |r'|.
  double modulus;  ///< d N / d eps [N]; > 0.
};

/**
 * Tension-only axial law with a smooth residual.
 *
 * Model: (M3) of doc/model.md. For eps >= 0, N = EA eps exactly. For eps < 0 the push grows smoothly to Pc,
 *   N = kappa EA eps + (1 - kappa) EA eps / (1 - eps/delta),  delta = Pc / EA,
 * so N, and the modulus, are continuous at 0 and the modulus never falls below kappa EA: a slack element keeps a
 * definite tangent and does not fold.
 *
 * @param p    constants, see AxialParameters (bounds are checked at set-up).
 * @param eps  Green-Lagrange strain (r'.r' - 1)/2 [-]; any finite number.
 */
inline AxialLaw axialLaw(const AxialParameters& p, double eps)
{
  const double EA = p.stiffness;
  if (eps >= 0.0)
    return {0.5 * EA * eps * eps, EA * eps, EA};
  const double delta = p.compression_limit / EA;
  const double y = -eps / delta;
  const double soft = (1.0 - p.residual) * EA;
  const double d = 1.0 / (1.0 + y);
  return {0.5 * p.residual * EA * eps * eps + soft * delta * delta * (y - std::log1p(y)),
          p.residual * EA * eps + soft * eps * d, p.residual * EA + soft * d * d};
}

}  // namespace tether_monitor::core
