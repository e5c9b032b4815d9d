#pragma once

#include "integration_point.h"

#include "tether_monitor/core/element/submergence.h"

namespace tether_monitor::core::kernel
{
// What the water does at one integration point, and how much of the tether it covers.
template <class V>
struct WaterAtPoint
{
  V velocity[3], acceleration[3];
  Submergence<V> submergence;
  bool emerges;           // in any lane
  V compressed_diameter;  // over the diameter at the surface
  V displaced_mass;       // of a wholly submerged metre [kg/m]
  V submerged_mass;       // of what is under water [kg/m]
  V displaced_mass_rate;  // - d ln(displaced_mass) / dz where pressure compresses it
};

template <int W, class V>
TM_INLINE WaterAtPoint<V> waterAtPoint(int g, const ElementBlock& in, int first, const ElementConstants<V>& e,
                                       const IntegrationPoint<V>& p)
{
  WaterAtPoint<V> water;
  V surface{};
  const V depth = lanes::min(lanes::max(-p.r[2], V{}), broadcast<W>(in.around->shear_depth));
  const double* table = in.water ? in.water + g * WATER_ROWS * BLOCK + first : nullptr;
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
  {
    water.velocity[k] = table ? load<W>(table + (WATER_VELOCITY + k) * BLOCK)
                              : in.around->current[k] + depth * in.around->shear[k];
    water.acceleration[k] = table ? load<W>(table + (WATER_ACCELERATION + k) * BLOCK) : V{};
  }
  if (table)
    surface = load<W>(table + WATER_SURFACE * BLOCK);
  const V extent = lanes::abs(p.t[2]) * p.weight + e.diameter, height = p.r[2] - surface;
  water.submergence = {broadcast<W>(1.0), V{}};
  water.emerges = any(!(height < -0.5 * extent));
  if (water.emerges)
    water.submergence = submergence(height, extent);
  water.compressed_diameter = broadcast<W>(1.0);
  water.displaced_mass_rate = V{};
  if (in.has_compression)
  {
    const V shrunk = lanes::max(1.0 + e.compression * p.r[2], broadcast<W>(0.1));
    water.compressed_diameter = p.r[2] < 0.0 ? shrunk : broadcast<W>(1.0);
    water.displaced_mass_rate = p.r[2] < 0.0 ? 2.0 * e.compression / water.compressed_diameter : V{};
  }
  water.displaced_mass = e.rho_area * water.compressed_diameter * water.compressed_diameter;
  water.submerged_mass = water.displaced_mass * water.submergence.fraction;
  return water;
}

// Weight, and what the pressure of the water around exerts (M8), (M10): against gravity and with the water's
// acceleration.
template <class V>
TM_INLINE void addWeightAndBuoyancy(const ElementBlock& in, const ElementConstants<V>& e,
                                    const WaterAtPoint<V>& water, IntegrationPoint<V>& p)
{
  if (in.water)
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k)
      p.f[k] -= water.submerged_mass * water.acceleration[k];
  p.f[2] += in.around->gravity * (e.mass - water.submerged_mass);
}

template <class V, EvaluationMode MODE>
TM_INLINE void addBuoyancyTangent(const ElementBlock& in, const WaterAtPoint<V>& water,
                                  const IntegrationPoint<V>& p, PointTangent<V, MODE>& out)
{
  out.f_r[packedIndex3(2, 2)] +=
      p.weight * in.stiffness * (in.around->gravity + water.acceleration[2]) * water.displaced_mass *
      (water.submergence.slope - water.displaced_mass_rate * water.submergence.fraction);
}
}  // namespace tether_monitor::core::kernel
