#include "tether_monitor/core/cable/cable_layout.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
namespace
{
constexpr double SHORT_ELEMENT = 0.05;  // of a regular one, beside an attachment

struct Break
{
  double s;
  bool kink;
};

std::vector<Break> breaks(double length, const CableLayout& layout)
{
  std::vector<Break> all{{0.0, false}, {length, false}};
  for (const CableSection& section : layout.sections)
    for (const double s : {section.from, section.to})
      all.push_back({s, false});
  for (const Attachment& attachment : layout.attachments)
    all.push_back({attachment.s, true});
  std::sort(all.begin(), all.end(), [](const Break& a, const Break& b) { return a.s < b.s; });
  std::vector<Break> merged;
  for (const Break& next : all)
  {
    if (!merged.empty() && next.s - merged.back().s <= 1e-9 * length)
      merged.back().kink = merged.back().kink || next.kink;
    else
      merged.push_back(next);
  }
  return merged;
}

// Elements of each piece: one, and the rest where elements are longest.
std::vector<int> shareOut(const std::vector<Break>& at, int elements)
{
  std::vector<int> count(at.size() - 1, 1);
  for (int left = elements - static_cast<int>(count.size()); left > 0; --left)
  {
    std::size_t longest = 0;
    const auto size = [&](std::size_t i) { return (at[i + 1].s - at[i].s) / count[i]; };
    for (std::size_t i = 1; i < count.size(); ++i)
      if (size(i) > size(longest) * (1.0 + 1e-12))
        longest = i;
    ++count[longest];
  }
  return count;
}
}  // namespace

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
    for (std::string problem : validate(properties))
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

std::vector<double> meshNodes(double length, int elements, const CableLayout& layout)
{
  const std::vector<Break> at = breaks(length, layout);
  if (static_cast<int>(at.size()) - 1 > elements)
    return {};
  const std::vector<int> count = shareOut(at, elements);
  std::vector<double> nodes{0.0};
  for (std::size_t piece = 0; piece < count.size(); ++piece)
  {
    const double a = at[piece].s, b = at[piece + 1].s;
    const int n = count[piece];
    const bool short_first = at[piece].kink && n >= 2;
    const bool short_last = at[piece + 1].kink && n >= 2 + short_first;
    const double small = SHORT_ELEMENT * (b - a) / n;
    const double from = a + (short_first ? small : 0.0), to = b - (short_last ? small : 0.0);
    const int regular = n - short_first - short_last;
    if (short_first)
      nodes.push_back(from);
    for (int i = 1; i <= regular; ++i)
      nodes.push_back(i == regular ? to : from + (to - from) * i / regular);
    if (short_last)
      nodes.push_back(b);
  }
  return nodes;
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

double firstFixedPoint(double length, const CableLayout& layout)
{
  return breaks(length, layout)[1].s;
}

}  // namespace tether_monitor::core
