#include "tether_monitor/core/assembly/joined_elements.h"

#include "tether_monitor/core/element/element_coordinates.h"

namespace tether_monitor::core
{
namespace
{
void split(const ElementCoords& e, NodeField& nodes)
{
  nodes[0] = e.head<6>();
  nodes[1] = e.tail<6>();
}
}  // namespace

JoinedElements::JoinedElements() : alone_(0.0, NodeField(2), Vector3::Zero()), residual_(2), tangent_(2)
{
}

int JoinedElements::find(int i) const
{
  int k = 0;
  while (k < count_ && elements_[k].index != i)
    ++k;
  return k;
}

void JoinedElements::set(int i, const ElementParameters& p)
{
  const int k = find(i);
  if (k == count_)
    ++count_;
  if (k == static_cast<int>(elements_.size()))
    elements_.emplace_back();
  elements_[k].index = i;
  elements_[k].parameters = p;
  elements_[k].assembler.set(0, p);
}

void JoinedElements::place(const Element& element, const CableState& state) const
{
  const ElementParameters& p = element.parameters;
  alone_.time = state.time;
  alone_.deployment.variation = state.deployment.variation;
  split(elementCoords(p, state.q, element.index), alone_.q);
  split(elementRates(p, state.q, state.v, element.index), alone_.v);
  split(elementAccelerations(p, state.q, state.v, state.a, element.index), alone_.a);
}

ElementCoords JoinedElements::residual(int i, const kernel::Kernel& kernel, const EnvironmentModel& environment,
                                       const CableState& state) const
{
  const Element& element = elements_[find(i)];
  place(element, state);
  ElementCoords force;
  element.assembler.residuals(kernel, environment, alone_, 0, 1, &force);
  return force;
}

void JoinedElements::addTo(const kernel::Kernel& kernel, const EnvironmentModel& environment,
                           const CableState& state, NodeField& residual) const
{
  for (int k = 0; k < count_; ++k)
  {
    const int i = elements_[k].index;
    ElementCoords force = this->residual(i, kernel, environment, state);
    pullBack(elements_[k].parameters, state.q, i, force);
    residual[i] += force.head<6>();
    residual[i + 1] += force.tail<6>();
  }
}

void JoinedElements::addTo(const kernel::Kernel& kernel, const EnvironmentModel& environment,
                           const CableState& state, const TangentWeights& weights, TangentKind kind,
                           NodeField& residual, BlockTridiagonal& tangent) const
{
  for (int k = 0; k < count_; ++k)
  {
    const Element& element = elements_[k];
    const int i = element.index;
    place(element, state);
    element.assembler.assemble(kernel, environment, alone_, weights, kind, residual_, tangent_);
    ElementCoords force = elementCoords(residual_, 0);
    ElementMatrix matrix;
    matrix << tangent_.diagonal(0), tangent_.upper(0), tangent_.lower(0), tangent_.diagonal(1);
    pullBack(element.parameters, state.q, i, weights.stiffness, force, matrix);
    residual[i] += force.head<6>();
    residual[i + 1] += force.tail<6>();
    tangent.addElement(i, matrix);
  }
}

}  // namespace tether_monitor::core
