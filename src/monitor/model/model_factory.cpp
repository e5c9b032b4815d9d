#include "tether_monitor/monitor/model/model_factory.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tether_monitor/core/kernel/kernel.h"
#include "tether_monitor/core/solve/mesh_convergence.h"

namespace tether_monitor::monitor
{
namespace
{
// What is fixed to the tether keeps its distance from the vehicle end, as the tether pays out at the vessel; what
// has come aboard is left out.
core::CableLayout shifted(double by, core::CableLayout layout)
{
  for (core::CableSection& section : layout.sections)
  {
    section.from = section.from == 0.0 ? 0.0 : std::max(section.from + by, 0.0);
    section.to += by;
  }
  for (core::Attachment& attachment : layout.attachments)
    attachment.s += by;
  const auto drop = [](auto& list, const auto& is_aboard)
  { list.erase(std::remove_if(list.begin(), list.end(), is_aboard), list.end()); };
  drop(layout.sections, [](const core::CableSection& section) { return section.to <= 0.0; });
  drop(layout.attachments, [](const core::Attachment& attachment) { return attachment.s <= 0.0; });
  return layout;
}

bool isEmptyOr(std::size_t count, std::size_t size)
{
  return size == 0 || size == count;
}

bool isDeploymentOf(const core::Deployment& deployment, const core::CableModel& model)
{
  const auto is_factor = [](double x) { return std::isfinite(x) && x >= 0.0; };
  if (!isEmptyOr(static_cast<std::size_t>(model.elements()), deployment.drag_factor.size()) ||
      !std::all_of(deployment.drag_factor.begin(), deployment.drag_factor.end(), is_factor))
    return false;
  if (deployment.parted_element.value_or(0) < 0 || deployment.parted_element.value_or(0) >= model.elements())
    return false;
  const std::optional<core::PayoutState>& payout = deployment.payout;
  return !payout || (model.canRepresentLength(payout->length) && std::isfinite(payout->rate) &&
                     std::isfinite(payout->acceleration));
}
}  // namespace

bool isStateOf(const core::CableState& state, const core::CableModel& model)
{
  const std::size_t points = core::kernel::POINTS * static_cast<std::size_t>(model.elements());
  const std::size_t obstacles = model.environment().obstacles().size();
  for (const core::NodeField* field : {&state.q, &state.v, &state.a, &state.algorithmic_acceleration})
    if (field->size() != static_cast<std::size_t>(model.nodes()))
      return false;
  return state.allFinite() && isDeploymentOf(state.deployment, model) && state.obstacles.size() == obstacles &&
         isEmptyOr(points, state.contact.seabed.size()) && isEmptyOr(points, state.contact.obstacle.size()) &&
         state.contact.obstacle_position.size() == obstacles &&
         state.contact.friction >= core::FrictionMode::COULOMB &&
         state.contact.friction <= core::FrictionMode::STICK;
}

core::CableModel makeModel(const Config& config)
{
  core::CableModel model(config.tether, config.elements, config.environment, config.layout);
  if (config.vehicle_mode != VehicleMode::TRACKED)
  {
    core::RigidBody body = config.vehicle_body;
    body.attachment = config.vehicle.attachment;
    return model.withBodies({std::nullopt, body});
  }
  return model;
}

bool canMesh(const Config& config, double length, int elements)
{
  if (!std::isfinite(length) || length <= 0.0)
    return false;
  const core::CableLayout layout = shifted(length - config.tether.length, config.layout);
  return core::validate(layout, length).empty() && core::validateElementCount(elements, length, layout).empty();
}

core::CableModel makeModel(const Config& config, double length, int elements)
{
  Config changed = config;
  changed.elements = elements;
  changed.layout = shifted(length - config.tether.length, config.layout);
  changed.tether.length = length;
  return makeModel(changed);
}

bool canDeploy(const Config& config, const core::CableModel& model, double length)
{
  return model.canRepresentLength(length) ||
         canMesh(config, length, config.accuracy ? core::MOST_ELEMENTS : config.elements);
}

}  // namespace tether_monitor::monitor
