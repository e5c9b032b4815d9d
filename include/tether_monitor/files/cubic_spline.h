#pragma once

#include <vector>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::files
{
/**
 * Velocities at the knots of the twice continuously differentiable cubic through the points ("not a knot" at both
 * ends; a parabola through three points, a straight line through two).
 *
 * With these velocities the cubic Hermite curve between neighbouring points is that spline.
 *
 * @param t  times [s], strictly increasing, at least one.
 * @param x  points, one for each time.
 */
std::vector<core::Vector3> splineVelocities(const std::vector<double>& t, const std::vector<core::Vector3>& x);

}  // namespace tether_monitor::files
