#include "tether_monitor/monitor/alarms/alarm_quantities.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tether_monitor/core/base/bounds_check.h"
#include "tether_monitor/monitor/alarms/alarm_values.h"

namespace tether_monitor::monitor
{
namespace
{
std::optional<double> bendLimit(const Config& config)
{
  return core::bendLimit(config.tether, config.layout);
}

std::optional<double> poseTimeout(const Config& config)
{
  return config.pose_timeout;
}

// Name, unit, meaning, advice, bad side, severity, {warning, limit, {on_delay, off_delay, deadband, latch}},
// derived limit, value, is a tension.
const std::vector<AlarmQuantity> QUANTITIES{
    {"over_tension",
     "fraction of working_load",
     "largest tension over the working load of its section",
     "Slow the vessel down or pay out.",
     Side::ABOVE,
     Severity::ALARM,
     {0.8, 1.0, {0.2, 2.0, 0.05, true}},
     nullptr,
     workingUtilisation,
     true},
    {"breaking",
     "fraction of breaking_load",
     "largest tension over the breaking load of its section",
     "Pay out at once and clear the deck: it may part.",
     Side::ABOVE,
     Severity::CRITICAL,
     {std::nullopt, 0.9, {0.0, 2.0, 0.05, true}},
     nullptr,
     breakingUtilisation,
     true},
    {"slack",
     "N",
     "least tension",
     "Take in, or open the distance; a slack tether kinks and snaps.",
     Side::BELOW,
     Severity::ALARM,
     {std::nullopt, std::nullopt, {1.0, 2.0, 0.0, false}},
     nullptr,
     minTension,
     false},
    {"snap",
     "N/s",
     "how fast the largest tension rises",
     "Avoid slack: pay out or recover with the waves, or slow down.",
     Side::ABOVE,
     Severity::ALARM,
     {std::nullopt, std::nullopt, {0.0, 5.0, 0.0, true}},
     nullptr,
     tensionRate,
     false},
    {"bend_radius",
     "m",
     "least bend radius; its limit defaults to tether.min_bend_radius",
     "Ease the tether where it is bent, and see what it hangs over.",
     Side::BELOW,
     Severity::ALARM,
     {std::nullopt, std::nullopt, {0.5, 2.0, 0.0, false}},
     bendLimit,
     bendRadius,
     false},
    {"seabed_contact",
     "m",
     "unstretched length on the seabed",
     "Take in, or raise the vehicle.",
     Side::ABOVE,
     Severity::ALARM,
     {std::nullopt, std::nullopt, {1.0, 2.0, 0.0, false}},
     nullptr,
     seabedContact,
     false},
    {"touchdown_near",
     "m",
     "horizontal distance from the vessel end to the touchdown point, bad below",
     "Move the vessel away, or pay out less: the touchdown point is too near.",
     Side::BELOW,
     Severity::ALARM,
     {std::nullopt, std::nullopt, {1.0, 2.0, 0.0, false}},
     nullptr,
     touchdownDistance,
     false},
    {"touchdown_far",
     "m",
     "the same, bad above",
     "Take in or come back: the touchdown point is too far away.",
     Side::ABOVE,
     Severity::ALARM,
     {std::nullopt, std::nullopt, {1.0, 2.0, 0.0, false}},
     nullptr,
     touchdownDistance,
     false},
    {"obstacle_contact",
     "N",
     "largest sum of contact forces on one obstacle",
     "Draw the tether clear of the obstacle.",
     Side::ABOVE,
     Severity::ALARM,
     {std::nullopt, 1.0, {0.5, 5.0, 0.0, false}},
     nullptr,
     obstacleForce,
     false},
    {"obstacle_clearance",
     "m",
     "least distance from the tether to an obstacle",
     "Keep the tether clear of the obstacle.",
     Side::BELOW,
     Severity::WARNING,
     {std::nullopt, std::nullopt, {1.0, 2.0, 0.0, false}},
     nullptr,
     clearance,
     false},
    {"lay_back",
     "m",
     "horizontal distance from the vessel end to the vehicle end",
     "Close the distance to the vehicle.",
     Side::ABOVE,
     Severity::ALARM,
     {std::nullopt, std::nullopt, {1.0, 2.0, 0.0, false}},
     nullptr,
     layBack,
     false},
    {"scope",
     "-",
     "deployed length over the depth of the vehicle end below the vessel end",
     "Pay out: there is little tether for this depth.",
     Side::BELOW,
     Severity::ALARM,
     {std::nullopt, std::nullopt, {1.0, 2.0, 0.0, false}},
     nullptr,
     scope,
     false},
    {"turns",
     "turns",
     "turns of the tether, either way round",
     "Turn the vehicle back by as many turns.",
     Side::ABOVE,
     Severity::ALARM,
     {std::nullopt, 5.0, {1.0, 2.0, 0.5, false}},
     nullptr,
     turns,
     false},
    {"resonance",
     "-",
     "nearness of the waves' frequency to a natural one, 1 where they are the same",
     "Change the deployed length or the course.",
     Side::ABOVE,
     Severity::WARNING,
     {std::nullopt, std::nullopt, {0.0, 30.0, 0.0, false}},
     nullptr,
     resonance,
     false},
    {"lock_in",
     "-",
     "share of the tether that strums",
     "Expect more drag and fatigue; change the speed.",
     Side::ABOVE,
     Severity::WARNING,
     {std::nullopt, std::nullopt, {10.0, 10.0, 0.0, false}},
     nullptr,
     lockIn,
     false},
    {"forecast",
     "-",
     "probability of over-tension within the horizon of the forecast",
     "Slow down or pay out as the recommended fields of the forecast say.",
     Side::ABOVE,
     Severity::WARNING,
     {std::nullopt, 0.5, {0.0, 3.0, 0.2, false}},
     nullptr,
     forecast,
     false},
    {"mismatch",
     "standard deviations",
     "load cell against predicted tension",
     "Look at the diagnostics: a snag, a wrong deployed length, or the load cell.",
     Side::ABOVE,
     Severity::ALARM,
     {std::nullopt, 4.0, {0.5, 5.0, 1.0, true}},
     nullptr,
     mismatch,
     false},
    {"stale_input",
     "s",
     "age of the oldest input; its limit defaults to pose_timeout",
     "See why the input has stopped; the diagnostics name it.",
     Side::ABOVE,
     Severity::ALARM,
     {std::nullopt, std::nullopt, {0.0, 1.0, 0.0, false}},
     poseTimeout,
     inputAge,
     false},
    {"implausible_input",
     "1 if so",
     "an input cannot be true, or contradicts the model",
     "Look at the diagnostics; do not rely on the tension.",
     Side::ABOVE,
     Severity::ALARM,
     {std::nullopt, 0.5, {0.0, 2.0, 0.0, false}},
     nullptr,
     implausible,
     false},
    {"deadline",
     "-",
     "share of the cycles of the last ten seconds that came late or not at all",
     "Free the computer from other work, or give the estimator a priority.",
     Side::ABOVE,
     Severity::WARNING,
     {std::nullopt, 0.05, {0.0, 10.0, 0.02, false}},
     nullptr,
     missedCycles,
     false},
    {"solver_fault",
     "1 if so",
     "no estimate can be computed",
     "Do not rely on the monitor; see the diagnostics, then reset.",
     Side::ABOVE,
     Severity::ALARM,
     {std::nullopt, 0.5, {1.0, 2.0, 0.0, false}},
     nullptr,
     solverFault,
     false},
};
}  // namespace

const char* const OVER_TENSION = "over_tension";
const char* const BREAKING = "breaking";

const std::vector<AlarmQuantity>& alarmQuantities()
{
  return QUANTITIES;
}

const AlarmQuantity& alarmQuantity(const std::string& name)
{
  for (const AlarmQuantity& quantity : QUANTITIES)
    if (quantity.name == name)
      return quantity;
  throw std::out_of_range("no alarm watches '" + name + "'");
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
  return config.alarms.emplace(name, alarmQuantity(name).defaults).first->second;
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
    check.notNegative("realarm", alarm.timing.realarm, "s");
    check.notNegative("chatter_hold", alarm.timing.chatter_hold, "s");
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
