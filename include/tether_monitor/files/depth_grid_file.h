#pragma once

#include <string>

#include "tether_monitor/core/environment/seabed.h"

namespace tether_monitor::files
{
/**
 * Reads a grid of depths: a CSV file with the columns x, y, depth [m], one row for every node of a regular grid,
 * in any order.
 *
 * @throws std::runtime_error naming the file and what is wrong: not readable, other columns, nodes that are
 * missing, doubled or not evenly spaced.
 */
core::DepthGrid readDepthGrid(const std::string& path);

/// `name` if it is an absolute path, else the file of that name in `folder`.
std::string fileBeside(const std::string& folder, const std::string& name);

}  // namespace tether_monitor::files
