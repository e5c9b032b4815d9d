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

/**
 * Arc lengths of the nodes of a mesh: a node on every section boundary and attachment, elements shared out by
 * length. Next to an attachment an element is short, since the tether has a kink there that a smooth element would
 * round off.
 *
 * @return  elements + 1 values from 0 to length; empty if there are fewer elements than pieces between layout.
 */
std::vector<double> meshNodes(double length, int elements, const CableLayout& layout);

/// Least allowed bend radius by which a tether is judged [m]: its own, else the smallest of its sections, if any
/// has one.
std::optional<double> bendLimit(const CableProperties& tether, const CableLayout& layout);

/// First section boundary or attachment from the vessel end, else the length [m]: up to there the mesh can grow
/// when the tether is paid out.
double firstFixedPoint(double length, const CableLayout& layout);

}  // namespace tether_monitor::core
