// A campaign over seeds: campaign ELEMENTS TETHERS [FIRST_SEED]. Ends with "N passed, N failed".
#include <cstdio>
#include <cstdlib>
#include <string>

#include "verification/robustness_checks.h"

int main(int count, char** words)
{
  using namespace tether_monitor::fuzz;
  if (count < 3)
  {
    std::fprintf(stderr, "usage: %s ELEMENTS TETHERS [FIRST_SEED]\n", words[0]);
    return 2;
  }
  const long first = count > 3 ? std::atol(words[3]) : 1;
  long passed = 0, failed = 0;
  const auto campaign = [&](const char* what, long runs, std::string (*check)(RandomSource&))
  {
    for (long seed = first; seed < first + runs; ++seed)
    {
      RandomSource dice(static_cast<unsigned>(seed));
      const std::string fault = check(dice);
      ++(fault.empty() ? passed : failed);
      if (!fault.empty())
        std::printf("%s, seed %ld: %s\n", what, seed, fault.c_str());
    }
  };
  campaign("element", std::atol(words[1]), checkElement);
  campaign("tether", std::atol(words[2]), checkTether);
  std::printf("%ld passed, %ld failed\n", passed, failed);
  return failed == 0 ? 0 : 1;
}
