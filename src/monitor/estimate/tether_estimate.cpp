#include "tether_monitor/monitor/estimate/tether_estimate.h"

namespace tether_monitor::monitor
{
const char* describe(Status status)
{
  switch (status)
  {
    case Status::OK:
      return "OK";
    case Status::DEGRADED:
      return "DEGRADED";
    case Status::INVALID:
      return "INVALID";
  }
  return "UNKNOWN";
}

const char* describe(Reason reason)
{
  switch (reason)
  {
    case Reason::NONE:
      return "NONE";
    case Reason::NO_INPUT:
      return "NO_INPUT";
    case Reason::SETTLING:
      return "SETTLING";
    case Reason::VESSEL_STALE:
      return "VESSEL_STALE";
    case Reason::VEHICLE_STALE:
      return "VEHICLE_STALE";
    case Reason::PAYOUT_STALE:
      return "PAYOUT_STALE";
    case Reason::REJECTED_INPUT:
      return "REJECTED_INPUT";
    case Reason::NOT_CONVERGED:
      return "NOT_CONVERGED";
    case Reason::OUT_OF_RANGE:
      return "OUT_OF_RANGE";
    case Reason::MESH_COARSE:
      return "MESH_COARSE";
    case Reason::CLOCK_JUMP:
      return "CLOCK_JUMP";
    case Reason::DISAGREEMENT:
      return "DISAGREEMENT";
    case Reason::UNCERTAIN:
      return "UNCERTAIN";
  }
  return "UNKNOWN";
}

}  // namespace tether_monitor::monitor
