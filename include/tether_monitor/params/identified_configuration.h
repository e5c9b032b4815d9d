#pragma once

#include <string>

#include "tether_monitor/monitor/identification/identification.h"

namespace tether_monitor::params
{
/**
 * The configuration in a YAML file with what a record told of the tether and its vehicle in its place, and with
 * the standard deviations as `tether.uncertainty` and `vehicle.drag_stddev`. What the record did not tell, the
 * current, which is of the day, and comments are as they were or left out: the text begins with a comment that
 * says so.
 *
 * @param path              file from which `config` came.
 * @param length_is_counted  a winch told the deployed length: tether.length stays.
 * @throws std::runtime_error naming the file.
 */
std::string identifiedConfiguration(const std::string& path, const monitor::Config& config,
                                    const monitor::Identification& identification, bool length_is_counted);

}  // namespace tether_monitor::params
