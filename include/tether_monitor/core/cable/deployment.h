#pragma once

#include <optional>
#include <vector>

#include "tether_monitor/core/cable/payout_trajectory.h"
#include "tether_monitor/core/cable/property_variation.h"

namespace tether_monitor::core
{
/// What changes of a tether's elements while it is in use. Default: as built.
struct Deployment
{
  std::optional<PayoutState> payout;  ///< deployed length and its rates; none: at rest, as long as it was built.
  std::vector<double> drag_factor;    ///< on the normal drag of every element [-], >= 1, for vortex-induced
                                      ///< vibration; empty: 1.
  std::optional<int> parted_element = std::nullopt;  ///< the element that has parted: it holds nothing any more.
  PropertyVariation variation = {};

  template <class Archive>
  void serialize(Archive& a)
  {
    a(payout, drag_factor, parted_element, variation);
  }
};

/// True if the elements of both are the same.
inline bool hasSameElements(const Deployment& a, const Deployment& b)
{
  return a.payout == b.payout && a.drag_factor == b.drag_factor && a.parted_element == b.parted_element &&
         a.variation.hasSameElements(b.variation);
}

}  // namespace tether_monitor::core
