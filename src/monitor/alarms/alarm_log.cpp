#include "tether_monitor/monitor/alarms/alarm_log.h"

namespace tether_monitor::monitor
{
void AlarmLog::note(AlarmEvent event)
{
  event.number = ++last_;
  events_.emplaceBack() = event;
}

bool AlarmLog::isValid(int alarms) const
{
  if (!events_.isValid(CAPACITY) || last_ < static_cast<long>(events_.size()))
    return false;
  for (std::size_t i = 0; i < events_.size(); ++i)
    if (events_[i].alarm < 0 || events_[i].alarm >= alarms)
      return false;
  return true;
}

}  // namespace tether_monitor::monitor
