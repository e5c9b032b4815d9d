#include "tether_monitor/monitor/estimator/input_findings.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double HIGHEST_VEHICLE = 3.0, DEEPEST_VESSEL = 10.0;  // over, under the surface [m]
}

void InputFindings::update(Subject subject, Implausibility what, double last, double t)
{
  if (last > record_.last(subject, what))
    record_.note(subject, what, t);
}

void InputFindings::collect(const VesselEnd& vessel, const VehicleEnd& vehicle, const PayoutFollower& payout,
                            double t)
{
  const auto ofBody = [&](Subject subject, const MotionPlausibility* seen)
  {
    for (int k = 0; seen && k < static_cast<int>(Implausibility::COUNT); ++k)
      update(subject, static_cast<Implausibility>(k), seen->last(static_cast<Implausibility>(k)), t);
  };
  ofBody(Subject::VESSEL, vessel.plausibility());
  ofBody(Subject::VEHICLE, vehicle.plausibility());
  vehicle.reportImprobable([&](Subject subject, Implausibility what) { note(subject, what, t); });
  const PayoutPlausibility& winch = payout.plausibility();
  update(Subject::WINCH, Implausibility::LENGTH_LEAP, winch.lastLeap(), t);
  update(Subject::WINCH, Implausibility::OTHER_LENGTH, winch.lastOther(), t);
  update(Subject::WINCH, Implausibility::FROZEN_LENGTH, winch.lastFrozen(), t);
  update(Subject::WINCH, Implausibility::CONTRADICTORY_RATE, winch.lastContradiction(), t);
}

void InputFindings::checkWorld(const core::EnvironmentModel& sea, const TetherEstimate& estimate)
{
  const double t = estimate.time;
  const auto heightOver = [&](const core::Vector3& end)
  { return end.z() - sea.waterKinematics(end - sea.origin(), t).surface; };
  if (heightOver(estimate.stations.position.back()) > HIGHEST_VEHICLE)
    note(Subject::VEHICLE, Implausibility::VEHICLE_ABOVE_WATER, t);
  if (heightOver(estimate.stations.position.front()) < -DEEPEST_VESSEL)
    note(Subject::VESSEL, Implausibility::VESSEL_UNDER_WATER, t);
}

}  // namespace tether_monitor::monitor
