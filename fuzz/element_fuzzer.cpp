// libFuzzer: bytes that choose elements and their state.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "verification/robustness_checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  tether_monitor::fuzz::RandomSource dice(data, size);
  const std::string fault = tether_monitor::fuzz::checkElement(dice);
  if (!fault.empty())
  {
    std::fprintf(stderr, "%s\n", fault.c_str());
    std::abort();
  }
  return 0;
}
