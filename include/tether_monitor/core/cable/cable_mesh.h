#pragma once

#include <string>
#include <vector>

#include "tether_monitor/core/cable/cable_layout.h"

namespace tether_monitor::core
{
/**
 * The elements of a tether as built: where the nodes are, to which section each element belongs, and which
 * elements grow when the tether is paid out. Immutable.
 *
 * There is a node on every section boundary and attachment; elements are distributed by length. Next to an
 * attachment an element is short, since the tether has a kink there that a smooth element would round off. The
 * elements between the vessel end and the first section boundary or attachment grow with the deployed length,
 * (M24) of doc/model.md.
 */
class CableMesh
{
 public:
  /// @throws std::invalid_argument listing what validate(layout, length) and validateElementCount() find.
  CableMesh(double length, int elements, const CableLayout& layout);

  int elements() const { return static_cast<int>(material_index_.size()); }
  /// Unstretched length as built [m].
  double length() const { return arc_length_.back(); }
  /// Unstretched arc length of a node from the vessel end, as built [m]; 0 <= node <= elements().
  double arcLength(int node) const { return arc_length_[node]; }
  double elementLength(int i) const { return element_length_[i]; }
  /// 0: the tether's own properties, k + 1: those of section k.
  int materialIndex(int i) const { return material_index_[i]; }
  /// Node nearest to arc length s [m].
  int nearestNode(double s) const;

  /// The first so many elements grow with the deployed length, each by its fraction of what grows.
  int growingElements() const { return static_cast<int>(growing_fraction_.size()); }
  double growingFraction(int i) const { return growing_fraction_[i]; }
  /// Length of the elements that do not grow [m].
  double fixedLength() const { return fixed_length_; }
  /// True if the tether can be deployed to `length` [m] with these elements: what is fixed to it, and one
  /// twentieth of a regular element for each that grows, must stay outside.
  bool canRepresentLength(double length) const;

 private:
  std::vector<double> arc_length_, element_length_, growing_fraction_;
  std::vector<int> material_index_;
  double fixed_length_ = 0.0;
};

/// What is violated when `elements` is used as a number of elements, or nothing.
std::vector<std::string> validateElementCount(int elements);
/// The same for a tether of `length` [m] with a layout: there must be an element for each piece between what is
/// fixed to it.
std::vector<std::string> validateElementCount(int elements, double length, const CableLayout& layout);

}  // namespace tether_monitor::core
