#include "tether_monitor/monitor/measurements/rejection.h"

namespace tether_monitor::monitor
{
const char* describe(Rejection rejection)
{
  switch (rejection)
  {
    case Rejection::NONE:
      return "accepted";
    case Rejection::NOT_FINITE:
      return "a number is not finite, or a covariance is none";
    case Rejection::BAD_QUATERNION:
      return "the orientation is not a unit quaternion";
    case Rejection::OUT_OF_ORDER:
      return "the stamp is not later than the one before";
    case Rejection::REPEATED:
      return "the same measurement of that stamp came before";
    case Rejection::TOO_LATE:
      return "it is older than what can still be put in its place (vehicle.latency tells how late they are)";
    case Rejection::NOT_MEASURED:
      return "its covariance says that the position was not measured";
    case Rejection::FROZEN:
      return "the position repeats to the last digit: a frozen sensor";
    case Rejection::IMPLAUSIBLE:
      return "the position is farther from the last ones than a body can have gone";
  }
  return "unknown";
}

}  // namespace tether_monitor::monitor
