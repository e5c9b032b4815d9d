#include "tether_monitor/core/kernel/kernel.h"

namespace tether_monitor::core::kernel
{
extern const Kernel PORTABLE;
#ifdef TETHER_MONITOR_X86_KERNELS
extern const Kernel AVX2, AVX512;
#endif

std::vector<const Kernel*> available()
{
  std::vector<const Kernel*> found;
#ifdef TETHER_MONITOR_X86_KERNELS
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    found.push_back(&AVX512);
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    found.push_back(&AVX2);
#endif
  found.push_back(&PORTABLE);
  return found;
}

const Kernel& best()
{
  static const Kernel& kernel = *available().front();
  return kernel;
}
}  // namespace tether_monitor::core::kernel
