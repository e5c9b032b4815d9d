#pragma once

namespace tether_monitor::monitor
{
/// Why a measurement was not accepted.
enum class Rejection
{
  NONE,
  NOT_FINITE,      ///< a number is NaN or infinite, or a covariance is not positive definite.
  BAD_QUATERNION,  ///< the orientation is not of unit length (within 1 %).
  OUT_OF_ORDER,    ///< not later than the last one of its kind.
  REPEATED,        ///< the same one of that time came before.
  TOO_LATE,        ///< older than what can still be put in its place.
  NOT_MEASURED,    ///< its covariance says that the position was not measured, and the mode needs it.
  FROZEN,          ///< the same to the last digit as those before: a frozen sensor.
  IMPLAUSIBLE      ///< a position that no body gets to, until others confirm it.
};

/// True for what is good, if only for a filter that puts late measurements in their place.
constexpr bool canBeReordered(Rejection rejection)
{
  return rejection == Rejection::NONE || rejection == Rejection::OUT_OF_ORDER;
}

/// A sentence about a Rejection.
const char* describe(Rejection rejection);

}  // namespace tether_monitor::monitor
