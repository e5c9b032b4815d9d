#include "tether_monitor/rviz/panel_text.h"

#include <cmath>
#include <cstdio>

#include "tether_monitor/monitor/alarms/alarm_life.h"
#include "tether_monitor/monitor/estimate/status.h"
#include "tether_monitor/ros/force_text.h"

namespace tether_monitor
{
namespace
{
std::string percent(const char* what, double probability)
{
  char text[60];
  std::snprintf(text, sizeof(text), "%s %.0f %%", what, 100.0 * probability);
  return text;
}

std::string number(const char* format, double x)
{
  char text[100];
  std::snprintf(text, sizeof(text), format, x);
  return text;
}
}  // namespace

std::string estimateText(const TetherState& state)
{
  if (state.status > TetherState::STATUS_STOWED || state.reason > TetherState::REASON_IMPLAUSIBLE)
    return "unknown status: the message is of another version";
  const auto reason = static_cast<monitor::Reason>(state.reason);
  const std::string status =
      state.status == TetherState::STATUS_OK ? "valid" : describe(static_cast<monitor::Status>(state.status));
  return reason == monitor::Reason::NONE ? status : status + ": " + describe(reason);
}

std::string bandText(double tension, double p05, double p95)
{
  const std::string text = forceText(tension);
  if (!std::isfinite(p05) || !std::isfinite(p95))
    return text;
  return text + " (" + forceText(p05) + " to " + forceText(p95) + ")";
}

std::string largestText(const TetherState& state)
{
  return forceText(state.max_tension) + number(" at %.3g m", state.max_tension_s) +
         number("\n%.0f %% of working load", 100.0 * state.working_utilisation);
}

std::string lengthText(const TetherState& state)
{
  constexpr double AT_REST = 0.005;  // [m/s]
  const std::string text = number("%.4g m", state.length);
  if (!(std::abs(state.payout_rate) >= AT_REST))
    return text;
  return text + number(state.payout_rate > 0.0 ? ", out %.2f m/s" : ", in %.2f m/s", std::abs(state.payout_rate));
}

std::string forecastText(const TetherForecast& forecast)
{
  if (forecast.members == 0)
    return "no forecast";
  std::string text = number("next %.0f s: ", forecast.horizon);
  text += percent("over-tension", forecast.probability_over_tension);
  if (std::isfinite(forecast.time_to_limit))
    text += number(" in %.0f s", forecast.time_to_limit);
  text += percent("\nbreaking", forecast.probability_breaking) + percent(", slack", forecast.probability_slack);
  const double rate = forecast.recommended_payout_rate;
  if (std::isfinite(rate))
    text += rate > 0.0 ? number("\nsafe: paying out %.2f m/s or more", rate)
                       : number("\nsafe: hauling in up to %.2f m/s", -rate);
  if (std::isfinite(forecast.recommended_vessel_speed))
    text += number("\nsafe: vessel at %.1f m/s or less", forecast.recommended_vessel_speed);
  return text;
}

std::string alarmStateText(const Alarm& alarm)
{
  if (alarm.state > Alarm::OUT_OF_SERVICE)
    return "unknown";
  return describe(static_cast<monitor::AlarmState>(alarm.state));
}

std::string alarmValueText(double value, const std::string& unit)
{
  if (std::isnan(value))
    return "not known";
  if (unit.rfind("fraction", 0) == 0)
    return number("%.0f %%", 100.0 * value);
  if (unit == "N")
    return forceText(value);
  return number("%.3g", value) + (unit.empty() || unit == "-" ? "" : " " + unit);
}

bool isShown(const Alarm& alarm)
{
  return alarm.state != Alarm::NORMAL && alarm.state <= Alarm::OUT_OF_SERVICE &&
         !monitor::isPutAside(static_cast<monitor::AlarmState>(alarm.state));
}

}  // namespace tether_monitor
