#include "tether_monitor/rviz/panel_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace tether_monitor
{
namespace
{
constexpr double NONE = std::numeric_limits<double>::quiet_NaN();
}

TEST(PanelText, SaysWhatTheEstimateIsWorth)
{
  TetherState state;
  EXPECT_EQ(estimateText(state), "valid");
  state.status = TetherState::STATUS_INVALID;
  state.reason = TetherState::REASON_VESSEL_STALE;
  const std::string text = estimateText(state);
  EXPECT_EQ(text.rfind("INVALID: ", 0), 0u) << text;
  EXPECT_NE(text.find("VESSEL_STALE"), std::string::npos) << text;
  state.reason = 200;
  EXPECT_NE(estimateText(state).find("another version"), std::string::npos);
}

TEST(PanelText, ABandIsSaidWhereItIsKnown)
{
  EXPECT_EQ(bandText(4540.0, NONE, NONE), "4.54 kN");
  EXPECT_EQ(bandText(4540.0, 910.0, 5300.0), "4.54 kN (910 N to 5.3 kN)");
  EXPECT_EQ(bandText(NONE, NONE, NONE), "unknown");
}

TEST(PanelText, OfTensionAndLength)
{
  TetherState state;
  state.max_tension = 4540.0;
  state.max_tension_s = 120.0;
  state.working_utilisation = 0.454;
  EXPECT_EQ(largestText(state), "4.54 kN at 120 m\n45 % of working load");
  state.length = 253.46;
  EXPECT_EQ(lengthText(state), "253.5 m");
  state.payout_rate = NONE;
  EXPECT_EQ(lengthText(state), "253.5 m");
  state.payout_rate = 0.3;
  EXPECT_EQ(lengthText(state), "253.5 m, out 0.30 m/s");
}

TEST(PanelText, OfAForecast)
{
  TetherForecast forecast;
  EXPECT_EQ(forecastText(forecast), "no forecast");
  forecast.members = 96;
  forecast.horizon = 30.0;
  forecast.probability_over_tension = 0.62;
  forecast.probability_breaking = 0.0;
  forecast.probability_slack = 0.031;
  forecast.time_to_limit = 14.2;
  forecast.recommended_payout_rate = 0.35;
  forecast.recommended_vessel_speed = NONE;
  EXPECT_EQ(forecastText(forecast),
            "next 30 s: over-tension 62 % in 14 s\nbreaking 0 %, slack 3 %\nsafe: paying out 0.35 m/s or more");
  forecast.recommended_payout_rate = -0.5;
  EXPECT_NE(forecastText(forecast).find("safe: hauling in up to 0.50 m/s"), std::string::npos);
}

TEST(PanelText, OfAValueOfAnAlarm)
{
  EXPECT_EQ(alarmValueText(NONE, "m"), "not known");
  EXPECT_EQ(alarmValueText(0.764, "fraction of working_load"), "76 %");
  EXPECT_EQ(alarmValueText(1234.0, "N"), "1.23 kN");
  EXPECT_EQ(alarmValueText(0.5, "m"), "0.5 m");
  EXPECT_EQ(alarmValueText(4.2, "-"), "4.2");
}

TEST(PanelText, AlarmsThatArePutAsideAreNotShown)
{
  for (int state = 0; state < 20; ++state)
  {
    Alarm alarm;
    alarm.state = static_cast<std::uint8_t>(state);
    EXPECT_EQ(isShown(alarm), state >= Alarm::UNACKNOWLEDGED && state <= Alarm::LATCHED) << state;
    EXPECT_FALSE(alarmStateText(alarm).empty());
  }
}
}  // namespace tether_monitor
