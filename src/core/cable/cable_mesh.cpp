#include "tether_monitor/core/cable/cable_mesh.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
namespace
{
constexpr int MAX_ELEMENTS = 5000;
constexpr double SHORT_ELEMENT = 0.05;     // of a regular one, beside an attachment
constexpr double SHORTEST_GROWING = 0.05;  // of a regular one, when the tether is hauled in
constexpr double LONGEST_GROWING = 10.0;   // over what grows as built, when it is paid out

struct Breakpoint
{
  double s;
  bool is_attachment;
};

std::vector<Breakpoint> breakpoints(double length, const CableLayout& layout)
{
  std::vector<Breakpoint> all{{0.0, false}, {length, false}};
  for (const CableSection& section : layout.sections)
    for (const double s : {section.from, section.to})
      all.push_back({s, false});
  for (const Attachment& attachment : layout.attachments)
    all.push_back({attachment.s, true});
  std::sort(all.begin(), all.end(), [](const Breakpoint& a, const Breakpoint& b) { return a.s < b.s; });
  std::vector<Breakpoint> merged;
  for (const Breakpoint& next : all)
  {
    if (!merged.empty() && next.s - merged.back().s <= 1e-9 * length)
      merged.back().is_attachment = merged.back().is_attachment || next.is_attachment;
    else
      merged.push_back(next);
  }
  return merged;
}

// Elements of each piece: one, and the rest where elements are longest.
std::vector<int> distributeElements(const std::vector<Breakpoint>& at, int elements)
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

std::vector<double> nodePositions(const std::vector<Breakpoint>& at, int elements)
{
  const std::vector<int> count = distributeElements(at, elements);
  std::vector<double> nodes{0.0};
  for (std::size_t piece = 0; piece < count.size(); ++piece)
  {
    const double a = at[piece].s, b = at[piece + 1].s;
    const int n = count[piece];
    const bool short_first = at[piece].is_attachment && n >= 2;
    const bool short_last = at[piece + 1].is_attachment && n >= 2 + short_first;
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

int materialAt(double s, const CableLayout& layout)
{
  int material = 0;
  for (std::size_t k = 0; k < layout.sections.size(); ++k)
    if (s > layout.sections[k].from && s < layout.sections[k].to)
      material = static_cast<int>(k) + 1;
  return material;
}
}  // namespace

CableMesh::CableMesh(double length, int elements, const CableLayout& layout)
{
  std::vector<std::string> problems = validate(layout, length);
  for (const std::string& problem : validateElementCount(elements, length, layout))
    problems.push_back(problem);
  throwIfInvalid("tether mesh", problems);

  const std::vector<Breakpoint> at = breakpoints(length, layout);
  arc_length_ = nodePositions(at, elements);
  const double grows_to = at[1].s;
  fixed_length_ = length - grows_to;
  for (int i = 0; i < elements; ++i)
  {
    element_length_.push_back(arc_length_[i + 1] - arc_length_[i]);
    const double middle = 0.5 * (arc_length_[i + 1] + arc_length_[i]);
    material_index_.push_back(materialAt(middle, layout));
    if (middle < grows_to)
    {
      growing_fraction_.push_back(element_length_.back() / grows_to);
      element_length_.back() = growing_fraction_.back() * grows_to;  // rounded as when it is paid out
    }
  }
}

int CableMesh::nearestNode(double s) const
{
  const auto nearest = std::min_element(arc_length_.begin(), arc_length_.end(),
                                        [&](double x, double y) { return std::abs(x - s) < std::abs(y - s); });
  return static_cast<int>(nearest - arc_length_.begin());
}

bool CableMesh::canRepresentLength(double length) const
{
  const double growing = length - fixed_length_;
  const double regular = this->length() / elements() * growingElements();
  return std::isfinite(length) && growing > SHORTEST_GROWING * regular &&
         growing < LONGEST_GROWING * std::max(regular, this->length() - fixed_length_);
}

std::vector<std::string> validateElementCount(int elements)
{
  BoundsCheck check("tether.");
  check.check(elements >= 1 && elements <= MAX_ELEMENTS, "elements", elements,
              ">= 1 and <= " + std::to_string(MAX_ELEMENTS) +
                  ": more gain nothing, and neither steps nor starts keep up with real time");
  return check.problems();
}

std::vector<std::string> validateElementCount(int elements, double length, const CableLayout& layout)
{
  std::vector<std::string> found = validateElementCount(elements);
  const bool meshable = found.empty() && std::isfinite(length) && length > 0.0 && validate(layout, length).empty();
  if (meshable && static_cast<int>(breakpoints(length, layout).size()) - 1 > elements)
    found.push_back("tether.elements = " + std::to_string(elements) +
                    " (must be enough for one between neighbouring sections and attachments)");
  return found;
}

}  // namespace tether_monitor::core
