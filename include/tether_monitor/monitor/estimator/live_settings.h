#pragma once

#include <string>
#include <vector>

#include "tether_monitor/monitor/config/config.h"

namespace tether_monitor::monitor
{
/// A number of a configuration that may be changed while the monitor works.
struct LiveSetting
{
  std::string group;               ///< tether, uncertainty, status or alarms.
  std::string key;                 ///< in the parameter tree, with dots: "monitor.alarms.slack.limit".
  std::string meaning;             ///< a phrase, with the unit.
  double least = 0.0, most = 0.0;  ///< sensible bounds; validate() has the last word.
  double* value = nullptr;         ///< in the configuration.
};

/// All of them: drag, what is uncertain (mode observed), thresholds of the status, and of every alarm the limits
/// that are set and its delays. @param config  must outlive them; what it leaves to a default is filled in.
std::vector<LiveSetting> liveSettings(Config& config);

/// Whether two configurations differ in such numbers only, as far as a saved state depends on them.
bool differInLiveSettingsOnly(const Config& a, const Config& b);

}  // namespace tether_monitor::monitor
