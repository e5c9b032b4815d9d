#pragma once

#include "block_elimination.h"
#include "element_kernel.h"
#include "wave_kernel.h"

namespace tether_monitor::core::kernel
{
template <int W>
double multiplyAdds(long rounds)
{
  using V = typename Simd<W>::Vector;
  constexpr int CHAINS = OPERATIONS_A_ROUND / 2;
  V sum[CHAINS];
  for (int i = 0; i < CHAINS; ++i)
    sum[i] = broadcast<W>(1.0 + i);
  const V factor = broadcast<W>(0.999999), more = broadcast<W>(1e-6);
  for (long round = 0; round < rounds; ++round)
#pragma GCC unroll 12
    for (int i = 0; i < CHAINS; ++i)
      sum[i] = sum[i] * factor + more;
  V total{};
  for (int i = 0; i < CHAINS; ++i)
    total += sum[i];
  return total[0];
}

template <int W>
constexpr Kernel makeKernel(const char* name)
{
  return {name,
          W,
          elementsKernel<W, EvaluationMode::RESIDUALS>,
          elementsKernel<W, EvaluationMode::SYMMETRIC>,
          elementsKernel<W, EvaluationMode::COMPLETE>,
          solveBlocks<W>,
          wavesKernel<W>,
          multiplyAdds<W>};
}
}  // namespace tether_monitor::core::kernel
