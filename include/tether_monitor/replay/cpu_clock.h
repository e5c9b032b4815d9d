#pragma once

#include <time.h>

namespace tether_monitor::replay
{
/// Time that this thread has computed for [s].
inline double cpuClock()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace tether_monitor::replay
