#include "tether_monitor/monitor/deployed_model.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
// What is fixed to the tether keeps its distance from the vehicle end, as the tether pays out at the vessel; what
// has come aboard is left out.
core::CableFittings shifted(double by, core::CableFittings fittings)
{
  for (core::CableSection& section : fittings.sections)
  {
    section.from = section.from == 0.0 ? 0.0 : std::max(section.from + by, 0.0);
    section.to += by;
  }
  for (core::Attachment& attachment : fittings.attachments)
    attachment.s += by;
  const auto drop = [](auto& list, const auto& is_aboard)
  { list.erase(std::remove_if(list.begin(), list.end(), is_aboard), list.end()); };
  drop(fittings.sections, [](const core::CableSection& section) { return section.to <= 0.0; });
  drop(fittings.attachments, [](const core::Attachment& attachment) { return attachment.s <= 0.0; });
  return fittings;
}
}  // namespace

core::CableModel modelOf(const Config& config)
{
  core::CableModel model(config.tether, config.elements, config.environment, config.fittings);
  if (config.vehicle_mode == VehicleMode::FREE)
  {
    core::RigidBody body = config.vehicle_body;
    body.attachment = config.vehicle.attachment;
    model.setBodies({std::nullopt, body});
  }
  return model;
}

bool isPossibleLength(const Config& config, double length)
{
  if (!std::isfinite(length) || length <= 0.0)
    return false;
  const core::CableFittings fittings = shifted(length - config.tether.length, config.fittings);
  return core::problems(fittings, length).empty() &&
         core::elementCountProblems(config.elements, length, fittings).empty();
}

core::CableModel modelAt(const Config& config, double length)
{
  Config changed = config;
  changed.fittings = shifted(length - config.tether.length, config.fittings);
  changed.tether.length = length;
  return modelOf(changed);
}

}  // namespace tether_monitor::monitor
