#pragma once

#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/MarkerArray.h>

#include "tether_monitor/monitor/estimator/tether_estimator.h"

namespace tether_monitor
{
/// Colour of a tension: green at rest, yellow at the warning fraction of the working load, red from its limit on.
std_msgs::ColorRGBA utilisationColour(double utilisation, double warning);

/**
 * The picture of an estimate: the tether coloured by utilisation of its sections ("tether"), the end forces
 * ("force"), a line of text for status and alarms ("status"), obstacles ("obstacle", id their number) and the
 * seabed under the tether ("seabed"). Namespaces and ids never change; while INVALID tether and forces are
 * deleted.
 */
visualization_msgs::MarkerArray markers(const std_msgs::Header& header, const monitor::TetherEstimator& estimator);

}  // namespace tether_monitor
