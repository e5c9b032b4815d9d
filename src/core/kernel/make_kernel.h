#pragma once

#include "block_kernel.h"
#include "element_kernel.h"

namespace tether_monitor::core::kernel
{
template <int W>
constexpr Kernel makeKernel(const char* name)
{
  return {name,
          W,
          allElements<W, Task::RESIDUALS>,
          allElements<W, Task::SYMMETRIC>,
          allElements<W, Task::COMPLETE>,
          solveBlocks<W>};
}
}  // namespace tether_monitor::core::kernel
