#include "tether_monitor/monitor/alarms/alarm_set.h"

#include <algorithm>

namespace tether_monitor::monitor
{
namespace
{
constexpr double NORMAL_P95 = 1.6448536;  // standard deviations to the 95 % quantile of a normal distribution

// The 95 % quantile of the largest tension over its median.
double upperBound(const TetherEstimate& e)
{
  if (e.max_tension > 0.0 && e.max_tension_p95 > e.max_tension)
    return e.max_tension_p95 / e.max_tension;
  const double stddev = std::max(e.vessel_tension_stddev, e.vehicle_tension_stddev);
  return stddev > 0.0 && e.max_tension > 0.0 ? 1.0 + NORMAL_P95 * stddev / e.max_tension : 1.0;
}
}  // namespace

AlarmSet::AlarmSet(const Config& config)
{
  for (const AlarmQuantity& quantity : alarmQuantities())
  {
    const AlarmConfig alarm = alarmConfig(config, quantity);
    const auto define = [&](const std::string& name, Severity severity, double limit)
    {
      alarms_.emplace_back(AlarmDefinition{name, severity, quantity.side, limit, alarm.timing, quantity.unit});
      quantities_.push_back(&quantity);
    };
    if (alarm.limit)
      define(quantity.name, quantity.severity, *alarm.limit);
    if (alarm.warning)
      define(std::string(quantity.name) + "_warning", Severity::WARNING, *alarm.warning);
  }
}

bool AlarmSet::update(const TetherEstimate& e)
{
  bool changed = false;
  if (e.is_stowed)
  {
    for (Alarm& alarm : alarms_)
      changed = alarm.release(e.time) || changed;
    return changed;
  }
  const double upper = upperBound(e);
  for (std::size_t i = 0; i < alarms_.size(); ++i)
  {
    AlarmValue watched = quantities_[i]->value(e);
    if (quantities_[i]->is_tension && alarms_[i].definition().severity == Severity::WARNING)
      watched.value *= upper;
    changed = alarms_[i].update(e.time, watched.value, watched.s) || changed;
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
                     [](const Alarm& a)
                     {
                       const std::string& name = a.definition().name;
                       return a.isAnnunciated() && (name == OVER_TENSION || name == BREAKING);
                     });
}

}  // namespace tether_monitor::monitor
