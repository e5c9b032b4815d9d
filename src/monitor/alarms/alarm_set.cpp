#include "tether_monitor/monitor/alarms/alarm_set.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
const char* const OVER_TENSION = "over_tension";
constexpr double BAND = 2.0;  // standard deviations to the edge of the band
}  // namespace

AlarmSet::AlarmSet(const Config& config)
{
  AlarmConfig bend = config.alarms.bend_radius;
  if (!bend.limit)
    bend.limit = core::bendLimit(config.tether, config.layout);
  AlarmConfig stale = config.alarms.stale_input;
  if (!stale.limit)
    stale.limit = config.pose_timeout;
  define(OVER_TENSION, Quantity::WORKING_UTILISATION, Side::ABOVE, Severity::ALARM, config.alarms.over_tension);
  define("breaking", Quantity::BREAKING_UTILISATION, Side::ABOVE, Severity::CRITICAL, config.alarms.breaking);
  define("slack", Quantity::MIN_TENSION, Side::BELOW, Severity::ALARM, config.alarms.slack);
  define("bend_radius", Quantity::BEND_RADIUS, Side::BELOW, Severity::ALARM, bend);
  define("stale_input", Quantity::AGE, Side::ABOVE, Severity::ALARM, stale);
}

void AlarmSet::define(const char* name, Quantity quantity, Side side, Severity severity, const AlarmConfig& config)
{
  if (config.limit)
  {
    alarms_.emplace_back(AlarmDefinition{name, severity, side, *config.limit, config.timing});
    quantities_.push_back(quantity);
  }
  if (config.warning)
  {
    alarms_.emplace_back(
        AlarmDefinition{std::string(name) + "_warning", Severity::WARNING, side, *config.warning, config.timing});
    quantities_.push_back(quantity);
  }
}

bool AlarmSet::update(const TetherEstimate& e)
{
  bool changed = false;
  // A warning looks at the upper edge of the band, where there is one.
  const double stddev = std::max(e.vessel_tension_stddev, e.vehicle_tension_stddev);
  const double upper = stddev > 0.0 && e.max_tension > 0.0 ? 1.0 + BAND * stddev / e.max_tension : 1.0;
  for (std::size_t i = 0; i < alarms_.size(); ++i)
  {
    double value = TetherEstimate::NONE;
    double s = TetherEstimate::NONE;
    const double band = alarms_[i].definition().severity == Severity::WARNING ? upper : 1.0;
    switch (quantities_[i])
    {
      case Quantity::WORKING_UTILISATION:
        value = e.working_utilisation * band;
        s = e.working_utilisation_s;
        break;
      case Quantity::BREAKING_UTILISATION:
        value = e.breaking_utilisation * band;
        s = e.max_tension_s;
        break;
      case Quantity::MIN_TENSION:
        value = e.min_tension;
        s = e.min_tension_s;
        break;
      case Quantity::BEND_RADIUS:
        value = e.governing_bend_radius;
        s = e.governing_bend_radius_s;
        break;
      case Quantity::AGE:
        value = std::max(e.vessel_age, e.vehicle_overdue);
        if (e.payout_age > value)
          value = e.payout_age;
        break;
    }
    changed = alarms_[i].update(e.time, value, s) || changed;
  }
  return changed;
}

int AlarmSet::acknowledge(double t)
{
  return static_cast<int>(
      std::count_if(alarms_.begin(), alarms_.end(), [t](Alarm& a) { return a.acknowledge(t); }));
}

void AlarmSet::resetTimers()
{
  for (Alarm& alarm : alarms_)
    alarm.resetTimers();
}

bool AlarmSet::overTension() const
{
  return std::any_of(alarms_.begin(), alarms_.end(),
                     [](const Alarm& a) { return a.definition().name == OVER_TENSION && a.isAnnunciated(); });
}

}  // namespace tether_monitor::monitor
