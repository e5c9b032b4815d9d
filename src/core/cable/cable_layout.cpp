#include "tether_monitor/core/cable/cable_layout.h"

#include <algorithm>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
std::vector<std::string> validate(const CableLayout& layout, double length)
{
  std::vector<std::string> all;
  const auto add = [&](const std::vector<std::string>& more) { all.insert(all.end(), more.begin(), more.end()); };
  for (std::size_t i = 0; i < layout.sections.size(); ++i)
  {
    const CableSection& section = layout.sections[i];
    const std::string prefix = "tether.sections[" + std::to_string(i) + "].";
    BoundsCheck check(prefix);
    check.check(section.from >= 0.0 && section.from < section.to, "from", section.from, ">= 0 m and < to");
    check.check(section.to <= length, "to", section.to, "<= length");
    for (std::size_t j = 0; j < i; ++j)
      check.check(section.from >= layout.sections[j].to || section.to <= layout.sections[j].from, "from",
                  section.from, "outside of section " + std::to_string(j));
    add(check.problems());
    CableProperties properties = section.properties;
    properties.length = length;
    for (const std::string& problem : validate(properties))
      all.push_back(prefix + problem.substr(std::string("tether.").size()));
  }
  for (std::size_t i = 0; i < layout.attachments.size(); ++i)
  {
    const Attachment& attachment = layout.attachments[i];
    BoundsCheck check("tether.attachments[" + std::to_string(i) + "].");
    check.check(attachment.s > 0.0 && attachment.s < length, "s", attachment.s, "> 0 m and < length");
    check.notNegative("mass", attachment.mass, "kg");
    check.notNegative("volume", attachment.volume, "m^3");
    check.notNegative("drag_area", attachment.drag_area, "m^2");
    add(check.problems());
  }
  return all;
}

std::optional<double> bendLimit(const CableProperties& tether, const CableLayout& layout)
{
  std::optional<double> limit = tether.min_bend_radius;
  if (!limit)
    for (const CableSection& section : layout.sections)
      if (section.properties.min_bend_radius)
        limit = std::min(limit.value_or(*section.properties.min_bend_radius), *section.properties.min_bend_radius);
  return limit;
}

}  // namespace tether_monitor::core
