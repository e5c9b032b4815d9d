#pragma once

#include <vector>

#include "tether_monitor/core/linalg/block_tridiagonal.h"

namespace tether_monitor::bench
{
/**
 * Elimination of eight block-tridiagonal systems at once, a lane each: what the ensemble would do if the lanes of
 * a vector were its members instead of the rows of one member's blocks. From one end, without pivoting.
 */
class MemberElimination
{
 public:
  static constexpr int MEMBERS = 8;
  typedef double Lanes __attribute__((vector_size(8 * MEMBERS)));

  explicit MemberElimination(int nodes) : nodes_(nodes) {}
  /// Puts a system into a lane.
  void set(int lane, const core::BlockTridiagonal& matrix, const core::NodeField& right);
  /// Solves all lanes with the instructions of a kernel: "avx512", "avx2" or "portable". The matrices are lost.
  void solve(const char* instructions);
  core::NodeCoords solution(int lane, int node) const;

  struct alignas(64) Node
  {
    Lanes diagonal[6][6], upper[6][6], lower[6][6], b[6];
  };

 private:
  std::vector<Node> nodes_;
};
}  // namespace tether_monitor::bench
