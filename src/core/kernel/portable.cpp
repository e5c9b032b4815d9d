#include "make_kernel.h"

namespace tether_monitor::core::kernel
{
extern const Kernel PORTABLE;
const Kernel PORTABLE = makeKernel<2>("portable");
}  // namespace tether_monitor::core::kernel
