#include "tether_monitor/core/element/element_coordinates.h"

namespace tether_monitor::core
{
namespace
{
// Calls act(map, first of the three entries) for each end whose slope follows from the neighbour's.
template <typename Act>
void forMappedEnds(const ElementParameters& p, const NodeField& q, int i, const Act& act)
{
  if (p.at_a.active)
    act(SlopeMap(p.at_a, q[i].tail<3>()), 3);
  if (p.at_b.active)
    act(SlopeMap(p.at_b, q[i + 1].tail<3>()), 9);
}
}  // namespace

ElementCoords elementCoords(const ElementParameters& p, const NodeField& q, int i)
{
  ElementCoords e = elementCoords(q, i);
  forMappedEnds(p, q, i, [&](const SlopeMap& map, int at) { e.segment<3>(at) = map.slope(); });
  return e;
}

ElementCoords elementRates(const ElementParameters& p, const NodeField& q, const NodeField& v, int i)
{
  ElementCoords e = elementCoords(v, i);
  forMappedEnds(p, q, i, [&](const SlopeMap& map, int at) { e.segment<3>(at) = map.rate(e.segment<3>(at)); });
  return e;
}

ElementCoords elementAccelerations(const ElementParameters& p, const NodeField& q, const NodeField& v,
                                   const NodeField& a, int i)
{
  ElementCoords e = elementCoords(a, i);
  const ElementCoords rates = elementCoords(v, i);
  forMappedEnds(p, q, i,
                [&](const SlopeMap& map, int at)
                { e.segment<3>(at) = map.acceleration(rates.segment<3>(at), e.segment<3>(at)); });
  return e;
}

void pullBack(const ElementParameters& p, const NodeField& q, int i, ElementCoords& force)
{
  forMappedEnds(p, q, i,
                [&](const SlopeMap& map, int at) { force.segment<3>(at) = map.rate(force.segment<3>(at)); });
}

void pullBack(const ElementParameters& p, const NodeField& q, int i, double stiffness, ElementCoords& force,
              ElementMatrix& matrix)
{
  forMappedEnds(p, q, i,
                [&](const SlopeMap& map, int at)
                {
                  const Matrix3 J = map.jacobian();
                  matrix.middleRows<3>(at) = (J * matrix.middleRows<3>(at)).eval();
                  matrix.middleCols<3>(at) = (matrix.middleCols<3>(at) * J).eval();
                  matrix.block<3, 3>(at, at) += stiffness * map.geometricStiffness(force.segment<3>(at));
                  force.segment<3>(at) = map.rate(force.segment<3>(at));
                });
}

}  // namespace tether_monitor::core
