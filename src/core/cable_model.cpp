#include "tether_monitor/core/cable_model.h"

#include <algorithm>

#include "tether_monitor/core/bounds.h"
#include "tether_monitor/core/inertia.h"
#include "tether_monitor/core/regularisation.h"

namespace tether_monitor::core
{
namespace
{
constexpr int MAX_ELEMENTS = 100000;

void setBending(double EI, ElementParameters& e)
{
  e.bending_stiffness = EI;
  e.bending_matrix = bendingMatrix(e.length) * EI;
}

ElementParameters elementParameters(const CableProperties& p, double length, double gravity)
{
  const Regularisation small = regularisation(p, length, gravity);
  ElementParameters e;
  e.length = length;
  e.diameter = p.diameter;
  e.mass = p.mass_per_length;
  e.area = p.displacedArea();
  e.drag_normal = p.drag_normal;
  e.drag_tangential = p.drag_tangential;
  e.added_mass = p.added_mass_normal;
  e.axial = {p.axial_stiffness, p.axial_damping, small.compression_limit, small.residual};
  e.mass_matrix = massMatrix(length) * e.mass;
  setBending(small.bending_stiffness, e);
  return e;
}
}  // namespace

std::vector<std::string> elementCountProblems(int elements)
{
  BoundsCheck check("tether.");
  check.require(elements >= 1 && elements <= MAX_ELEMENTS, "elements", elements,
                ">= 1 and <= " + std::to_string(MAX_ELEMENTS));
  return check.problems();
}

CableModel::CableModel(const CableProperties& properties, int elements, const Environment& sea)
  : properties_(properties), sea_(sea)
{
  std::vector<std::string> faults = problems(properties);
  for (const auto& more : {problems(sea), elementCountProblems(elements)})
    faults.insert(faults.end(), more.begin(), more.end());
  throwIfAny("tether model", faults);

  const double element_length = properties.length / elements;
  elements_.assign(elements, elementParameters(properties, element_length, sea.gravity));
  for (int node = 0; node <= elements; ++node)
    arc_length_.push_back(properties.length * node / elements);
  force_scale_ = 9.81 * std::max(1.0, properties.mass_per_length * properties.length);
}

CableModel CableModel::stiffened(double floor) const
{
  CableModel copy = *this;
  for (ElementParameters& e : copy.elements_)
  {
    const double EI = floor * e.mass * 9.81 * e.length * e.length * e.length;
    if (EI > e.bending_stiffness)
      setBending(EI, e);
  }
  return copy;
}

void CableModel::assemble(const NodeField& q, const NodeField& v, const NodeField& a, NodeField& residual) const
{
  for (NodeCoords& row : residual)
    row.setZero();
  for (int i = 0; i < elements(); ++i)
  {
    const ElementCoords r = elementResidualOf(i, q, v, a);
    residual[i] += r.head<6>();
    residual[i + 1] += r.tail<6>();
  }
}

void CableModel::assemble(const NodeField& q, const NodeField& v, const NodeField& a,
                          const TangentWeights& weights, NodeField& residual, BlockTridiagonal& tangent) const
{
  for (NodeCoords& row : residual)
    row.setZero();
  tangent.setZero();
  ElementCoords r;
  ElementMatrix J;
  for (int i = 0; i < elements(); ++i)
  {
    const ElementMotion motion{elementCoords(q, i), elementCoords(v, i), elementCoords(a, i)};
    elementResidual(elements_[i], sea_, motion, weights, r, J);
    residual[i] += r.head<6>();
    residual[i + 1] += r.tail<6>();
    tangent.addElement(i, J);
  }
}

ElementCoords CableModel::elementResidualOf(int i, const NodeField& q, const NodeField& v,
                                            const NodeField& a) const
{
  const ElementMotion motion{elementCoords(q, i), elementCoords(v, i), elementCoords(a, i)};
  ElementCoords r;
  elementResidual(elements_[i], sea_, motion, r);
  return r;
}

ElementEnergy CableModel::energy(const NodeField& q, const NodeField& v) const
{
  ElementEnergy sum{0.0, 0.0, 0.0, 0.0};
  for (int i = 0; i < elements(); ++i)
  {
    const ElementEnergy e = elementEnergy(elements_[i], sea_.gravity, elementCoords(q, i), elementCoords(v, i));
    sum.axial += e.axial;
    sum.bending += e.bending;
    sum.kinetic += e.kinetic;
    sum.weight += e.weight;
  }
  return sum;
}

}  // namespace tether_monitor::core
