#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tether_monitor/core/assembly/contact_assembly.h"
#include "tether_monitor/core/assembly/element_assembly.h"
#include "tether_monitor/core/assembly/element_equations.h"
#include "tether_monitor/core/assembly/lumped_attachment.h"
#include "tether_monitor/core/base/types.h"
#include "tether_monitor/core/bodies/rigid_body.h"
#include "tether_monitor/core/cable/cable_layout.h"
#include "tether_monitor/core/cable/cable_properties.h"
#include "tether_monitor/core/cable/cable_state.h"
#include "tether_monitor/core/cable/payout_trajectory.h"
#include "tether_monitor/core/environment/environment_model.h"
#include "tether_monitor/core/linalg/block_tridiagonal.h"

namespace tether_monitor::core
{
/// Simulated bodies at the tether's ends; an end without one is held on a given path.
struct EndBodies
{
  std::optional<RigidBody> vessel;
  std::optional<RigidBody> vehicle;
};

/**
 * A tether cut into elements, in its environment: residual and tangent of the equations of motion (M11).
 *
 * Holds no motion: state goes in as an argument, so one model serves many states and threads, as long as the
 * deployed length stays.
 */
class CableModel
{
 public:
  /**
   * @param properties  see CableProperties.
   * @param elements    number of elements N, 1 <= N <= 100000; the model has N + 1 nodes.
   * @param sea         see Environment.
   * @param layout    sections, weights and floats; see CableLayout.
   * @throws std::invalid_argument listing every violated bound.
   */
  CableModel(const CableProperties& properties, int elements, const Environment& sea,
             const CableLayout& layout = CableLayout());

  int elements() const { return static_cast<int>(elements_.size()); }
  int nodes() const { return elements() + 1; }
  const ElementParameters& element(int i) const { return elements_[i]; }
  const CableProperties& properties() const { return properties_; }
  /// Properties of element `i`: those of its section.
  const CableProperties& elementProperties(int i) const { return materials_[material_index_[i]]; }
  /// See core::bendLimit().
  std::optional<double> bendLimit() const { return bend_limit_; }
  const std::vector<LumpedAttachment>& lumpedAttachments() const { return lumped_attachments_; }
  const Environment& environment() const { return sea_.environment(); }
  const EnvironmentModel& sea() const { return sea_; }
  const EndBodies& bodies() const { return bodies_; }
  /// True if there is anything that the tether could touch.
  bool hasContact() const { return sea_.hasSeabed() || !environment().obstacles.empty(); }
  /// Unstretched arc length of a node from the vessel end [m]; 0 <= node <= elements().
  double arcLength(int node) const { return arc_length_[node]; }
  double length() const { return arc_length_.back(); }
  /// Largest EA / l of any element [N/m]: how much force a rounding of coordinates makes.
  double largestStiffness() const { return largest_stiffness_; }
  /// Unit of force for tolerances [N]: dry weight of the whole tether, at least that of 1 kg.
  double forceScale() const { return force_scale_; }
  /// Dry mass of the deployed tether and what is fixed to it [kg].
  double mass() const { return mass_; }

  /// A copy whose bending stiffness is at least `floor` m g l^3 [-] in every element of length l.
  CableModel stiffened(double floor) const;

  /// Changes of the environment while the model is in use. They may allocate: not for the stepping path. Obstacles
  /// that come or go want initializeContact().
  EnvironmentModel& sea() { return sea_; }
  /// Puts simulated bodies at the ends. @throws std::invalid_argument listing violated bounds.
  void setBodies(const EndBodies& bodies);
  /// Multiplies the normal drag of element `i` by a factor >= 1: strumming. Default 1.
  void setDragFactor(int i, double factor);
  /// The same by the coefficient itself [-], to take over that of another model bit for bit.
  void setDragNormal(int i, double coefficient);

  /// True if the tether can be deployed to `length` [m] with the mesh there is: what is fixed to it, and one
  /// twentieth of an element's length for each element, must stay outside.
  bool canRepresentLength(double length) const;
  /// Deployed length and its rates: the elements between the vessel end and the first section boundary or
  /// attachment grow and the tether runs through them, (M24). canRepresentLength(length) must hold; allocates
  /// nothing.
  void setPayout(const PayoutState& payout);
  /// The last one; at first the length alone.
  const PayoutState& payout() const { return payout_; }
  /// Deployed length that the mesh was made for [m].
  double referenceLength() const { return reference_length_; }

  /// Residual of every node: the force and couple that it must receive from outside [N, N m]. Size nodes().
  void assemble(const CableState& state, NodeField& residual) const;
  /// As above, with the iteration matrix (see TangentWeights), and with the obstacles' part if `border` is given.
  void assemble(const CableState& state, const TangentWeights& weights, NodeField& residual,
                BlockTridiagonal& tangent, TangentKind kind = TangentKind::COMPLETE,
                BorderedSystem* border = nullptr) const;
  /// Residuals of elements `first`, a multiple of kernel::BLOCK, to the end of the block: the forces that the two
  /// nodes of each receive from their other neighbours or from outside. @return how many.
  int elementResiduals(int first, const CableState& state, std::array<ElementCoords, kernel::BLOCK>& out) const;

  /// The arithmetic in use; kernel::best() unless told.
  const kernel::Kernel& kernel() const { return *kernel_; }
  void setKernel(const kernel::Kernel& kernel) { kernel_ = &kernel; }

  /// Energies of the whole tether [J]; see ElementEnergy.
  ElementEnergy energy(const NodeField& q, const NodeField& v) const;

 private:
  CableProperties properties_;
  std::vector<CableProperties> materials_;  // the tether's own, then one for each section
  std::vector<int> material_index_;         // of each element
  std::vector<LumpedAttachment> lumped_attachments_;
  EnvironmentModel sea_;
  EndBodies bodies_;
  std::vector<ElementParameters> elements_;
  ElementAssembler field_;  // the same for the kernels
  const kernel::Kernel* kernel_ = &kernel::best();
  std::vector<double> arc_length_;
  std::vector<double> reference_arc_length_;
  std::vector<double> growing_fraction_;  // of each growing element in the piece that grows
  std::optional<double> bend_limit_;
  PayoutState payout_;
  double reference_length_ = 0.0;  // when the mesh was made [m]
  double fixed_length_ = 0.0;      // of the elements that do not grow [m]
  void updateScales();
  double force_scale_ = 0.0;
  double mass_ = 0.0;
  double largest_stiffness_ = 0.0;
};

/// What is violated when `elements` is used as a number of elements, or nothing.
std::vector<std::string> validateElementCount(int elements);
/// The same for a tether of `length` [m] with layout: there must be an element for each piece between them.
std::vector<std::string> validateElementCount(int elements, double length, const CableLayout& layout);

}  // namespace tether_monitor::core
