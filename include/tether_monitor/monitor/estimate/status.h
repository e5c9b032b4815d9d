#pragma once

#include <cstdint>

namespace tether_monitor::monitor
{
/// How far the numbers of an estimate may be used; the numbers are those of TetherState.msg.
enum class Status
{
  OK = 0,
  DEGRADED = 1,
  INVALID = 2,
  STOWED = 3  ///< no tether is out: no numbers, and no danger.
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
  UNCERTAIN,
  IMPLAUSIBLE,  ///< an input cannot be true, or what it has done is still in the tether.
  COUNT
};

/// All reasons that hold at one time.
class ReasonSet
{
 public:
  void add(Reason reason)
  {
    if (reason != Reason::NONE)
      bits_ |= 1u << static_cast<unsigned>(reason);
  }
  bool has(Reason reason) const { return (bits_ >> static_cast<unsigned>(reason)) & 1u; }
  bool isEmpty() const { return bits_ == 0; }
  /// The one that matters most: late inputs first, then unbelievable ones, then the model's.
  Reason gravest() const;
  /// Bit k is set if reason k holds.
  std::uint32_t bits() const { return bits_; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(bits_);
  }

 private:
  std::uint32_t bits_ = 0;
};

/// The word of the message constant, without its prefix: "DEGRADED", "VESSEL_STALE"; "UNKNOWN" for any other
/// number.
const char* describe(Status status);
const char* describe(Reason reason);

/// Likely cause of a reason, and what to do about it, in a sentence; empty for NONE.
const char* advice(Reason reason);

}  // namespace tether_monitor::monitor
