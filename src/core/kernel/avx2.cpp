#include "make_kernel.h"

namespace tether_monitor::core::kernel
{
extern const Kernel AVX2;
const Kernel AVX2 = makeKernel<4>("avx2");
}  // namespace tether_monitor::core::kernel
