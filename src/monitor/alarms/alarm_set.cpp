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
      alarms_.emplace_back(
          AlarmDefinition{name, severity, quantity.side, limit, alarm.timing, quantity.unit, quantity.advice});
      quantities_.push_back(&quantity);
    };
    if (alarm.limit)
      define(quantity.name, quantity.severity, *alarm.limit);
    if (alarm.warning)
      define(std::string(quantity.name) + "_warning", Severity::WARNING, *alarm.warning);
  }
}

// The first one of a sequence, which lasts until none is announced any more.
void AlarmSet::updateFirstOut(std::size_t i)
{
  if (first_out_ < 0 && alarms_[i].isAnnunciated())
    first_out_ = static_cast<int>(i);
  if (std::none_of(alarms_.begin(), alarms_.end(), [](const Alarm& a) { return a.isAnnunciated(); }))
    first_out_ = -1;
}

template <typename Change>
bool AlarmSet::noted(std::size_t i, double t, const Change& change)
{
  Alarm& alarm = alarms_[i];
  const AlarmState from = alarm.state();
  if (!change(alarm) || alarm.state() == from)
    return false;
  updateFirstOut(i);
  AlarmEvent event;
  event.t = t;
  event.alarm = static_cast<int>(i);
  event.from = from;
  event.to = alarm.state();
  event.value = alarm.value();
  event.s = alarm.s();
  event.peak = alarm.peak();
  event.duration = t - alarm.onset();
  event.first_out = first_out_ == event.alarm;
  log_.note(event);
  return true;
}

bool AlarmSet::update(const TetherEstimate& e, const AlarmInputs& inputs)
{
  bool changed = false;
  const double upper = upperBound(e);
  for (std::size_t i = 0; i < alarms_.size(); ++i)
  {
    AlarmValue watched = quantities_[i]->value(e, inputs);
    if (quantities_[i]->is_tension && alarms_[i].definition().severity == Severity::WARNING)
      watched.value *= upper;
    const auto change = [&](Alarm& alarm)
    { return e.is_stowed ? alarm.release(e.time) : alarm.update(e.time, watched.value, watched.s); };
    changed = noted(i, e.time, change) || changed;
  }
  return changed;
}

int AlarmSet::acknowledge(double t)
{
  int count = 0;
  for (std::size_t i = 0; i < alarms_.size(); ++i)
    count += noted(i, t, [t](Alarm& alarm) { return alarm.acknowledge(t); });
  return count;
}

std::string AlarmSet::act(const std::string& name, AlarmAction action, double t, double seconds)
{
  for (std::size_t i = 0; i < alarms_.size(); ++i)
  {
    if (alarms_[i].definition().name != name)
      continue;
    if (action == AlarmAction::SHELVE && !(seconds > 0.0 && seconds <= Alarm::LONGEST_SHELVING))
      return "seconds must be above 0 and at most " + std::to_string(static_cast<int>(Alarm::LONGEST_SHELVING));
    bool is_done = false;
    noted(i, t, [&](Alarm& alarm) { return is_done = alarm.act(action, t, seconds); });
    return is_done ? "" : "'" + name + "' is " + describe(alarms_[i].state());
  }
  return "there is no alarm '" + name + "'";
}

void AlarmSet::resetTimers(double t)
{
  for (std::size_t i = 0; i < alarms_.size(); ++i)
    noted(i, t, [t](Alarm& alarm) { return alarm.resetTimers(t); });
}

bool AlarmSet::isValid() const
{
  const int count = static_cast<int>(alarms_.size());
  return log_.isValid(count) && first_out_ >= -1 && first_out_ < count &&
         std::all_of(alarms_.begin(), alarms_.end(),
                     [](const Alarm& a)
                     {
                       const int state = static_cast<int>(a.state());
                       return state >= 0 && state < ALARM_STATES;
                     });
}

bool AlarmSet::overTension() const
{
  return std::any_of(alarms_.begin(), alarms_.end(),
                     [](const Alarm& a)
                     {
                       const std::string& name = a.definition().name;
                       return (a.isAnnunciated() || a.isActive()) && (name == OVER_TENSION || name == BREAKING);
                     });
}

}  // namespace tether_monitor::monitor
