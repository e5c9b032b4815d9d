#pragma once

namespace tether_monitor::monitor
{
/// How far, how often and with how many tethers the node looks ahead.
struct ForecastConfig
{
  double horizon = 30.0;  ///< [s], 1..300.
  double rate = 1.0;      ///< [Hz], 0..5; 0: never.
  int members = 96;       ///< 8..1000.
};

}  // namespace tether_monitor::monitor
