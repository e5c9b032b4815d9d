#include "verification/identification_study.h"

#include <cmath>
#include <mutex>

#include "tether_monitor/monitor/identification/identification.h"
#include "verification/drawn_truths.h"

namespace tether_monitor::bench
{
namespace
{
constexpr int PASSES = 3, THREADS = 2;

struct Sought
{
  std::string name;
  double factor;  // on what is configured
  double offset;  // from it
};

std::vector<Sought> soughtIn(const core::PropertyVariation& truth)
{
  return {{"tether.drag_normal", truth.drag_normal, 0.0},
          {"tether.drag_tangential", truth.drag_tangential, 0.0},
          {"tether.mass_per_length", truth.mass_per_length, 0.0},
          {"tether.length", truth.length, 0.0},
          {"environment.current.x", 1.0, truth.current.x()},
          {"environment.current.y", 1.0, truth.current.y()},
          {"vehicle.drag", truth.vehicle_drag, 0.0}};
}

monitor::Identification identify(const DrawnTruth& drawn, bool has_load_cell)
{
  Sensors sensors;
  sensors.seed = drawn.seed;
  sensors.has_load_cell = has_load_cell;
  monitor::Config config = configFor(drawn.of, drawn.truth, sensors);
  sensors.tension_bias = tensionBias(drawn, config);
  const auto pass = [&](const monitor::Config& tried)
  {
    std::optional<std::vector<monitor::ParameterEstimate>> report;
    observe(drawn.truth, tried, sensors,
            [&](const monitor::TetherEstimator& estimator, std::size_t)
            {
              if (estimator.isRunning())
                report = estimator.parameters();
            });
    return report;
  };
  return monitor::identify(config, pass, PASSES);
}

void add(const monitor::Identification& found, const core::PropertyVariation& truth,
         std::vector<IdentifiedShare>& shares)
{
  const std::vector<Sought> all = soughtIn(truth);
  shares.resize(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const monitor::ParameterEstimate* p = found.find(all[i].name);
    if (!p)
      continue;
    const double is = all[i].factor * p->configured + all[i].offset;
    const double unit = all[i].offset != 0.0 ? 1.0 : std::abs(is);
    const double error = p->mean - is;
    IdentifiedShare& share = shares[i];
    share.name = all[i].name;
    ++share.truths;
    share.within_95 += std::abs(error) <= 1.96 * p->stddev;
    share.rms += std::pow(error / unit, 2);
    share.configured_rms += std::pow((p->configured - is) / unit, 2);
    share.stddev += p->stddev / unit;
  }
}
}  // namespace

std::vector<IdentifiedShare> studyIdentification(const UncertainCase& c, int draws, unsigned first_seed,
                                                 bool has_load_cell)
{
  std::vector<IdentifiedShare> shares;
  std::mutex mutex;
  forEachTruth([&](unsigned) { return c; }, draws, first_seed, THREADS, false,
               [&](const DrawnTruth& drawn)
               {
                 const monitor::Identification found = identify(drawn, has_load_cell);
                 const std::lock_guard<std::mutex> lock(mutex);
                 add(found, drawn.draw.variation, shares);
               });
  for (IdentifiedShare& share : shares)
  {
    share.rms = std::sqrt(share.rms / share.truths);
    share.configured_rms = std::sqrt(share.configured_rms / share.truths);
    share.stddev /= share.truths;
  }
  return shares;
}

}  // namespace tether_monitor::bench
