#pragma once

#include <cstdint>

#include "tether_monitor/monitor/config/config.h"

namespace tether_monitor::monitor
{
/// A number that differs between configurations whose estimators cannot share a saved state: of everything that
/// goes into the model, the solver and the alarms.
std::uint64_t fingerprint(const Config& config);

}  // namespace tether_monitor::monitor
