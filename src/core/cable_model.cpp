#include "tether_monitor/core/cable_model.h"

#include <algorithm>
#include <cmath>

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

std::vector<std::string> elementCountProblems(int elements, double length, const CableFittings& fittings)
{
  std::vector<std::string> found = elementCountProblems(elements);
  const bool meshable = found.empty() && std::isfinite(length) && length > 0.0;
  if (meshable && problems(fittings, length).empty() && meshNodes(length, elements, fittings).empty())
    found.push_back("tether.elements = " + std::to_string(elements) +
                    " (must be enough for one between neighbouring sections and attachments)");
  return found;
}

CableModel::CableModel(const CableProperties& properties, int elements, const Environment& sea,
                       const CableFittings& fittings)
  : properties_(properties), sea_(sea)
{
  std::vector<std::string> faults = problems(properties);
  for (const auto& more : {problems(sea), problems(fittings, properties.length),
                           elementCountProblems(elements, properties.length, fittings)})
    faults.insert(faults.end(), more.begin(), more.end());
  throwIfAny("tether model", faults);

  kinds_.push_back(properties);
  for (const CableSection& section : fittings.sections)
  {
    kinds_.push_back(section.properties);
    kinds_.back().length = properties.length;
  }
  arc_length_ = meshNodes(properties.length, elements, fittings);
  double mass = 0.0;
  for (int i = 0; i < elements; ++i)
  {
    const double length = arc_length_[i + 1] - arc_length_[i];
    const double middle = 0.5 * (arc_length_[i + 1] + arc_length_[i]);
    kind_.push_back(0);
    for (std::size_t k = 0; k < fittings.sections.size(); ++k)
      if (middle > fittings.sections[k].from && middle < fittings.sections[k].to)
        kind_.back() = static_cast<int>(k) + 1;
    elements_.push_back(elementParameters(kinds_[kind_.back()], length, sea.gravity));
    mass += length * elements_.back().mass;
    largest_stiffness_ = std::max(largest_stiffness_, elements_.back().axial.stiffness / length);
  }
  for (const Attachment& attachment : fittings.attachments)
  {
    const auto nearest = std::min_element(arc_length_.begin(), arc_length_.end(),
                                          [&](double x, double y)
                                          { return std::abs(x - attachment.s) < std::abs(y - attachment.s); });
    point_loads_.push_back({static_cast<int>(nearest - arc_length_.begin()), attachment.mass, attachment.volume,
                            attachment.drag_area});
    mass += attachment.mass;
  }
  force_scale_ = 9.81 * std::max(1.0, mass);
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
  for (const PointLoad& load : point_loads_)
    residual[load.node].head<3>() += pointLoadResidual(load, sea_, q[load.node].head<3>(), v[load.node].head<3>(),
                                                       a[load.node].head<3>(), TangentWeights{}, nullptr);
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
  Matrix3 block;
  for (const PointLoad& load : point_loads_)
  {
    residual[load.node].head<3>() += pointLoadResidual(load, sea_, q[load.node].head<3>(), v[load.node].head<3>(),
                                                       a[load.node].head<3>(), weights, &block);
    tangent.diagonal(load.node).topLeftCorner<3, 3>() += block;
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
