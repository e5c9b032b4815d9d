#include "tether_monitor/monitor/model/model_factory.h"

#include <algorithm>
#include <cmath>
#include <optional>

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
}  // namespace

bool isStateOf(const core::CableState& state, const core::CableModel& model)
{
  const std::size_t points = core::kernel::POINTS * static_cast<std::size_t>(model.elements());
  const std::size_t obstacles = model.environment().obstacles.size();
  for (const core::NodeField* field : {&state.q, &state.v, &state.a, &state.algorithmic_acceleration})
    if (field->size() != static_cast<std::size_t>(model.nodes()))
      return false;
  return state.allFinite() && state.obstacles.size() == obstacles &&
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
    model.setBodies({std::nullopt, body});
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

ModelSnapshot snapshotOf(const core::CableModel& model)
{
  ModelSnapshot memory;
  memory.reference_length = model.referenceLength();
  memory.elements = model.elements();
  memory.payout = model.payout();
  for (int i = 0; i < model.elements(); ++i)
    memory.drag_normal.push_back(model.element(i).drag_normal);
  memory.current = model.environment().current.samples();
  memory.obstacles = model.environment().obstacles;
  memory.epoch = model.sea().epoch();
  memory.origin = model.sea().origin();
  return memory;
}

std::optional<core::CableModel> restoreModel(const Config& config, const ModelSnapshot& memory)
{
  bool is_possible = memory.drag_normal.size() == static_cast<std::size_t>(std::max(memory.elements, 0)) &&
                     canMesh(config, memory.reference_length, memory.elements) &&
                     std::isfinite(memory.payout.rate) && std::isfinite(memory.payout.acceleration) &&
                     std::isfinite(memory.epoch) && memory.origin.allFinite() &&
                     core::validate(memory.current).empty();
  for (const double drag : memory.drag_normal)
    is_possible = is_possible && std::isfinite(drag) && drag >= 0.0;
  for (const core::Obstacle& obstacle : memory.obstacles)
    is_possible = is_possible && core::validate(obstacle, "").empty();
  if (!is_possible)
    return std::nullopt;
  core::CableModel model = makeModel(config, memory.reference_length, memory.elements);
  if (!model.canRepresentLength(memory.payout.length))
    return std::nullopt;
  model.sea().setEpoch(memory.epoch);
  model.sea().setOrigin(memory.origin);
  model.sea().setCurrent(core::CurrentProfile(memory.current));
  model.sea().setObstacles(memory.obstacles);
  model.setPayout(memory.payout);
  for (int i = 0; i < memory.elements; ++i)
    model.setDragNormal(i, memory.drag_normal[i]);
  return model;
}

}  // namespace tether_monitor::monitor
