#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/core/cable/cable_properties.h"

namespace tether_monitor::core
{
/// A stretch of tether with properties of its own.
struct CableSection
{
  double from = 0.0;           ///< s [m], 0 <= from < to.
  double to = 0.0;             ///< s [m], to <= length. Sections do not overlap.
  CableProperties properties;  ///< complete; `length` is not used.
};

/// A weight, float or buoy fixed to the tether: a point with weight, buoyancy, drag and inertia.
struct Attachment
{
  std::string name;
  double s = 0.0;          ///< [m], 0 < s < length.
  double mass = 0.0;       ///< [kg], >= 0.
  double volume = 0.0;     ///< displaced [m^3], >= 0.
  double drag_area = 0.0;  ///< CdA [m^2], >= 0: drag 1/2 rho CdA |u| u.
};

/// What makes a tether differ along its length. Default: nothing.
struct CableLayout
{
  std::vector<CableSection> sections;
  std::vector<Attachment> attachments;
};

/// Every bound of the layout of a tether of the given length [m] that is violated, one sentence each.
std::vector<std::string> validate(const CableLayout& layout, double length);

/// Least allowed bend radius by which a tether is judged [m]: its own, else the smallest of its sections, if any
/// has one.
std::optional<double> bendLimit(const CableProperties& tether, const CableLayout& layout);

}  // namespace tether_monitor::core
