#pragma once

#include <array>
#include <vector>

#include "tether_monitor/core/assembly/cable_model.h"
#include "tether_monitor/core/assembly/clamped_end.h"
#include "tether_monitor/core/assembly/contact_assembly.h"
#include "tether_monitor/core/assembly/element_assembly.h"
#include "tether_monitor/core/assembly/element_equations.h"
#include "tether_monitor/core/assembly/joined_elements.h"

namespace tether_monitor::core
{
/**
 * A CableModel at one deployment: its elements with the lengths that they have there, and residual and tangent of
 * the equations of motion (M11).
 *
 * The workspace of whoever evaluates a model: it holds what follows from model and deployment, so that this is
 * computed once a step. update() makes it that of another model or deployment; a state's own must be in before the
 * state is evaluated.
 */
class DeployedCable
{
 public:
  explicit DeployedCable(const CableModel& model, const Deployment& deployment = Deployment());

  /// Does nothing if neither has changed; allocates nothing if there are as many elements as before.
  /// @param deployment  its length must be one that the model can represent.
  void update(const CableModel& model, const Deployment& deployment);
  /// Makes the bending stiffness at least `floor` m g l^3 [-] in every element of length l, until update().
  void stiffen(double floor);

  const CableModel& model() const { return model_; }
  const EnvironmentModel& environment() const { return model_.environment(); }
  const EndBodies& bodies() const { return model_.bodies(); }
  int elements() const { return static_cast<int>(elements_.size()); }
  int nodes() const { return elements() + 1; }
  const ElementParameters& element(int i) const { return elements_[i]; }
  /// Unstretched arc length of a node from the vessel end [m]; 0 <= node <= elements().
  double arcLength(int node) const { return arc_length_[node]; }
  /// The element that begins at arc length s or holds it [m], 0 <= s <= length().
  int elementAt(double s) const;
  double length() const { return arc_length_.back(); }
  /// Largest EA / l of any element [N/m]: how much force a rounding of coordinates makes.
  double largestStiffness() const { return largest_stiffness_; }
  /// Unit of force for tolerances [N]: dry weight of the whole tether, at least that of 1 kg.
  double forceScale() const { return force_scale_; }
  /// Dry mass of the deployed tether and what is fixed to it [kg].
  double mass() const { return mass_; }

  /// Residual of every node: the force and couple that it must receive from outside [N, N m]. Size nodes().
  void assemble(const CableState& state, NodeField& residual) const;
  /// As above, with the iteration matrix (see TangentWeights), and with the obstacles' part if `bordered` is
  /// given.
  void assemble(const CableState& state, const TangentWeights& weights, NodeField& residual,
                BlockTridiagonal& tangent, TangentKind kind = TangentKind::COMPLETE,
                BorderedSystem* bordered = nullptr) const;
  /// Residuals of elements `first`, a multiple of kernel::BLOCK, to the end of the block: the forces that the two
  /// nodes of each receive from their other neighbours or from outside. @return how many.
  int elementResiduals(int first, const CableState& state, std::array<ElementCoords, kernel::BLOCK>& out) const;

  /// The clamps of a state, hinged or not.
  ClampedEnd vesselClamp(const CableState& state) const;
  ClampedEnd vehicleClamp(const CableState& state) const;

  /// What contact needs to know of this tether in a state.
  ContactScene contactScene(const CableState& state) const { return {elements_, environment(), state}; }
  /// See core::initializeContact() and core::commitFriction().
  void initializeContact(CableState& state) const { core::initializeContact(elements_, environment(), state); }
  void commitFriction(CableState& state) const { core::commitFriction(elements_, environment(), state); }

  /// Energies of the whole tether [J]; see ElementEnergy.
  ElementEnergy energy(const NodeField& q, const NodeField& v) const;

 private:
  void setElements();
  void setElement(int i, double growing, double& covered);
  void joinAtStiffnessJumps();
  void passToAssembler(int i);
  void updateScales();

  CableModel model_;
  Deployment deployment_;
  bool stiffened_ = false;
  std::vector<ElementParameters> elements_;
  ElementAssembler assembler_;
  JoinedElements joined_;
  std::vector<double> arc_length_;
  double force_scale_ = 0.0, mass_ = 0.0, largest_stiffness_ = 0.0;
};

/// Prepares a state of a model for stepping; for set-up, since it allocates.
void initializeContact(const CableModel& model, CableState& state);

}  // namespace tether_monitor::core
