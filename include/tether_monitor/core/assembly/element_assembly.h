#pragma once

#include <vector>

#include "tether_monitor/core/base/tangent_weights.h"
#include "tether_monitor/core/cable/cable_state.h"
#include "tether_monitor/core/element/element_parameters.h"
#include "tether_monitor/core/environment/environment_model.h"
#include "tether_monitor/core/kernel/kernel.h"
#include "tether_monitor/core/linalg/block_tridiagonal.h"

namespace tether_monitor::core
{
/// The constants of all elements of a tether as the kernels read them, and the loop over the elements.
class ElementAssembler
{
 public:
  explicit ElementAssembler(int elements);

  /// Constants of element `i`.
  void set(int i, const ElementParameters& p);

  /// Residuals of elements first .. first + count - 1 alone, count <= kernel::BLOCK, 12 numbers each into `out`.
  void residuals(const kernel::Kernel& kernel, const EnvironmentModel& environment, const CableState& state,
                 int first, int count, ElementCoords* out) const;
  /// Residual of every node and tangent; sets both.
  void assemble(const kernel::Kernel& kernel, const EnvironmentModel& environment, const CableState& state,
                const TangentWeights& weights, TangentKind kind, NodeField& residual,
                BlockTridiagonal& tangent) const;

 private:
  struct alignas(64) Constants
  {
    double x[kernel::CONSTANTS][kernel::BLOCK] = {};
    bool damping[kernel::BLOCK] = {}, compression[kernel::BLOCK] = {}, transport[kernel::BLOCK] = {},
         stiffening[kernel::BLOCK] = {};
  };
  kernel::ElementBlock block(const EnvironmentModel& environment, const kernel::Surroundings& around,
                             const kernel::Kernel& kernel, const CableState& state, int first, int count,
                             double* water) const;

  int count_;
  std::vector<Constants> blocks_;
};

}  // namespace tether_monitor::core
