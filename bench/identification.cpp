// How well a tether is found from a recorded dive: truths that are drawn from what is told. Prints a table and
// writes a file.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "verification/identification_study.h"

// bench_identification FILE [DRAWS] [FIRST_SEED]
int main(int argc, char** argv)
{
  using namespace tether_monitor::bench;
  if (argc < 2)
  {
    std::cerr << "usage: bench_identification FILE [DRAWS] [FIRST_SEED]\n";
    return 2;
  }
  const int draws = argc > 2 ? std::atoi(argv[2]) : 20;
  const unsigned seed = argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 3000;
  nlohmann::json rows = nlohmann::json::array();
  for (const char* name : {"C", "D"})
    for (const bool has_load_cell : {false, true})
      for (const IdentifiedShare& share : studyIdentification(uncertainCase(name), draws, seed, has_load_cell))
      {
        std::printf("%s %d %-24s %2d of %2d in the 95 %% band | off by %.3f, configured by %.3f | band %.3f\n",
                    name, has_load_cell, share.name.c_str(), share.within_95, share.truths, share.rms,
                    share.configured_rms, share.stddev);
        std::fflush(stdout);
        rows.push_back({{"case", name},
                        {"load_cell", has_load_cell},
                        {"parameter", share.name},
                        {"truths", share.truths},
                        {"within_95", share.within_95},
                        {"rms", share.rms},
                        {"configured_rms", share.configured_rms},
                        {"stddev", share.stddev}});
      }
  std::ofstream(argv[1]) << rows.dump(1) << "\n";
  return 0;
}
