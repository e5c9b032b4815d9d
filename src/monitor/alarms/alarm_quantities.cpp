#include "tether_monitor/monitor/alarms/alarm_quantities.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::monitor
{
namespace
{
AlarmValue workingUtilisation(const TetherEstimate& e)
{
  return {e.working_utilisation, e.working_utilisation_s};
}

AlarmValue breakingUtilisation(const TetherEstimate& e)
{
  return {e.breaking_utilisation, e.max_tension_s};
}

AlarmValue minTension(const TetherEstimate& e)
{
  return {e.min_tension, e.min_tension_s};
}

AlarmValue bendRadius(const TetherEstimate& e)
{
  return {e.governing_bend_radius, e.governing_bend_radius_s};
}

AlarmValue inputAge(const TetherEstimate& e)
{
  const double age = std::max(e.vessel_age, e.vehicle_overdue);
  return {e.payout_age > age ? e.payout_age : age, TetherEstimate::NONE};
}

std::optional<double> bendLimit(const Config& config)
{
  return core::bendLimit(config.tether, config.layout);
}

std::optional<double> poseTimeout(const Config& config)
{
  return config.pose_timeout;
}

// Name, unit, meaning, bad side, severity, {warning, limit, {on_delay, off_delay, deadband, latch}}, derived
// limit, value, is a tension.
const std::vector<AlarmQuantity> QUANTITIES{
    {"over_tension",
     "fraction of working_load",
     "largest tension over the working load of its section",
     Side::ABOVE,
     Severity::ALARM,
     {0.8, 1.0, {0.2, 2.0, 0.05, true}},
     nullptr,
     workingUtilisation,
     true},
    {"breaking",
     "fraction of breaking_load",
     "largest tension over the breaking load of its section",
     Side::ABOVE,
     Severity::CRITICAL,
     {std::nullopt, 0.9, {0.0, 2.0, 0.05, true}},
     nullptr,
     breakingUtilisation,
     true},
    {"slack",
     "N",
     "least tension",
     Side::BELOW,
     Severity::ALARM,
     {std::nullopt, std::nullopt, {1.0, 2.0, 0.0, false}},
     nullptr,
     minTension,
     false},
    {"bend_radius",
     "m",
     "least bend radius; its limit defaults to tether.min_bend_radius",
     Side::BELOW,
     Severity::ALARM,
     {std::nullopt, std::nullopt, {0.5, 2.0, 0.0, false}},
     bendLimit,
     bendRadius,
     false},
    {"stale_input",
     "s",
     "age of the oldest input; its limit defaults to pose_timeout",
     Side::ABOVE,
     Severity::ALARM,
     {std::nullopt, std::nullopt, {0.0, 1.0, 0.0, false}},
     poseTimeout,
     inputAge,
     false},
};
}  // namespace

const char* const OVER_TENSION = "over_tension";
const char* const BREAKING = "breaking";

const std::vector<AlarmQuantity>& alarmQuantities()
{
  return QUANTITIES;
}

AlarmConfig alarmConfig(const Config& config, const AlarmQuantity& quantity)
{
  const auto given = config.alarms.find(quantity.name);
  AlarmConfig alarm = given == config.alarms.end() ? quantity.defaults : given->second;
  if (!alarm.limit && quantity.derivedLimit)
    alarm.limit = quantity.derivedLimit(config);
  return alarm;
}

AlarmConfig& alarmConfig(Config& config, const std::string& name)
{
  for (const AlarmQuantity& quantity : alarmQuantities())
    if (quantity.name == name)
      return config.alarms.emplace(name, quantity.defaults).first->second;
  throw std::out_of_range("no alarm watches '" + name + "'");
}

std::vector<std::string> validateAlarms(const Config& config)
{
  std::vector<std::string> all;
  for (const AlarmQuantity& quantity : alarmQuantities())
  {
    const AlarmConfig alarm = alarmConfig(config, quantity);
    core::BoundsCheck check("monitor.alarms." + std::string(quantity.name) + ".");
    check.notNegative("on_delay", alarm.timing.on_delay, "s");
    check.notNegative("off_delay", alarm.timing.off_delay, "s");
    check.notNegative("deadband", alarm.timing.deadband, quantity.unit);
    if (alarm.limit)
      check.finite("limit", *alarm.limit, quantity.unit);
    if (alarm.warning)
    {
      const bool is_above = quantity.side == Side::ABOVE;
      const bool ordered =
          !alarm.limit || (is_above ? *alarm.warning <= *alarm.limit : *alarm.warning >= *alarm.limit);
      check.check(std::isfinite(*alarm.warning) && ordered, "warning", *alarm.warning,
                  is_above ? "<= limit" : ">= limit");
    }
    all.insert(all.end(), check.problems().begin(), check.problems().end());
  }
  return all;
}

std::vector<std::string> validateWithAlarms(const Config& config)
{
  std::vector<std::string> all = validate(config);
  const std::vector<std::string> of_alarms = validateAlarms(config);
  all.insert(all.end(), of_alarms.begin(), of_alarms.end());
  return all;
}

}  // namespace tether_monitor::monitor
