#pragma once

#include <vector>

#include "tether_monitor/core/assembly/element_assembly.h"

namespace tether_monitor::core
{
/**
 * The few elements with a slope that follows from the neighbour's, (M30): they are evaluated one by one, in their
 * own coordinates.
 *
 * A workspace: not for two threads at once.
 */
class JoinedElements
{
 public:
  JoinedElements();

  /// Takes away all elements; keeps the memory.
  void clear() { count_ = 0; }
  /// Adds element `i`, or sets its constants anew.
  void set(int i, const ElementParameters& p);

  /// Residual of element `i` alone, on its own coordinates; it must have been set.
  ElementCoords residual(int i, const kernel::Kernel& kernel, const EnvironmentModel& environment,
                         const CableState& state) const;
  /// Adds the residuals of all to those of the nodes.
  void addTo(const kernel::Kernel& kernel, const EnvironmentModel& environment, const CableState& state,
             NodeField& residual) const;
  /// The same with the tangent.
  void addTo(const kernel::Kernel& kernel, const EnvironmentModel& environment, const CableState& state,
             const TangentWeights& weights, TangentKind kind, NodeField& residual,
             BlockTridiagonal& tangent) const;

 private:
  struct Element
  {
    int index = 0;
    ElementParameters parameters;
    ElementAssembler assembler{1};
  };
  int find(int i) const;
  void place(const Element& element, const CableState& state) const;

  std::vector<Element> elements_;
  int count_ = 0;
  mutable CableState alone_;    // the two nodes of one element
  mutable NodeField residual_;  // of these
  mutable BlockTridiagonal tangent_;
};

}  // namespace tether_monitor::core
