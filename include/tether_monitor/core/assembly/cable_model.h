#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "tether_monitor/core/assembly/lumped_attachment.h"
#include "tether_monitor/core/bodies/rigid_body.h"
#include "tether_monitor/core/cable/cable_mesh.h"
#include "tether_monitor/core/cable/deployment.h"
#include "tether_monitor/core/environment/environment_model.h"
#include "tether_monitor/core/kernel/kernel.h"

namespace tether_monitor::core
{
/**
 * A tether cut into elements, in its environment, with the bodies at its ends.
 *
 * Immutable, and holds no motion: deployed length and drag factors are part of a CableState, so one model serves
 * many states and threads. The with...() functions make another model that shares what stays; a copy costs three
 * references. DeployedCable has the equations.
 */
class CableModel
{
 public:
  /**
   * @param properties   see CableProperties.
   * @param elements     number of elements N, 1 <= N <= 100000; the model has N + 1 nodes.
   * @param environment  see Environment.
   * @param layout       sections, weights and floats; see CableLayout.
   * @throws std::invalid_argument listing every violated bound.
   */
  CableModel(const CableProperties& properties, int elements, const Environment& environment,
             const CableLayout& layout = CableLayout());

  CableModel withEnvironment(const EnvironmentModel& environment) const;
  /// With simulated bodies at the ends. @throws std::invalid_argument listing violated bounds.
  CableModel withBodies(const EndBodies& bodies) const;
  /// With other arithmetic than kernel::best().
  CableModel withKernel(const kernel::Kernel& kernel) const;

  int elements() const { return mesh().elements(); }
  int nodes() const { return elements() + 1; }
  const CableMesh& mesh() const { return tether_->mesh; }
  /// Of the tether; its `length` is as built.
  const CableProperties& properties() const { return tether_->materials.front(); }
  /// Properties of element `i`: those of its section.
  const CableProperties& elementProperties(int i) const { return tether_->materials[mesh().materialIndex(i)]; }
  /// See core::bendLimit().
  std::optional<double> bendLimit() const { return tether_->bend_limit; }
  const std::vector<LumpedAttachment>& lumpedAttachments() const { return tether_->attachments; }
  const EnvironmentModel& environment() const { return *environment_; }
  const EndBodies& bodies() const { return *bodies_; }
  const kernel::Kernel& kernel() const { return *kernel_; }

  /// Unstretched length as built [m].
  double length() const { return mesh().length(); }
  /// Deployed length [m].
  double length(const Deployment& deployment) const
  {
    return deployment.payout ? deployment.payout->length : length();
  }
  /// See CableMesh::canRepresentLength().
  bool canRepresentLength(double length) const { return mesh().canRepresentLength(length); }

  /// True if both are the same tether, cut alike: made by the same constructor call.
  bool sharesTether(const CableModel& other) const { return tether_ == other.tether_; }
  /// True if both are the same in everything.
  bool isSame(const CableModel& other) const
  {
    return tether_ == other.tether_ && environment_ == other.environment_ && bodies_ == other.bodies_ &&
           kernel_ == other.kernel_;
  }

 private:
  struct Tether
  {
    std::vector<CableProperties> materials;  // the tether's own, then one for each section
    CableMesh mesh;
    std::vector<LumpedAttachment> attachments;
    std::optional<double> bend_limit;
  };

  std::shared_ptr<const Tether> tether_;
  std::shared_ptr<const EnvironmentModel> environment_;
  std::shared_ptr<const EndBodies> bodies_;
  const kernel::Kernel* kernel_ = &kernel::best();
};

}  // namespace tether_monitor::core
