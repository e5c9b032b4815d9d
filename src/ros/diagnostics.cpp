#include "tether_monitor/ros/diagnostics.h"

#include "tether_monitor/ros/conversions.h"

namespace tether_monitor
{
std::string advice(monitor::Reason reason)
{
  using monitor::Reason;
  switch (reason)
  {
    case Reason::NONE:
      return "";
    case Reason::NO_INPUT:
      return "No pose yet from vessel or vehicle: check that vessel/pose (or odom) and vehicle/pose (or odom) are "
             "published "
             "and remapped to this node.";
    case Reason::SETTLING:
      return "The steady state to start from is being found; this takes one cycle.";
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
             "are wrong, "
             "or the tether is parting.";
    case Reason::MESH_COARSE:
      return "A bend is tighter than the elements resolve: tension near it is rough. Raise tether.elements.";
    case Reason::CLOCK_JUMP:
      return "Time ran backwards (a looping bag?) or leapt ahead; the monitor starts anew.";
  }
  return "";
}

void diagnose(const monitor::TetherEstimator& estimator, const DiagnosticFacts& facts,
              diagnostic_updater::DiagnosticStatusWrapper& status)
{
  using Level = diagnostic_msgs::DiagnosticStatus;
  const monitor::TetherEstimate& e = estimator.estimate();
  const unsigned char level = e.status == monitor::Status::OK         ? Level::OK
                              : e.status == monitor::Status::DEGRADED ? Level::WARN
                                                                      : Level::ERROR;
  if (e.reason == monitor::Reason::NONE)
    status.summaryf(level, "%s", describe(e.status));
  else
    status.summaryf(level, "%s: %s", describe(e.status), describe(e.reason));
  for (const monitor::Alarm& alarm : estimator.alarms().alarms())
    if (alarm.isRaised())
      status.mergeSummary(alarm.definition().severity == monitor::Severity::WARNING ? Level::WARN : Level::ERROR,
                          describeForPerson(alarm));
  if (e.reason != monitor::Reason::NONE)
    status.add("Likely cause and advice", advice(e.reason));
  status.add("Largest tension [N]", e.max_tension);
  status.add("Share of the working load [-]", e.working_utilisation);
  status.add("Age of the vessel pose [s]", e.vessel_age);
  status.add("Age of the vehicle pose [s]", e.vehicle_age);
  status.add("Deployed length [m]", estimator.model().length());
  status.add("Elements", estimator.model().elements());
  status.add("Steps", estimator.count().steps);
  status.add("Rejected steps", estimator.count().rejected);
  status.add("Newton iterations", estimator.count().iterations);
  status.add("Last solve", core::describe(estimator.lastSolve().status));
  status.add("Longest computing time of a cycle [ms]", 1e3 * facts.worst_step_time);
  status.add("Cycles", facts.ticks);
  for (const auto& [topic, refusal] : facts.refusals)
    status.addf("Refused on " + topic, "%ld, last: %s", refusal.count, refusal.last_reason.c_str());
}

}  // namespace tether_monitor
