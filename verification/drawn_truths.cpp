#include "verification/drawn_truths.h"

#include <atomic>
#include <stdexcept>
#include <thread>

namespace tether_monitor::bench
{
double tensionBias(const DrawnTruth& drawn, const monitor::Config& config)
{
  return drawn.draw.tension_bias * config.uncertainty.tension_bias * config.tether.working_load;
}

void forEachTruth(const std::function<UncertainCase(unsigned seed)>& of, int draws, unsigned first_seed,
                  int threads, bool is_as_told, const std::function<void(const DrawnTruth&)>& use)
{
  std::atomic<int> next{0};
  const auto work = [&]
  {
    for (int k = next++; k < draws; k = next++)
    {
      DrawnTruth drawn;
      drawn.seed = first_seed + static_cast<unsigned>(k);
      drawn.of = of(drawn.seed);
      if (!is_as_told)
        drawn.draw = drawTruth(drawn.of, drawn.seed);
      try
      {
        drawn.truth = makeTruth(drawn.of, drawn.draw);
      }
      catch (const std::runtime_error&)
      {
        continue;
      }
      use(drawn);
    }
  };
  std::vector<std::thread> others;
  for (int k = 1; k < threads; ++k)
    others.emplace_back(work);
  work();
  for (std::thread& thread : others)
    thread.join();
}

}  // namespace tether_monitor::bench
