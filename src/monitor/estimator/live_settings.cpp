#include "tether_monitor/monitor/estimator/live_settings.h"

#include "tether_monitor/monitor/alarms/alarm_quantities.h"
#include "tether_monitor/monitor/config/config_fingerprint.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double ANY = 1e9, LONGEST_DELAY = 3600.0;  // [unit of the quantity], [s]

void addUncertainties(Config& c, std::vector<LiveSetting>& all)
{
  UncertaintyConfig& u = c.uncertainty;
  c.navigation.force_stddev = unknownForceStddev(c);
  const auto add = [&](const char* key, const char* meaning, double least, double most, double& value) {
    all.push_back({"uncertainty", key, meaning, least, most, &value});
  };
  add("tether.uncertainty.drag_normal", "standard deviation, relative", 0.0, 1.0, u.drag_normal);
  add("tether.uncertainty.drag_tangential", "standard deviation, relative", 0.0, 1.0, u.drag_tangential);
  add("tether.uncertainty.mass_per_length", "standard deviation, relative", 0.0, 0.3, u.mass_per_length);
  add("tether.uncertainty.length", "standard deviation, relative", 0.0, 0.2, u.length);
  add("tether.uncertainty.axial_stiffness", "standard deviation, relative", 0.0, 1.0, u.axial_stiffness);
  add("environment.current_stddev", "standard deviation of each horizontal component [m/s]", 0.0, 3.0, u.current);
  add("vehicle.force_stddev", "standard deviation of unknown forces on the vehicle [N]", 1e-3, 1e6,
      *c.navigation.force_stddev);
  add("vehicle.drag_stddev", "standard deviation, relative", 1e-3, 3.0, c.navigation.drag_stddev);
  add("tension_sensor.bias_stddev", "of the load cell, over the working load", 0.0, 1.0, u.tension_bias);
}

void addAlarms(Config& c, std::vector<LiveSetting>& all)
{
  for (const AlarmQuantity& quantity : alarmQuantities())
  {
    AlarmConfig& alarm = alarmConfig(c, quantity.name);
    const std::string key = "monitor.alarms." + std::string(quantity.name) + ".", unit = quantity.unit;
    const auto add = [&](const char* name, const std::string& meaning, double least, double most, double& value) {
      all.push_back({"alarms", key + name, meaning, least, most, &value});
    };
    if (!alarm.limit && !alarm.warning)
      continue;
    if (alarm.limit)
      add("limit", std::string(quantity.meaning) + " [" + unit + "]", -ANY, ANY, *alarm.limit);
    if (alarm.warning)
      add("warning", std::string(quantity.meaning) + " [" + unit + "]", -ANY, ANY, *alarm.warning);
    add("on_delay", "the value must be past the limit so long [s]", 0.0, LONGEST_DELAY, alarm.timing.on_delay);
    add("off_delay", "the value must be back so long [s]", 0.0, LONGEST_DELAY, alarm.timing.off_delay);
    add("deadband", "how far back the value must come [" + unit + "]", 0.0, ANY, alarm.timing.deadband);
  }
}
}  // namespace

std::vector<LiveSetting> liveSettings(Config& c)
{
  std::vector<LiveSetting> all;
  const auto add = [&](const char* group, const char* key, const char* meaning, double least, double most,
                       double& value) {
    all.push_back({group, key, meaning, least, most, &value});
  };
  add("tether", "tether.drag_normal", "drag coefficient across, on diameter * length", 0.0, 10.0,
      c.tether.drag_normal);
  add("tether", "tether.drag_tangential", "drag coefficient along, on diameter * length", 0.0, 10.0,
      c.tether.drag_tangential);
  add("tether", "tether.drag_amplification", "factor on drag_normal where the tether strums", 1.0, 10.0,
      c.drag_amplification);
  if (c.vehicle_mode == VehicleMode::OBSERVED)
  {
    addUncertainties(c, all);
    add("status", "monitor.degraded_stddev", "of an end tension over the working load: DEGRADED above", 1e-3, 10.0,
        c.navigation.degraded_stddev);
    add("status", "monitor.invalid_stddev", "of an end tension over the working load: INVALID above", 1e-3, 10.0,
        c.navigation.invalid_stddev);
  }
  addAlarms(c, all);
  return all;
}

bool differInLiveSettingsOnly(const Config& a, const Config& b)
{
  Config like_a = a, like_b = b;
  const std::vector<LiveSetting> from = liveSettings(like_a), to = liveSettings(like_b);
  if (from.size() != to.size())
    return false;
  for (std::size_t k = 0; k < from.size(); ++k)
    *to[k].value = *from[k].value;
  return fingerprint(like_a) == fingerprint(like_b);
}

}  // namespace tether_monitor::monitor
