#include "tether_monitor/monitor/alarms/alarm_values.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
using Estimate = TetherEstimate;
using Inputs = AlarmInputs;
constexpr double NOWHERE = TetherEstimate::NONE;

// Unknown until there is an estimate, or a reason why there is none.
double flag(const Estimate& e, Reason one, Reason other)
{
  if (e.reason == Reason::NO_INPUT)
    return TetherEstimate::NONE;
  return e.reasons.has(one) || e.reasons.has(other) ? 1.0 : 0.0;
}

}  // namespace

AlarmValue workingUtilisation(const Estimate& e, const Inputs&)
{
  return {e.working_utilisation, e.working_utilisation_s};
}

AlarmValue breakingUtilisation(const Estimate& e, const Inputs&)
{
  return {e.breaking_utilisation, e.max_tension_s};
}

AlarmValue minTension(const Estimate& e, const Inputs&)
{
  return {e.min_tension, e.min_tension_s};
}

AlarmValue bendRadius(const Estimate& e, const Inputs&)
{
  return {e.governing_bend_radius, e.governing_bend_radius_s};
}

// What has never come has not stopped: the status says NO_INPUT.
AlarmValue inputAge(const Estimate& e, const Inputs&)
{
  const double age = std::max(e.vessel_age, e.vehicle_overdue);
  const double oldest = e.payout_age > age ? e.payout_age : age;
  return {std::isinf(oldest) ? Estimate::NONE : oldest, NOWHERE};
}

AlarmValue tensionRate(const Estimate& e, const Inputs& in)
{
  return {in.tension_rate, e.max_tension_s};
}

AlarmValue seabedContact(const Estimate& e, const Inputs&)
{
  return {e.seabed_contact_length, e.touchdown_s};
}

AlarmValue touchdownDistance(const Estimate& e, const Inputs& in)
{
  return {in.touchdown_distance, e.touchdown_s};
}

AlarmValue obstacleForce(const Estimate&, const Inputs& in)
{
  return {in.obstacle_force, in.obstacle_force_s};
}

AlarmValue clearance(const Estimate&, const Inputs& in)
{
  return {in.clearance, in.clearance_s};
}

AlarmValue layBack(const Estimate&, const Inputs& in)
{
  return {in.lay_back, NOWHERE};
}

AlarmValue scope(const Estimate&, const Inputs& in)
{
  return {in.scope, NOWHERE};
}

AlarmValue turns(const Estimate&, const Inputs& in)
{
  return {std::abs(in.turns), NOWHERE};
}

AlarmValue resonance(const Estimate&, const Inputs& in)
{
  return {in.resonance, NOWHERE};
}

AlarmValue lockIn(const Estimate&, const Inputs& in)
{
  return {in.lock_in, NOWHERE};
}

AlarmValue forecast(const Estimate&, const Inputs& in)
{
  return {in.forecast_probability, NOWHERE};
}

AlarmValue mismatch(const Estimate&, const Inputs& in)
{
  return {in.mismatch, in.mismatch_s};
}

AlarmValue missedCycles(const Estimate&, const Inputs& in)
{
  return {in.missed_cycles, NOWHERE};
}

AlarmValue implausible(const Estimate& e, const Inputs&)
{
  return {flag(e, Reason::IMPLAUSIBLE, Reason::DISAGREEMENT), NOWHERE};
}

AlarmValue solverFault(const Estimate& e, const Inputs&)
{
  const bool is_fault = e.status == Status::INVALID && e.reasons.has(Reason::OUT_OF_RANGE);
  return {is_fault ? 1.0 : flag(e, Reason::NOT_CONVERGED, Reason::NOT_CONVERGED), NOWHERE};
}

}  // namespace tether_monitor::monitor
