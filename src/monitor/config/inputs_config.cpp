#include "tether_monitor/monitor/config/inputs_config.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::monitor
{
SourceConfig InputsConfig::source(const std::string& topic) const
{
  const auto found = std::find_if(sources.begin(), sources.end(),
                                  [&](const SourceConfig& source) { return source.topic == topic; });
  if (found != sources.end())
    return *found;
  SourceConfig by_default;
  by_default.topic = topic;
  return by_default;
}

std::vector<std::string> validate(const InputsConfig& config)
{
  std::vector<std::string> all;
  const auto take = [&](const core::BoundsCheck& check)
  { all.insert(all.end(), check.problems().begin(), check.problems().end()); };
  for (std::size_t i = 0; i < config.sources.size(); ++i)
  {
    core::BoundsCheck check("inputs[" + std::to_string(i) + "].");
    check.within("latency", config.sources[i].latency, 0.0, 30.0, "s");
    if (config.sources[i].stddev)
      check.positive("stddev", *config.sources[i].stddev, "m or m/s");
    check.check(std::isfinite(config.sources[i].scale) && config.sources[i].scale != 0.0, "scale",
                config.sources[i].scale, "finite, and not 0");
    take(check);
  }
  if (config.datum)
  {
    core::BoundsCheck check("datum.");
    check.within("latitude", config.datum->latitude, -90.0, 90.0, "deg");
    check.within("longitude", config.datum->longitude, -180.0, 180.0, "deg");
    check.within("yaw", config.datum->yaw, -2.0 * M_PI, 2.0 * M_PI, "rad");
    if (config.datum->altitude)
      check.within("altitude", *config.datum->altitude, -1000.0, 10000.0, "m");
    take(check);
  }
  core::BoundsCheck others;
  if (config.air_pressure != 0.0)
    others.within("environment.air_pressure", config.air_pressure, 8e4, 1.2e5, "Pa");
  if (config.winch_joint)
  {
    const double ratio = config.winch_joint->ratio;
    others.check(std::isfinite(ratio) && ratio != 0.0, "payout_joint.ratio", ratio, "finite, and not 0");
    others.within("payout_joint.offset", config.winch_joint->offset, -1e5, 1e5, "m");
  }
  take(others);
  return all;
}

}  // namespace tether_monitor::monitor
