#pragma once

#include <tether_monitor/Alarm.h>
#include <tether_monitor/TetherForecast.h>
#include <tether_monitor/TetherState.h>

#include <string>

namespace tether_monitor
{
/// "valid", or what the estimate is worth and why: "DEGRADED: UNCERTAIN".
std::string estimateText(const TetherState& state);

/// "4.54 kN", with its 5 and 95 % quantiles where they are known: "4.54 kN (3.91 kN to 5.3 kN)".
std::string bandText(double tension, double p05, double p95);

/// The largest tension, where it is, and what it is of the working load.
std::string largestText(const TetherState& state);

/// Deployed length, and how it changes: "250 m, in 0.20 m/s".
std::string lengthText(const TetherState& state);

/// What the next seconds are likely to bring, and what would keep the tether below its limit.
std::string forecastText(const TetherForecast& forecast);

/// State of an alarm: "ACTIVE"; what is past the codes is "unknown".
std::string alarmStateText(const Alarm& alarm);

/// "0.31 m", "76 %" of what is a fraction, "not known".
std::string alarmValueText(double value, const std::string& unit);

/// True for an alarm that an operator is to see: neither normal nor put aside.
bool isShown(const Alarm& alarm);

}  // namespace tether_monitor
