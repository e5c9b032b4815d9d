#pragma once

namespace tether_monitor::monitor
{
/// How far the numbers of an estimate may be used; the numbers are those of TetherState.msg.
enum class Status
{
  OK = 0,
  DEGRADED = 1,
  INVALID = 2
};

/// Why the status is not OK; the numbers are those of TetherState.msg.
enum class Reason
{
  NONE = 0,
  NO_INPUT,
  SETTLING,  ///< a start is looked for (INVALID), or what was found still moves (DEGRADED).
  VESSEL_STALE,
  VEHICLE_STALE,
  PAYOUT_STALE,
  REJECTED_INPUT,
  NOT_CONVERGED,
  OUT_OF_RANGE,
  MESH_COARSE,
  CLOCK_JUMP,
  DISAGREEMENT,
  UNCERTAIN
};

/// The word of the message constant, without its prefix: "DEGRADED", "VESSEL_STALE"; "UNKNOWN" for any other
/// number.
const char* describe(Status status);
const char* describe(Reason reason);

/// Likely cause of a reason, and what to do about it, in a sentence; empty for NONE.
const char* advice(Reason reason);

}  // namespace tether_monitor::monitor
