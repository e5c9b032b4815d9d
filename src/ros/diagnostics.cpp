#include "tether_monitor/ros/diagnostics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tether_monitor/core/cable/winch_drum.h"
#include "tether_monitor/monitor/config/suspicious_values.h"
#include "tether_monitor/ros/alarm_text.h"
#include "tether_monitor/ros/input_topics.h"

namespace tether_monitor
{
namespace
{
void diagnoseEnsemble(const monitor::TetherEstimator& estimator,
                      diagnostic_updater::DiagnosticStatusWrapper& status)
{
  const monitor::TetherEstimate& e = estimator.estimate();
  const monitor::TetherEnsemble& ensemble = *estimator.vehicle().ensemble();
  const monitor::InnovationStatistics& innovations = ensemble.innovations();
  status.add("Standard deviation of the vessel tension [N]", e.vessel_tension_stddev);
  status.add("Standard deviation of the vehicle tension [N]", e.vehicle_tension_stddev);
  status.add("Standard deviation of the vehicle position [m]", e.vehicle_position_stddev);
  status.addf("Disturbance force on the vehicle [N]", "%.0f %.0f %.0f, standard deviation %.0f", e.disturbance.x(),
              e.disturbance.y(), e.disturbance.z(), e.disturbance_stddev);
  for (const monitor::ParameterEstimate& p : estimator.parameters())
    status.addf(p.name, "%.4g +- %.2g (configured %.4g +- %.2g)", p.mean, p.stddev, p.configured,
                p.configured_stddev);
  status.add("Innovation, last [m]", innovations.last);
  status.add("Innovations over their expected size [-]", innovations.noise_scale);
  status.add("Bias of the innovations over chance [-]", innovations.normalized_innovation_mean);
  status.addf("Measurements of the vehicle", "%ld accepted, %ld refused as outliers, %ld re-acquired",
              innovations.accepted, innovations.refused, innovations.reacquired);
  status.add("Times that the parameters were drawn anew", ensemble.filter().resets());
  status.add("Members that had to be replaced", ensemble.members().replaced());
  status.add("Outliers of the vessel's motion", estimator.vessel().outliers());
}
// Poses that come but are refused are another matter than none.
std::string adviceOn(monitor::Reason reason, const DiagnosticInputs& inputs)
{
  using monitor::Reason;
  std::string text = advice(reason);
  if (reason != Reason::NO_INPUT && reason != Reason::VESSEL_STALE && reason != Reason::VEHICLE_STALE)
    return text;
  for (const auto& [name, refusal] : inputs.refusals)
  {
    const InputTopic* topic = findInputTopic(name);
    if (!topic || !topic->is_pose)
      continue;
    if (reason == Reason::NO_INPUT || (topic->stream == InputStream::VESSEL) == (reason == Reason::VESSEL_STALE))
      text = "Messages arrive on " + name + ", but they are refused (" + std::to_string(refusal.count) +
             "): " + refusal.last_reason + ".";
  }
  return text;
}

void diagnoseReasons(const monitor::TetherEstimator& estimator, const DiagnosticInputs& inputs,
                     diagnostic_updater::DiagnosticStatusWrapper& status)
{
  const monitor::TetherEstimate& e = estimator.estimate();
  if (e.reason != monitor::Reason::NONE)
    status.add("Likely cause and advice", adviceOn(e.reason, inputs));
  for (int k = 1; k < static_cast<int>(monitor::Reason::COUNT); ++k)
  {
    const auto reason = static_cast<monitor::Reason>(k);
    if (reason != e.reason && e.reasons.has(reason))
      status.add(std::string("Also ") + describe(reason), adviceOn(reason, inputs));
  }
  if (e.reasons.has(monitor::Reason::NOT_CONVERGED) || e.reasons.has(monitor::Reason::OUT_OF_RANGE))
    for (const std::string& value : monitor::suspiciousValues(estimator.config()))
      status.add("Suspicious", value);
  using monitor::Implausibility;
  using monitor::Subject;
  for (int s = 0; s < static_cast<int>(Subject::COUNT); ++s)
    for (int k = 0; k < static_cast<int>(Implausibility::COUNT); ++k)
    {
      const auto what = static_cast<Implausibility>(k);
      const double age = e.time - estimator.findings().last(static_cast<Subject>(s), what);
      if (estimator.findings().holds(static_cast<Subject>(s), what, e.time, estimator.memory()))
        status.addf(std::string("Implausible: ") + describe(static_cast<Subject>(s)), "%s (%.1f s ago)",
                    describe(what), age);
    }
}

// Fixes of an observed vehicle come late as a rule, which the estimate allows for.
void diagnoseSurroundings(const monitor::Config& config, const DiagnosticInputs& inputs,
                          diagnostic_updater::DiagnosticStatusWrapper& status)
{
  const bool may_be_late = config.vehicle_mode == monitor::VehicleMode::OBSERVED;
  using Level = diagnostic_msgs::DiagnosticStatus;
  constexpr double CLOCKS_AGREE = 0.05;  // [s]
  if (inputs.clock_stands)
    status.mergeSummary(Level::ERROR, "the clock stands still: nothing on /clock, so there are no new estimates");
  if (inputs.master_is_lost)
    status.mergeSummary(Level::ERROR, "the ROS master does not answer: new nodes cannot connect");
  double first = std::nan("");
  std::string first_topic;
  for (const auto& [topic, input] : inputs.statistics)
  {
    const InputTopic* known = findInputTopic(topic);
    if (!input.hasOffset() || !known || !known->is_pose)
      continue;
    const double offset = input.offset().mean;
    if (offset > CLOCKS_AGREE)
      status.mergeSummaryf(Level::WARN, "the clock of %s is %.3f s ahead of ours", topic.c_str(), offset);
    if (may_be_late && known->stream == InputStream::VEHICLE)
      continue;
    if (std::isnan(first))
    {
      first = offset;
      first_topic = topic;
    }
    else if (std::abs(offset - first) > CLOCKS_AGREE)
    {
      status.mergeSummaryf(Level::WARN,
                           "stamps of %s and %s lie %.3f s apart: their clocks disagree, or one comes late",
                           first_topic.c_str(), topic.c_str(), std::abs(offset - first));
    }
  }
}

void diagnoseLoadCell(const monitor::AlarmInputTracker& tracker,
                      diagnostic_updater::DiagnosticStatusWrapper& status)
{
  const monitor::LoadCellCheck& cell = tracker.loadCell();
  if (std::isnan(cell.mismatch()))
    return;
  const monitor::TensionResidual& residual = cell.residual();
  status.addf("Load cell", "%.4g N, predicted %.4g N: %.1f standard deviations; %s", residual.measured,
              residual.predicted, residual.normalized(), describe(cell.cause()));
  if (!std::isnan(cell.lengthError()) && cell.cause() == monitor::MismatchCause::LENGTH)
    status.addf("Load cell: length that would explain it", "%.2f m less than reported", cell.lengthError());
  if (!std::isnan(tracker.snag().s))
    status.addf("Held fast", "near s = %.0f m, between %.0f and %.0f m", tracker.snag().s, tracker.snag().nearest,
                tracker.snag().farthest);
}

void diagnoseInput(const std::string& topic, const InputStatistics& input,
                   diagnostic_updater::DiagnosticStatusWrapper& status)
{
  if (input.hasOffset())
    status.addf("Input " + topic, "%ld, %.3g Hz, stamp less receipt %.4f s (%.4f to %.4f)", input.count(),
                input.rate(), input.offset().mean, input.offset().least, input.offset().most);
  else
    status.addf("Input " + topic, "%ld, %.3g Hz", input.count(), input.rate());
  if (input.withoutTime() > 0)
    status.addf("Passed over on " + topic, "%ld without a stamp, in the same instant as the one before",
                input.withoutTime());
}
}  // namespace

void diagnose(const monitor::TetherEstimator& estimator, const DiagnosticInputs& inputs,
              diagnostic_updater::DiagnosticStatusWrapper& status)
{
  using Level = diagnostic_msgs::DiagnosticStatus;
  const monitor::TetherEstimate& e = estimator.estimate();
  const bool is_fine = e.status == monitor::Status::OK || e.status == monitor::Status::STOWED;
  const unsigned char level = is_fine                                 ? Level::OK
                              : e.status == monitor::Status::DEGRADED ? Level::WARN
                                                                      : Level::ERROR;
  if (e.reason == monitor::Reason::NONE)
    status.summaryf(level, "%s", describe(e.status));
  else
    status.summaryf(level, "%s: %s", describe(e.status), describe(e.reason));
  for (const monitor::Alarm& alarm : estimator.alarms().alarms())
    if (alarm.isAnnunciated())
      status.mergeSummary(alarm.definition().severity == monitor::Severity::WARNING ? Level::WARN : Level::ERROR,
                          alarmText(alarm, inputs.time));
  diagnoseReasons(estimator, inputs, status);
  diagnoseSurroundings(estimator.config(), inputs, status);
  if (estimator.vehicle().ensemble())
    diagnoseEnsemble(estimator, status);
  status.add("Largest tension [N]", e.max_tension);
  status.add("Share of the working load [-]", e.working_utilisation);
  status.add("Age of the vessel pose [s]", e.vessel_age);
  status.add("Age of the vehicle pose [s]", e.vehicle_age);
  status.add("Deployed length [m]", estimator.simulation().length());
  if (!std::isnan(e.payout_age))
    status.add("Age of the winch's report [s]", e.payout_age);
  if (estimator.config().winch)
  {
    const core::WinchDrum drum(*estimator.config().winch, estimator.config().tether.diameter);
    status.add("Winch: turns paid out", drum.turnsFor(estimator.simulation().length()));
    status.add("Winch: holds [m]", drum.capacity());
    status.add("Winch: bend radius on the drum [m]", drum.bendRadius());
  }
  for (std::size_t k = 0; k < e.contact.obstacles.size(); ++k)
    if (e.contact.obstacles[k].total > 0.0)
      status.addf("Touches obstacle '" + estimator.simulation().model.environment().obstacles()[k].name + "'",
                  "%.3g N at s = %.1f m", e.contact.obstacles[k].force.norm(), e.contact.obstacles[k].s);
  if (e.seabed_contact_length > 0.0)
    status.add("On the seabed [m]", e.seabed_contact_length);
  status.add("Elements", estimator.simulation().model.elements());
  status.add("Largest step [s]", estimator.simulation().mesh.step);
  if (estimator.config().accuracy)
    status.add("Expected error of the mesh [-]", estimator.simulation().mesh.error);
  status.add("Steps", estimator.simulation().count.steps);
  status.add("Rejected steps", estimator.simulation().count.rejected);
  status.add("Newton iterations", estimator.simulation().count.iterations);
  status.add("Last solve", core::describe(estimator.simulation().last_solve.status));
  status.add("Longest computing time of a cycle [ms]", 1e3 * inputs.worst_step_time);
  diagnoseLoadCell(estimator.alarmInputs(), status);
  if (inputs.forecast_members > 0)
    status.addf("Forecast", "%d members every %.3g s%s", inputs.forecast_members, inputs.forecast_interval,
                inputs.forecast_is_short ? ": the machine is too slow for what is configured" : "");
  for (const auto& [topic, input] : inputs.statistics)
    diagnoseInput(topic, input, status);
  for (const auto& [topic, refusal] : inputs.refusals)
    status.addf("Refused on " + topic, "%ld, last: %s", refusal.count, refusal.last_reason.c_str());
  for (const auto& [what, failure] : inputs.failures)
    status.addf("Failures of " + what, "%ld, last: %s", failure.count, failure.last_reason.c_str());
}

void diagnoseTiming(const DiagnosticInputs& inputs, const CycleStatistics& cycles,
                    const PublishingReport& publishing, diagnostic_updater::DiagnosticStatusWrapper& status)
{
  using Level = diagnostic_msgs::DiagnosticStatus;
  constexpr double MANY = 0.05;  // of the cycles
  status.summary(Level::OK, "on time");
  if (cycles.lateShare() > MANY)
    status.summaryf(Level::WARN, "%.0f %% of the last cycles came late or not at all", 100.0 * cycles.lateShare());
  if (!inputs.realtime_refusal.empty())
    status.mergeSummary(Level::WARN, "monitor.realtime: " + inputs.realtime_refusal);
  if (!inputs.state_file_problem.empty())
    status.mergeSummary(Level::WARN, "monitor.state_file: " + inputs.state_file_problem);
  if (inputs.lost_messages > 0)
    status.mergeSummary(Level::WARN, "messages were lost for want of room");
  const auto add = [&](const char* name, const LatencyStatistics& latency)
  {
    status.addf(name, "p50 %.3f, p99 %.3f, max %.3f ms", 1e3 * latency.quantile(0.5), 1e3 * latency.quantile(0.99),
                1e3 * latency.most());
  };
  status.addf("Cycles", "%ld, %ld missed", cycles.cycles(), cycles.missed());
  add("Wake-up after its time", cycles.lateness());
  add("Input to output", publishing.input_to_output);
  status.add("Outputs without markers for want of time", publishing.shed_markers);
  status.add("Outputs left out for want of time", publishing.shed_outputs);
  status.add("Messages lost for want of room", inputs.lost_messages);
}

double nearnessOfResonance(const monitor::VibrationReport& report)
{
  if (report.modes.empty() || !(report.encounter_frequency > 0.0))
    return std::numeric_limits<double>::quiet_NaN();
  double nearest = 0.0;
  for (const core::Mode& mode : report.modes)
    nearest = std::max(nearest, 1.0 - std::abs(mode.frequency / report.encounter_frequency - 1.0));
  return nearest;
}

void diagnoseVibration(const monitor::VibrationReport& report, diagnostic_updater::DiagnosticStatusWrapper& status)
{
  using Level = diagnostic_msgs::DiagnosticStatus;
  if (report.modes.empty())
  {
    status.summary(Level::OK, "not known yet");
    return;
  }
  status.summary(Level::OK, "no resonance");
  const core::VortexShedding& shedding = report.vortex_shedding;
  if (shedding.length > 0.0)
  {
    status.summaryf(Level::WARN, "transverse vibration: %.0f m of tether may strum at %.2g to %.2g Hz",
                    shedding.length, shedding.lowest_frequency, shedding.highest_frequency);
    status.add("Advice on strumming",
               "Vortices shake the tether across the flow; drag rises (tether.drag_amplification) "
               "and it wears. Fairings, or another speed, help.");
  }
  if (report.resonant)
  {
    const char* kind = report.resonant->kind == core::ModeKind::AXIAL ? "axial" : "transverse";
    char text[160];
    std::snprintf(text, sizeof(text), "resonance: waves meet the vessel at %.3g Hz, %s mode at %.3g Hz",
                  report.encounter_frequency, kind, report.resonant->frequency);
    status.mergeSummary(Level::WARN, text);
    status.add("Advice on resonance", "Change speed, course or deployed length.");
  }
  status.add("Vortex shedding, highest [Hz]", shedding.highest_frequency);
  status.add("Wave encounter [Hz]", report.encounter_frequency);
  for (std::size_t i = 0; i < report.modes.size(); ++i)
    status.addf("Mode " + std::to_string(i + 1), "%.4g Hz, %s", report.modes[i].frequency,
                report.modes[i].kind == core::ModeKind::AXIAL ? "axial" : "transverse");
}

}  // namespace tether_monitor
