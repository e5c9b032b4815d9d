#pragma once

#include "tether_monitor/ros/cycle_statistics.h"

namespace tether_monitor
{
/// What has been published and what was left out.
struct PublishingReport
{
  LatencyStatistics input_to_output;  ///< from the receipt of the newest message to the last number [s].
  long shed_markers = 0;              ///< outputs whose markers were left out.
  long shed_outputs = 0;              ///< outputs of which only alarms and events were published.
};

}  // namespace tether_monitor
