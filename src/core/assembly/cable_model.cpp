#include "tether_monitor/core/assembly/cable_model.h"

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
CableModel::CableModel(const CableProperties& properties, int elements, const Environment& environment,
                       const CableLayout& layout)
  : environment_(std::make_shared<const EnvironmentModel>(environment)),
    bodies_(std::make_shared<const EndBodies>())
{
  std::vector<std::string> problems = validate(properties);
  for (const auto& more :
       {validate(layout, properties.length), validateElementCount(elements, properties.length, layout)})
    problems.insert(problems.end(), more.begin(), more.end());
  throwIfInvalid("tether model", problems);

  Tether tether{
      {properties}, CableMesh(properties.length, elements, layout), {}, core::bendLimit(properties, layout)};
  for (const CableSection& section : layout.sections)
  {
    tether.materials.push_back(section.properties);
    tether.materials.back().length = properties.length;
  }
  for (const Attachment& attachment : layout.attachments)
    tether.attachments.push_back(
        {tether.mesh.nearestNode(attachment.s), attachment.mass, attachment.volume, attachment.drag_area});
  tether_ = std::make_shared<const Tether>(std::move(tether));
}

CableModel CableModel::withEnvironment(const EnvironmentModel& environment) const
{
  CableModel changed = *this;
  changed.environment_ = std::make_shared<const EnvironmentModel>(environment);
  return changed;
}

CableModel CableModel::withBodies(const EndBodies& bodies) const
{
  std::vector<std::string> problems;
  if (bodies.vessel)
    problems = validate(*bodies.vessel, "vessel.");
  if (bodies.vehicle)
    for (const std::string& problem : validate(*bodies.vehicle, "vehicle."))
      problems.push_back(problem);
  throwIfInvalid("bodies at the tether's ends", problems);
  CableModel changed = *this;
  changed.bodies_ = std::make_shared<const EndBodies>(bodies);
  return changed;
}

CableModel CableModel::withKernel(const kernel::Kernel& kernel) const
{
  CableModel changed = *this;
  changed.kernel_ = &kernel;
  return changed;
}

}  // namespace tether_monitor::core
