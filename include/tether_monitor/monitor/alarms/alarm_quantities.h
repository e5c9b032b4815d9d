#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/monitor/alarms/alarm_values.h"
#include "tether_monitor/monitor/config/config.h"

namespace tether_monitor::monitor
{
/**
 * A watched quantity: its limit alarm has its name, its warning has "_warning" behind it.
 *
 * The one table of alarms: parameter loader, validation, alarm set and doc/alarms.md follow it. A new alarm is an
 * entry and a function here, and a test: CONTRIBUTING.md has the recipe.
 */
struct AlarmQuantity
{
  const char* name;     ///< key below monitor.alarms.
  const char* unit;     ///< of value and limits.
  const char* meaning;  ///< a phrase for the documents.
  const char* advice;   ///< what to do, a sentence.
  Side side;
  Severity severity;  ///< of the limit alarm; a warning is a WARNING.
  AlarmConfig defaults;
  std::optional<double> (*derivedLimit)(const Config&);  ///< limit where the configuration has none; null: none.
  AlarmValue (*value)(const TetherEstimate&, const AlarmInputs&);  ///< NaN while unknown.
  bool is_tension;  ///< its warning watches the upper confidence bound of the tension.
};

/// All of them, in the order in which alarms are published. over_tension comes first.
const std::vector<AlarmQuantity>& alarmQuantities();

/// That of a name. @throws std::out_of_range for an unknown one.
const AlarmQuantity& alarmQuantity(const std::string& name);

/// Names of the quantities behind the over-tension flag.
extern const char* const OVER_TENSION;
extern const char* const BREAKING;

/// Setpoints of a quantity: those of the configuration, else the defaults, with the derived limit in place.
AlarmConfig alarmConfig(const Config& config, const AlarmQuantity& quantity);
/// The same by name, to be changed in the configuration. @throws std::out_of_range for an unknown name.
AlarmConfig& alarmConfig(Config& config, const std::string& name);

/// Every bound of the alarms that `config` violates, one sentence each, named as in the parameter tree.
std::vector<std::string> validateAlarms(const Config& config);

/// What validate(config) finds, and then what validateAlarms() finds.
std::vector<std::string> validateWithAlarms(const Config& config);

}  // namespace tether_monitor::monitor
