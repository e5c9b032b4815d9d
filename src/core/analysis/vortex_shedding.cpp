#include "tether_monitor/core/analysis/vortex_shedding.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/element/element_coordinates.h"
#include "tether_monitor/core/element/hermite_shape_functions.h"

namespace tether_monitor::core
{
namespace
{
constexpr double LOCK_IN = 0.75;           // of the first natural frequency
constexpr double LEAST_FLOW = 0.05;        // across the tether [m/s]
constexpr double SHORTEST_HALF_WAVE = 20;  // diameters

struct Piece
{
  Vector3 place, slope, velocity;
};

Piece middleOf(const DeployedCable& cable, const CableState& state, int i)
{
  const double l = cable.element(i).length;
  const ShapeValues S = shapeFunctions(0.5, l);
  const ElementCoords q = elementCoords(cable.element(i), state.q, i);
  return {interpolate(S, q), interpolate(shapeSlopes(0.5, l), q),
          interpolate(S, elementRates(cable.element(i), state.q, state.v, i))};
}

// Speed of transverse waves; 0 where slack.
double waveSpeed(const DeployedCable& cable, const ElementParameters& e, const Piece& at)
{
  const double strain = 0.5 * (at.slope.squaredNorm() / (e.natural_stretch * e.natural_stretch) - 1.0);
  const double added = at.place.z() < 0.0 ? cable.environment().density() * e.area * e.added_mass : 0.0;
  return std::sqrt(std::max(axialResponse(e.axial, strain).force, 0.0) / (e.mass + added));
}
}  // namespace

double sheddingFrequency(const DeployedCable& cable, const CableState& state, int i)
{
  const Piece at = middleOf(cable, state, i);
  const double length = at.slope.norm();
  if (at.place.z() >= 0.0 || !(length > 0.0))
    return 0.0;
  const Vector3 t = at.slope / length;
  const Vector3 u = at.velocity - cable.environment().waterKinematics(at.place, state.time).velocity -
                    state.deployment.variation.currentAt(at.place.z());
  return STROUHAL * (u - u.dot(t) * t).norm() / cable.element(i).diameter;
}

VortexShedding findLockIn(const DeployedCable& cable, const CableState& state, double amplification,
                          std::vector<double>& drag_factor)
{
  VortexShedding found;
  if (amplification != 1.0)
    drag_factor.resize(cable.elements());
  double travel = 0.0;  // of a wave from end to end [s]
  for (int i = 0; i < cable.elements(); ++i)
  {
    const ElementParameters& e = cable.element(i);
    if (e.parted)
      continue;
    travel += e.length / std::max(waveSpeed(cable, e, middleOf(cable, state, i)), 1e-3);
  }
  found.fundamental_frequency = 0.5 / travel;
  for (int i = 0; i < cable.elements(); ++i)
  {
    const ElementParameters& e = cable.element(i);
    if (e.parted)
      continue;
    const double shedding = sheddingFrequency(cable, state, i);
    const double half_wave = 0.5 * waveSpeed(cable, e, middleOf(cable, state, i)) / std::max(shedding, 1e-9);
    const bool locks_in = shedding * e.diameter > STROUHAL * LEAST_FLOW &&
                          shedding > LOCK_IN * found.fundamental_frequency &&
                          half_wave > SHORTEST_HALF_WAVE * e.diameter;
    if (amplification != 1.0)
      drag_factor[i] = locks_in ? amplification : 1.0;
    if (!locks_in)
      continue;
    if (shedding > found.highest_frequency)
    {
      found.highest_frequency = shedding;
      found.s = cable.arcLength(i) + 0.5 * e.length;
    }
    found.lowest_frequency = found.length > 0.0 ? std::min(found.lowest_frequency, shedding) : shedding;
    found.length += e.length;
  }
  return found;
}

}  // namespace tether_monitor::core
