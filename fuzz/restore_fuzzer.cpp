// libFuzzer: bytes that pretend to be a saved estimator. They must be refused, or stepping must go on.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "tether_monitor/monitor/estimator/tether_estimator.h"

namespace
{
using tether_monitor::monitor::Config;
using tether_monitor::monitor::TetherEstimator;

Config config()
{
  Config c;
  c.tether.length = 100.0;
  c.tether.diameter = 0.012;
  c.tether.mass_per_length = 0.2;
  c.tether.axial_stiffness = 1.0e6;
  c.tether.working_load = 1000.0;
  c.tether.breaking_load = 5000.0;
  c.elements = 4;
  return c;
}

const std::vector<std::uint8_t>& genuine()
{
  static const std::vector<std::uint8_t> bytes = []
  {
    TetherEstimator estimator(config());
    tether_monitor::monitor::EndTargets ends;
    ends.vehicle.position = {60.0, 0.0, -70.0};
    estimator.begin(0.0, ends);
    estimator.advance(0.05, ends);
    std::vector<std::uint8_t> saved = estimator.save();
    tether_monitor::core::verifyChecksum(saved);
    return saved;
  }();
  return bytes;
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  // Three bytes each: where to change a genuine state, and to what; so that the header does not end every trial.
  std::vector<std::uint8_t> bytes = genuine();
  for (std::size_t i = 0; i + 3 <= size && i < 300; i += 3)
    bytes[(data[i] * 256u + data[i + 1]) % bytes.size()] = data[i + 2];
  tether_monitor::core::appendChecksum(bytes);
  TetherEstimator estimator(config());
  if (!estimator.restore(bytes))
    return 0;
  tether_monitor::monitor::EndTargets ends;
  ends.vehicle.position = {60.0, 0.0, -70.0};
  const auto& e = estimator.advance(estimator.estimate().time + 0.05, ends);
  if (e.status != tether_monitor::monitor::Status::INVALID && !std::isfinite(e.vessel_tension))
    std::abort();
  return 0;
}
