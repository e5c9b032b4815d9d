#pragma once

#include <map>
#include <optional>
#include <string>

namespace tether_monitor::monitor
{
/// Priority of an alarm; the numbers are those of Alarm.msg.
enum class Severity
{
  WARNING = 1,
  ALARM = 2,
  CRITICAL = 3
};

/// Which side of the limit is bad.
enum class Side
{
  ABOVE,
  BELOW
};

/// How one alarm behaves in time.
struct AlarmTiming
{
  double on_delay = 0.0;       ///< [s], >= 0: the value must be past the limit this long.
  double off_delay = 0.0;      ///< [s], >= 0: the value must be back past the deadband this long.
  double deadband = 0.0;       ///< >= 0, in the unit of the limit: how far back the value must come.
  bool latch = false;          ///< a returned alarm stays until it is acknowledged.
  bool manual_reset = false;   ///< it stays, acknowledged, until it is reset as well.
  double realarm = 0.0;        ///< [s], >= 0: an acknowledged one that lasts so long is announced again; 0: never.
  double chatter_hold = 30.0;  ///< [s], >= 0: off-delay of one that chatters; 0: as ever.

  template <class Archive>
  void serialize(Archive& a)
  {
    a(on_delay, off_delay, deadband, latch, manual_reset, realarm, chatter_hold);
  }
};

/// Setpoints of one watched quantity: up to two alarms (warning and limit) with the same timing.
struct AlarmConfig
{
  std::optional<double> warning;  ///< unit of the quantity; none: no warning.
  std::optional<double> limit;    ///< unit of the quantity; none: no alarm, or what AlarmQuantity derives.
  AlarmTiming timing;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(warning, limit, timing);
  }
};

/// By name of the quantity; what is missing is as alarmQuantities() has it.
using AlarmsConfig = std::map<std::string, AlarmConfig>;

}  // namespace tether_monitor::monitor
