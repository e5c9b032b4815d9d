#pragma once

#include <optional>

#include "tether_monitor/core/base/types.h"
#include "tether_monitor/monitor/forecast/end_motion_predictor.h"

namespace tether_monitor::monitor
{
/// What is done during a forecast, where it is not what is done now.
struct ForecastActions
{
  MotionCommand vessel;
  std::optional<double> payout_rate;   ///< [m/s]
  std::optional<core::Wrench> thrust;  ///< on a simulated vehicle, body axes.
};

}  // namespace tether_monitor::monitor
