#include "tether_monitor/monitor/estimate/status.h"

namespace tether_monitor::monitor
{
Reason ReasonSet::gravest() const
{
  static constexpr Reason ORDER[] = {Reason::CLOCK_JUMP,    Reason::NO_INPUT,      Reason::NOT_CONVERGED,
                                     Reason::VESSEL_STALE,  Reason::VEHICLE_STALE, Reason::PAYOUT_STALE,
                                     Reason::IMPLAUSIBLE,   Reason::OUT_OF_RANGE,  Reason::MESH_COARSE,
                                     Reason::SETTLING,      Reason::DISAGREEMENT,  Reason::UNCERTAIN,
                                     Reason::REJECTED_INPUT};
  for (const Reason reason : ORDER)
    if (has(reason))
      return reason;
  return Reason::NONE;
}

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
    case Status::STOWED:
      return "STOWED";
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
    case Reason::IMPLAUSIBLE:
      return "IMPLAUSIBLE";
    case Reason::COUNT:
      break;
  }
  return "UNKNOWN";
}

const char* advice(Reason reason)
{
  switch (reason)
  {
    case Reason::NONE:
      return "";
    case Reason::NO_INPUT:
      return "No pose yet from vessel or vehicle: check that vessel/pose (or odom) and vehicle/pose (or odom) are "
             "published and remapped to this node.";
    case Reason::SETTLING:
      return "The steady state to start from is being found, or it was found and still moves: the tether slides "
             "or drifts.";
    case Reason::VESSEL_STALE:
      return "The vessel's pose has stopped: check its GNSS and motion sensor and the clocks of the machines.";
    case Reason::VEHICLE_STALE:
      return "The vehicle's pose has stopped: check its acoustic positioning and the clocks of the machines.";
    case Reason::PAYOUT_STALE:
      return "The winch has stopped reporting the deployed length.";
    case Reason::REJECTED_INPUT:
      return "A message was refused; the topic and the reason stand below.";
    case Reason::NOT_CONVERGED:
      return "The solver found no solution: compare the distance of the ends with tether.length; positions may "
             "have jumped.";
    case Reason::OUT_OF_RANGE:
      return "Tension above the breaking load or strain above 10 %: the deployed length, the positions or both "
             "are wrong, or the tether is parting.";
    case Reason::MESH_COARSE:
      return "A bend is tighter than the elements resolve: tension near it is rough. Raise tether.elements.";
    case Reason::DISAGREEMENT:
      return "Measured positions, deployed length and what is known of the vehicle contradict each other: look at "
             "the innovations below, and check positioning, length and the vehicle's parameters.";
    case Reason::UNCERTAIN:
      return "The tension is known too roughly (see its standard deviation): positions of the vehicle are missing "
             "or poor.";
    case Reason::CLOCK_JUMP:
      return "Time ran backwards (a looping bag?) or leapt ahead; the monitor starts anew.";
    case Reason::IMPLAUSIBLE:
      return "An input cannot be true, or what it has done is still in the tether: what was found stands below.";
    case Reason::COUNT:
      break;
  }
  return "";
}

}  // namespace tether_monitor::monitor
