#pragma once

#include <cmath>

#include "tether_monitor/core/base/lane_math.h"
#include "tether_monitor/core/cable/axial_stiffening.h"

namespace tether_monitor::core
{
/// Constants of the axial law of one element.
struct AxialParameters
{
  double stiffness = 0.0;  ///< EA [N] per Green-Lagrange strain, > 0.
  double damping = 0.0;    ///< tau [s], >= 0: N = N(eps) + tau EA d eps/dt, (M5), in tension and compression.
  double compression_limit = 0.0;  ///< Pc [N], > 0: largest compression that the law carries, apart from kappa's.
  double compression_stiffness_ratio = 0.0;  ///< kappa [-], 0 <= kappa < 1: share of EA left in deep compression.
  AxialStiffening stiffening{};              ///< of larger strains; default none.

  double largestModulus() const { return stiffness + stiffening.largestModulus(); }
};

/// The same as the law uses them. V is double or a vector of them.
template <class V>
struct AxialCoefficients
{
  V linear;         ///< kappa EA [N].
  V softening;      ///< (1 - kappa) EA [N].
  V inverse_delta;  ///< EA / Pc [-].
};

template <class V>
TETHER_MONITOR_INLINE AxialCoefficients<V> axialCoefficients(V stiffness, V compression_limit, V ratio)
{
  const V linear = ratio * stiffness;
  return {linear, stiffness - linear, stiffness / compression_limit};
}

/// Result of the axial law at one point.
template <class V>
struct AxialResponse
{
  V force;    ///< N(eps) = d psi / d eps [N]; the physical tension is N |r'|.
  V modulus;  ///< d N / d eps [N]; > 0.
};

/**
 * Tension-only axial law with a smooth residual stiffness.
 *
 * Model: (M3) of doc/model.md. For eps >= 0, N = EA eps. For eps < 0 the compression grows smoothly to Pc,
 *   N = kappa EA eps + (1 - kappa) EA eps / (1 - eps/delta),  delta = Pc / EA,
 * so N, and the modulus, are continuous at 0 and the modulus never falls below kappa EA: a slack element keeps a
 * definite tangent and does not fold.
 *
 * @param c    constants, see axialCoefficients() (bounds are checked at set-up).
 * @param eps  Green-Lagrange strain (r'.r' - 1)/2 [-]; any finite number.
 */
template <class V>
TETHER_MONITOR_INLINE AxialResponse<V> axialResponse(const AxialCoefficients<V>& c, V eps)
{
  const V y = lanes::max(-eps * c.inverse_delta, V{});
  V softening = lanes::broadcast<V>(1.0);
  if (lanes::any(y > 0.0))
    softening = 1.0 / (1.0 + y);
  return {c.linear * eps + c.softening * eps * softening, c.linear + c.softening * softening * softening};
}

/// The response of one element with constants `p`, stiffening included (M32).
inline AxialResponse<double> axialResponse(const AxialParameters& p, double eps)
{
  const AxialResponse<double> plain =
      axialResponse(axialCoefficients(p.stiffness, p.compression_limit, p.compression_stiffness_ratio), eps);
  return {plain.force + p.stiffening.force(eps), plain.modulus + p.stiffening.modulus(eps)};
}

/// Green-Lagrange strain of a stretch x over the natural one, (x^2 - 1)/2.
inline double strainOfStretch(double x)
{
  return 0.5 * (x * x - 1.0);
}

/// Stretch over the natural one, >= 1 [-], at which the tension N(eps) x is `tension` [N]; 1 for none or a push.
double stretchAtTension(const AxialParameters& p, double tension);

/// Strain energy psi(eps) [N] = J per unstretched metre, >= 0: the integral of the force from 0, (M3).
inline double axialEnergy(const AxialParameters& p, double eps)
{
  if (eps >= 0.0)
    return 0.5 * p.stiffness * eps * eps + p.stiffening.energy(eps);
  const double delta = p.compression_limit / p.stiffness;
  const double y = -eps / delta;
  const double soft = (1.0 - p.compression_stiffness_ratio) * p.stiffness;
  return 0.5 * p.compression_stiffness_ratio * p.stiffness * eps * eps +
         soft * delta * delta * (y - std::log1p(y));
}

}  // namespace tether_monitor::core
