#include "make_kernel.h"

namespace tether_monitor::core::kernel
{
extern const Kernel AVX512;
const Kernel AVX512 = makeKernel<8>("avx512");
}  // namespace tether_monitor::core::kernel
