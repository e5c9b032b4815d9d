#pragma once

#include <vector>

#include "tether_monitor/core/block_tridiagonal.h"
#include "tether_monitor/core/cable_fittings.h"
#include "tether_monitor/core/cable_properties.h"
#include "tether_monitor/core/element_response.h"
#include "tether_monitor/core/environment.h"
#include "tether_monitor/core/point_load.h"
#include "tether_monitor/core/types.h"

namespace tether_monitor::core
{
/**
 * A tether cut into elements, in its environment: residual and tangent of the equations of motion (M11).
 *
 * Holds no motion: state goes in as an argument, so one model serves many states and threads.
 */
class CableModel
{
 public:
  /**
   * @param properties  see CableProperties.
   * @param elements    number of elements N, 1 <= N <= 100000; the model has N + 1 nodes.
   * @param sea         see Environment.
   * @param fittings    sections, weights and floats; see CableFittings.
   * @throws std::invalid_argument listing every violated bound.
   */
  CableModel(const CableProperties& properties, int elements, const Environment& sea,
             const CableFittings& fittings = CableFittings());

  int elements() const { return static_cast<int>(elements_.size()); }
  int nodes() const { return elements() + 1; }
  const ElementParameters& element(int i) const { return elements_[i]; }
  const CableProperties& properties() const { return properties_; }
  /// Properties of element `i`: those of its section.
  const CableProperties& propertiesOf(int i) const { return kinds_[kind_[i]]; }
  const std::vector<PointLoad>& pointLoads() const { return point_loads_; }
  const Environment& environment() const { return sea_; }
  /// Unstretched arc length of a node from the vessel end [m]; 0 <= node <= elements().
  double arcLength(int node) const { return arc_length_[node]; }
  double length() const { return arc_length_.back(); }
  /// Largest EA / l of any element [N/m]: how much force a rounding of coordinates makes.
  double largestStiffness() const { return largest_stiffness_; }
  /// Unit of force for tolerances [N]: dry weight of the whole tether, at least that of 1 kg.
  double forceScale() const { return force_scale_; }

  /// A copy whose bending stiffness is at least `floor` m g l^3 [-] in every element of length l.
  CableModel stiffened(double floor) const;

  /// Replaces the current profile while the model is in use. Allocates; not for the stepping path.
  void setCurrent(const CurrentProfile& current) { sea_.current = current; }

  /// Residual of every node: the force and couple that it must receive from outside [N, N m]. Fields of size
  /// nodes().
  void assemble(const NodeField& q, const NodeField& v, const NodeField& a, NodeField& residual) const;
  /// As above, with the iteration matrix; see TangentWeights.
  void assemble(const NodeField& q, const NodeField& v, const NodeField& a, const TangentWeights& weights,
                NodeField& residual, BlockTridiagonal& tangent) const;
  /// Residual of element `i` alone: the forces that its two nodes receive from their other neighbours or from
  /// outside.
  ElementCoords elementResidualOf(int i, const NodeField& q, const NodeField& v, const NodeField& a) const;

  /// Energies of the whole tether [J]; see ElementEnergy.
  ElementEnergy energy(const NodeField& q, const NodeField& v) const;

 private:
  CableProperties properties_;
  std::vector<CableProperties> kinds_;  // the tether's own, then one for each section
  std::vector<int> kind_;               // of each element
  std::vector<PointLoad> point_loads_;
  Environment sea_;
  std::vector<ElementParameters> elements_;
  std::vector<double> arc_length_;
  double force_scale_ = 0.0;
  double largest_stiffness_ = 0.0;
};

/// What is violated when `elements` is used as a number of elements, or nothing.
std::vector<std::string> elementCountProblems(int elements);
/// The same for a tether of `length` [m] with fittings: there must be an element for each piece between them.
std::vector<std::string> elementCountProblems(int elements, double length, const CableFittings& fittings);

}  // namespace tether_monitor::core
