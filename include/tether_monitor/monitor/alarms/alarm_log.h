#pragma once

#include "tether_monitor/monitor/alarms/alarm_life.h"
#include "tether_monitor/monitor/measurements/ring_buffer.h"

namespace tether_monitor::monitor
{
/// A change of one alarm.
struct AlarmEvent
{
  long number = 0;  ///< counts from 1.
  double t = 0.0;   ///< [s]
  int alarm = 0;    ///< index into AlarmSet::alarms().
  AlarmState from = AlarmState::NORMAL, to = AlarmState::NORMAL;
  double value = 0.0;      ///< then, in the alarm's unit.
  double s = 0.0;          ///< along the tether [m]; NaN: nowhere.
  double peak = 0.0;       ///< worst value since it became active last; NaN: it never was.
  double duration = 0.0;   ///< since then [s]; NaN: it never was.
  bool first_out = false;  ///< it came first of those that are announced.

  template <class Archive>
  void serialize(Archive& a)
  {
    a(number, t, alarm, from, to, value, s, peak, duration, first_out);
  }
};

/// The last changes of all alarms, oldest first; note() allocates nothing.
class AlarmLog
{
 public:
  static constexpr std::size_t CAPACITY = 500;

  AlarmLog() : events_(CAPACITY) {}

  /// Adds one; gives it its number.
  void note(AlarmEvent event);
  const RingBuffer<AlarmEvent>& events() const { return events_; }
  /// Number of the last one ever noted; 0: none.
  long last() const { return last_; }
  /// False for what note() cannot have made. @param alarms  how many there are.
  bool isValid(int alarms) const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(events_, last_);
  }

 private:
  RingBuffer<AlarmEvent> events_;
  long last_ = 0;
};

}  // namespace tether_monitor::monitor
