#include "tether_monitor/core/assembly/deployed_cable.h"

#include <algorithm>

#include "tether_monitor/core/base/gravity.h"
#include "tether_monitor/core/element/element_coordinates.h"
#include "tether_monitor/core/element/slack_regularisation.h"

namespace tether_monitor::core
{
namespace
{
ElementParameters elementParameters(const CableProperties& p, double length, double gravity)
{
  const SlackRegularisation small = slackRegularisation(p, length, gravity);
  ElementParameters e;
  e.length = length;
  e.diameter = p.diameter;
  e.contact_diameter = p.contact_diameter.value_or(p.diameter);
  e.mass = p.mass_per_length;
  e.area = p.displacedArea();
  e.drag_normal = p.drag_normal;
  e.drag_tangential = p.drag_tangential;
  e.added_mass = p.added_mass_normal;
  e.added_mass_tangential = p.added_mass_tangential;
  e.compression = p.hydrostatic_compression;
  e.natural_stretch = 1.0 + p.permanent_elongation;
  e.axial = {p.axial_stiffness, p.axial_damping, small.compression_limit, small.compression_stiffness_ratio,
             p.axial_stiffening};
  e.bending_stiffness = small.bending_stiffness;
  return e;
}

// Of a clamp on an element at the end (M31).
double clampStiffness(const ElementParameters& e)
{
  return 1e4 * e.bending_stiffness / e.length;
}

// A jump that is none but for rounding.
bool isAlike(double a, double b)
{
  return std::abs(a - b) <= 1e-12 * std::abs(a + b);
}

bool isAlike(const AxialParameters& a, const AxialParameters& b)
{
  bool alike = isAlike(a.stiffness, b.stiffness) && a.stiffening.count == b.stiffening.count;
  for (int k = 0; alike && k < a.stiffening.count; ++k)
    alike = isAlike(a.stiffening.strain[k], b.stiffening.strain[k]) &&
            isAlike(a.stiffening.change[k], b.stiffening.change[k]);
  return alike;
}

SlopeTransition transitionTo(const ElementParameters& softer, const ElementParameters& own)
{
  return {true, softer.axial, own.axial, softer.natural_stretch, own.natural_stretch};
}

void vary(const PropertyVariation& by, ElementParameters& e)
{
  e.drag_normal *= by.drag_normal;
  e.drag_tangential *= by.drag_tangential;
  e.mass *= by.mass_per_length;
  e.natural_stretch *= by.length;
  e.axial.stiffness *= by.axial_stiffness;
  for (int k = 0; k < e.axial.stiffening.count; ++k)
    e.axial.stiffening.change[k] *= by.axial_stiffness;
}

// What the kernels are given in place of a joined element, or one that has parted: as long, but nothing acts on
// it.
ElementParameters withoutForces(ElementParameters e)
{
  e.mass = e.area = e.drag_normal = e.drag_tangential = e.added_mass = e.added_mass_tangential = 0.0;
  e.axial.stiffness = e.axial.damping = e.bending_stiffness = e.compression = 0.0;
  e.axial.stiffening = AxialStiffening();
  e.transport = AxialTransport();
  return e;
}
}  // namespace

DeployedCable::DeployedCable(const CableModel& model, const Deployment& deployment)
  : model_(model), deployment_(deployment), assembler_(model.elements())
{
  deployment_.drag_factor.reserve(model.elements());
  setElements();
}

void DeployedCable::update(const CableModel& model, const Deployment& deployment)
{
  const bool same_elements = !stiffened_ && model.sharesTether(model_) &&
                             hasSameElements(deployment, deployment_) &&
                             model.environment().gravity() == environment().gravity();
  if (!model.isSame(model_))
    model_ = model;
  if (same_elements)
    return;
  if (model.elements() != elements())
    assembler_ = ElementAssembler(model.elements());
  deployment_ = deployment;
  setElements();
}

void DeployedCable::setElement(int i, double growing, double& covered)
{
  const CableMesh& mesh = model_.mesh();
  const double gravity = environment().gravity();
  ElementParameters& e = elements_[i];
  if (i < mesh.growingElements() && deployment_.payout)
  {
    const PayoutState& payout = *deployment_.payout;
    const double fraction = mesh.growingFraction(i);
    CableProperties material = model_.elementProperties(i);
    material.length = payout.length;
    e = elementParameters(material, fraction * growing, gravity);
    AxialTransport& transport = e.transport;  // (M24)
    transport.active = payout.rate != 0.0 || payout.acceleration != 0.0;
    transport.growth = payout.rate / growing;
    transport.acceleration = payout.acceleration / growing;
    transport.speed_a = payout.rate * (1.0 - covered);
    transport.rate_a = payout.acceleration * (1.0 - covered);
    covered += fraction;
    transport.speed_b = payout.rate * (1.0 - covered);
    transport.rate_b = payout.acceleration * (1.0 - covered);
    arc_length_[i + 1] = arc_length_[i] + e.length;
  }
  else
  {
    e = elementParameters(model_.elementProperties(i), mesh.elementLength(i), gravity);
    arc_length_[i + 1] = mesh.arcLength(i + 1) + model_.length(deployment_) - model_.length();
  }
  if (!deployment_.drag_factor.empty())
    e.drag_normal *= deployment_.drag_factor[i];
  vary(deployment_.variation, e);
  if (deployment_.parted_element == i)
  {
    e = withoutForces(e);
    e.parted = true;
  }
}

void DeployedCable::setElements()
{
  stiffened_ = false;
  elements_.resize(model_.elements());
  arc_length_.resize(model_.nodes());
  arc_length_.front() = 0.0;
  const double growing = model_.length(deployment_) - model_.mesh().fixedLength();
  double covered = 0.0;  // fraction of the growing piece before an element
  for (int i = 0; i < elements(); ++i)
    setElement(i, growing, covered);
  joinAtStiffnessJumps();
  joined_.clear();
  for (int i = 0; i < elements(); ++i)
    passToAssembler(i);
  arc_length_.back() = model_.length(deployment_);
  updateScales();
}

// (M30)
void DeployedCable::joinAtStiffnessJumps()
{
  for (int i = 0; i + 1 < elements(); ++i)
  {
    ElementParameters &a = elements_[i], &b = elements_[i + 1];
    const bool is_alike = isAlike(a.axial, b.axial) && isAlike(a.natural_stretch, b.natural_stretch);
    if (is_alike || a.parted || b.parted)
      continue;
    if (a.axial.stiffness > b.axial.stiffness)
      a.at_b = transitionTo(b, a);
    else
      b.at_a = transitionTo(a, b);
  }
}

void DeployedCable::passToAssembler(int i)
{
  const ElementParameters& e = elements_[i];
  assembler_.set(i, e.isJoined() ? withoutForces(e) : e);
  if (e.isJoined())
    joined_.set(i, e);
}

int DeployedCable::elementAt(double s) const
{
  int i = 0;
  while (i + 1 < elements() && arc_length_[i + 1] <= s + 1e-9 * length())
    ++i;
  return i;
}

void DeployedCable::updateScales()
{
  mass_ = largest_stiffness_ = 0.0;
  for (const ElementParameters& e : elements_)
  {
    mass_ += e.length * e.mass;
    largest_stiffness_ = std::max(largest_stiffness_, e.axial.largestModulus() / e.length);
  }
  for (const LumpedAttachment& attachment : model_.lumpedAttachments())
    mass_ += attachment.mass;
  force_scale_ = STANDARD_GRAVITY * std::max(1.0, mass_);
}

void DeployedCable::stiffen(double floor)
{
  stiffened_ = true;
  for (int i = 0; i < elements(); ++i)
  {
    ElementParameters& e = elements_[i];
    const double EI = floor * e.mass * STANDARD_GRAVITY * e.length * e.length * e.length;
    e.bending_stiffness = std::max(EI, e.bending_stiffness);
    passToAssembler(i);
  }
}

void DeployedCable::assemble(const CableState& state, NodeField& residual) const
{
  for (NodeCoords& row : residual)
    row.setZero();
  std::array<ElementCoords, kernel::BLOCK> parts;
  for (int first = 0; first < elements(); first += kernel::BLOCK)
  {
    const int count = std::min(kernel::BLOCK, elements() - first);
    assembler_.residuals(model_.kernel(), environment(), state, first, count, parts.data());
    for (int i = 0; i < count; ++i)
    {
      residual[first + i] += parts[i].head<6>();
      residual[first + i + 1] += parts[i].tail<6>();
    }
  }
  joined_.addTo(model_.kernel(), environment(), state, residual);
  residual.front().tail<3>() += vesselClamp(state).residual(state.q.front().tail<3>());
  residual.back().tail<3>() += vehicleClamp(state).residual(state.q.back().tail<3>());
  for (const LumpedAttachment& attachment : model_.lumpedAttachments())
    addLumpedAttachment(attachment, environment(), state, residual);
  if (environment().hasContact())
    addContact(contactScene(state), TangentWeights{}, residual, nullptr, nullptr);
}

void DeployedCable::assemble(const CableState& state, const TangentWeights& weights, NodeField& residual,
                             BlockTridiagonal& tangent, TangentKind kind, BorderedSystem* bordered) const
{
  assembler_.assemble(model_.kernel(), environment(), state, weights, kind, residual, tangent);
  joined_.addTo(model_.kernel(), environment(), state, weights, kind, residual, tangent);
  const auto clamp = [&](const ClampedEnd& end, int node)
  {
    if (end.isHinged())
      return;
    const Vector3 slope = state.q[node].tail<3>();
    residual[node].tail<3>() += end.residual(slope);
    tangent.diagonal(node).bottomRightCorner<3, 3>() += weights.stiffness * end.tangent(slope);
  };
  clamp(vesselClamp(state), 0);
  clamp(vehicleClamp(state), elements());
  for (const LumpedAttachment& attachment : model_.lumpedAttachments())
    addLumpedAttachment(attachment, environment(), state, weights, residual, tangent);
  if (environment().hasContact())
    addContact(contactScene(state), weights, residual, &tangent, bordered);
}

ClampedEnd DeployedCable::vesselClamp(const CableState& state) const
{
  return {clampStiffness(elements_.front()), state.clamps.vessel};
}

ClampedEnd DeployedCable::vehicleClamp(const CableState& state) const
{
  return {clampStiffness(elements_.back()), state.clamps.vehicle};
}

int DeployedCable::elementResiduals(int first, const CableState& state,
                                    std::array<ElementCoords, kernel::BLOCK>& out) const
{
  const int count = std::min(kernel::BLOCK, elements() - first);
  assembler_.residuals(model_.kernel(), environment(), state, first, count, out.data());
  for (int i = 0; i < count; ++i)
    if (elements_[first + i].isJoined())
      out[i] = joined_.residual(first + i, model_.kernel(), environment(), state);
  if (environment().hasContact())
    for (int i = 0; i < count; ++i)
      out[i] += elementContact(contactScene(state), first + i);
  return count;
}

ElementEnergy DeployedCable::energy(const NodeField& q, const NodeField& v) const
{
  ElementEnergy sum{0.0, 0.0, 0.0, 0.0};
  for (int i = 0; i < elements(); ++i)
  {
    const ElementParameters& p = elements_[i];
    const ElementEnergy e =
        elementEnergy(p, environment().gravity(), elementCoords(p, q, i), elementRates(p, q, v, i));
    sum.axial += e.axial;
    sum.bending += e.bending;
    sum.kinetic += e.kinetic;
    sum.weight += e.weight;
  }
  return sum;
}

void initializeContact(const CableModel& model, CableState& state)
{
  DeployedCable(model, state.deployment).initializeContact(state);
}

}  // namespace tether_monitor::core
