#include "tether_monitor/core/assembly/cable_model.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"
#include "tether_monitor/core/element/slack_regularisation.h"

namespace tether_monitor::core
{
namespace
{
constexpr int MAX_ELEMENTS = 100000;

ElementParameters elementParameters(const CableProperties& p, double length, double gravity)
{
  const SlackRegularisation small = slackRegularisation(p, length, gravity);
  ElementParameters e;
  e.length = length;
  e.diameter = p.diameter;
  e.mass = p.mass_per_length;
  e.area = p.displacedArea();
  e.drag_normal = p.drag_normal;
  e.drag_tangential = p.drag_tangential;
  e.added_mass = p.added_mass_normal;
  e.compression = p.hydrostatic_compression;
  e.natural_stretch = 1.0 + p.permanent_elongation;
  e.axial = {p.axial_stiffness, p.axial_damping, small.compression_limit, small.residual};
  e.bending_stiffness = small.bending_stiffness;
  return e;
}
}  // namespace

std::vector<std::string> validateElementCount(int elements)
{
  BoundsCheck check("tether.");
  check.check(elements >= 1 && elements <= MAX_ELEMENTS, "elements", elements,
              ">= 1 and <= " + std::to_string(MAX_ELEMENTS));
  return check.problems();
}

std::vector<std::string> validateElementCount(int elements, double length, const CableLayout& layout)
{
  std::vector<std::string> found = validateElementCount(elements);
  const bool meshable = found.empty() && std::isfinite(length) && length > 0.0;
  if (meshable && validate(layout, length).empty() && meshNodes(length, elements, layout).empty())
    found.push_back("tether.elements = " + std::to_string(elements) +
                    " (must be enough for one between neighbouring sections and attachments)");
  return found;
}

CableModel::CableModel(const CableProperties& properties, int elements, const Environment& sea,
                       const CableLayout& layout)
  : properties_(properties), sea_(sea), field_(std::clamp(elements, 1, MAX_ELEMENTS))
{
  std::vector<std::string> faults = validate(properties);
  for (const auto& more :
       {validate(layout, properties.length), validateElementCount(elements, properties.length, layout)})
    faults.insert(faults.end(), more.begin(), more.end());
  throwIfInvalid("tether model", faults);

  materials_.push_back(properties);
  for (const CableSection& section : layout.sections)
  {
    materials_.push_back(section.properties);
    materials_.back().length = properties.length;
  }
  arc_length_ = meshNodes(properties.length, elements, layout);
  const double grows_to = firstFixedPoint(properties.length, layout);
  for (int i = 0; i < elements; ++i)
  {
    double length = arc_length_[i + 1] - arc_length_[i];
    const double middle = 0.5 * (arc_length_[i + 1] + arc_length_[i]);
    material_index_.push_back(0);
    for (std::size_t k = 0; k < layout.sections.size(); ++k)
      if (middle > layout.sections[k].from && middle < layout.sections[k].to)
        material_index_.back() = static_cast<int>(k) + 1;
    if (middle < grows_to)
    {
      growing_fraction_.push_back(length / grows_to);
      length = growing_fraction_.back() * grows_to;  // as setPayout() rounds it
    }
    elements_.push_back(elementParameters(materials_[material_index_.back()], length, sea.gravity));
  }
  fixed_length_ = properties.length - grows_to;
  reference_length_ = properties.length;
  reference_arc_length_ = arc_length_;
  payout_.length = properties.length;
  bend_limit_ = core::bendLimit(properties, layout);
  for (const Attachment& attachment : layout.attachments)
  {
    const auto nearest = std::min_element(arc_length_.begin(), arc_length_.end(),
                                          [&](double x, double y)
                                          { return std::abs(x - attachment.s) < std::abs(y - attachment.s); });
    lumped_attachments_.push_back({static_cast<int>(nearest - arc_length_.begin()), attachment.mass,
                                   attachment.volume, attachment.drag_area});
  }
  for (int i = 0; i < elements; ++i)
    field_.set(i, elements_[i]);
  updateScales();
}

void CableModel::updateScales()
{
  double mass = 0.0;
  largest_stiffness_ = 0.0;
  for (const ElementParameters& e : elements_)
  {
    mass += e.length * e.mass;
    largest_stiffness_ = std::max(largest_stiffness_, e.axial.stiffness / e.length);
  }
  for (const LumpedAttachment& load : lumped_attachments_)
    mass += load.mass;
  mass_ = mass;
  force_scale_ = 9.81 * std::max(1.0, mass);
}

void CableModel::setBodies(const EndBodies& bodies)
{
  std::vector<std::string> faults;
  if (bodies.vessel)
    faults = validate(*bodies.vessel, "vessel.");
  if (bodies.vehicle)
    for (const std::string& fault : validate(*bodies.vehicle, "vehicle."))
      faults.push_back(fault);
  throwIfInvalid("bodies at the tether's ends", faults);
  bodies_ = bodies;
}

void CableModel::setDragFactor(int i, double factor)
{
  elements_[i].drag_normal = elementProperties(i).drag_normal * factor;
  field_.set(i, elements_[i]);
}

void CableModel::setDragNormal(int i, double coefficient)
{
  elements_[i].drag_normal = coefficient;
  field_.set(i, elements_[i]);
}

bool CableModel::canRepresentLength(double length) const
{
  const double growing = length - fixed_length_;
  const double regular = reference_length_ / elements() * growing_fraction_.size();
  return std::isfinite(length) && growing > 0.05 * regular &&
         growing < 10.0 * std::max(regular, reference_length_ - fixed_length_);
}

void CableModel::setPayout(const PayoutState& payout)
{
  const bool rests = payout.rate == 0.0 && payout.acceleration == 0.0;
  if (rests && payout.length == length() && !elements_.front().flow.active)
    return;  // a winch that stands still and says so at every step
  payout_ = payout;
  const double growing = payout.length - fixed_length_;
  for (CableProperties& kind : materials_)
    kind.length = payout.length;
  double covered = 0.0;  // share of the growing piece before an element
  const double change = payout.length - reference_length_;
  for (int i = 0; i < elements(); ++i)
  {
    if (i >= static_cast<int>(growing_fraction_.size()))
    {
      arc_length_[i + 1] = reference_arc_length_[i + 1] + change;
      continue;
    }
    ElementParameters& e = elements_[i];
    const double share = growing_fraction_[i];
    const double drag = e.drag_normal;
    e = elementParameters(elementProperties(i), share * growing, sea_.gravity());
    e.drag_normal = drag;
    AxialTransport& flow = e.flow;
    flow.active = !rests;
    flow.growth = payout.rate / growing;
    flow.acceleration = payout.acceleration / growing;
    flow.speed_a = payout.rate * (1.0 - covered);
    flow.rate_a = payout.acceleration * (1.0 - covered);
    covered += share;
    flow.speed_b = payout.rate * (1.0 - covered);
    flow.rate_b = payout.acceleration * (1.0 - covered);
    arc_length_[i + 1] = arc_length_[i] + e.length;
    field_.set(i, e);
  }
  arc_length_.back() = payout.length;
  properties_.length = payout.length;
  updateScales();
}

CableModel CableModel::stiffened(double floor) const
{
  CableModel copy = *this;
  for (int i = 0; i < elements(); ++i)
  {
    ElementParameters& e = copy.elements_[i];
    const double EI = floor * e.mass * 9.81 * e.length * e.length * e.length;
    e.bending_stiffness = std::max(EI, e.bending_stiffness);
    copy.field_.set(i, e);
  }
  return copy;
}

void CableModel::assemble(const CableState& state, NodeField& residual) const
{
  for (NodeCoords& row : residual)
    row.setZero();
  std::array<ElementCoords, kernel::BLOCK> parts;
  for (int first = 0; first < elements(); first += kernel::BLOCK)
  {
    const int count = std::min(kernel::BLOCK, elements() - first);
    field_.residuals(*kernel_, sea_, state, first, count, parts.data());
    for (int i = 0; i < count; ++i)
    {
      residual[first + i] += parts[i].head<6>();
      residual[first + i + 1] += parts[i].tail<6>();
    }
  }
  for (const LumpedAttachment& load : lumped_attachments_)
    residual[load.node].head<3>() += lumpedAttachmentResidual(
        load, sea_, state.time, state.q[load.node].head<3>(), state.v[load.node].head<3>(),
        state.a[load.node].head<3>(), TangentWeights{}, nullptr);
  if (hasContact())
    addContact(*this, state, TangentWeights{}, residual, nullptr, nullptr);
}

void CableModel::assemble(const CableState& state, const TangentWeights& weights, NodeField& residual,
                          BlockTridiagonal& tangent, TangentKind kind, BorderedSystem* border) const
{
  field_.assemble(*kernel_, sea_, state, weights, kind, residual, tangent);
  Matrix3 block;
  for (const LumpedAttachment& load : lumped_attachments_)
  {
    residual[load.node].head<3>() +=
        lumpedAttachmentResidual(load, sea_, state.time, state.q[load.node].head<3>(),
                                 state.v[load.node].head<3>(), state.a[load.node].head<3>(), weights, &block);
    tangent.diagonal(load.node).topLeftCorner<3, 3>() += block;
  }
  if (hasContact())
    addContact(*this, state, weights, residual, &tangent, border);
}

int CableModel::elementResiduals(int first, const CableState& state,
                                 std::array<ElementCoords, kernel::BLOCK>& out) const
{
  const int count = std::min(kernel::BLOCK, elements() - first);
  field_.residuals(*kernel_, sea_, state, first, count, out.data());
  if (hasContact())
    for (int i = 0; i < count; ++i)
      out[i] += elementContact(*this, first + i, state);
  return count;
}

ElementEnergy CableModel::energy(const NodeField& q, const NodeField& v) const
{
  ElementEnergy sum{0.0, 0.0, 0.0, 0.0};
  for (int i = 0; i < elements(); ++i)
  {
    const ElementEnergy e = elementEnergy(elements_[i], sea_.gravity(), elementCoords(q, i), elementCoords(v, i));
    sum.axial += e.axial;
    sum.bending += e.bending;
    sum.kinetic += e.kinetic;
    sum.weight += e.weight;
  }
  return sum;
}

}  // namespace tether_monitor::core
