#pragma once

#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/ros/recent_fixes.h"

namespace tether_monitor
{
/// Colour of a tension: blue at rest, yellow at the warning fraction of the working load, red from its limit on.
std_msgs::ColorRGBA utilisationColour(double utilisation, double warning);

/**
 * The picture of an estimate: the tether coloured by utilisation of its sections ("tether"), the end forces
 * ("force"), a line of text for status and alarms ("status"), obstacles ("obstacle", id their number) and the
 * seabed under the tether ("seabed"), and in mode observed the measured positions of the vehicle ("fixes"): of
 * each three lines along x, y and z, one standard deviation to either side. Namespaces and ids never change; while
 * INVALID tether and forces are deleted.
 */
visualization_msgs::MarkerArray markers(const std_msgs::Header& header, const monitor::TetherEstimator& estimator,
                                        const RecentFixes& fixes);

/// Where the tether will be ("forecast"): a pale line; deleted where there are no stations.
visualization_msgs::Marker forecastLine(const std_msgs::Header& header,
                                        const std::vector<core::Vector3>& stations);

}  // namespace tether_monitor
