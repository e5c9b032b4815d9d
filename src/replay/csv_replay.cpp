#include "tether_monitor/replay/csv_replay.h"

#include <cmath>
#include <stdexcept>

namespace tether_monitor::replay
{
namespace
{
monitor::EndTargets targets(const Motion& motion, const monitor::Config& config, double t)
{
  monitor::EndTargets targets;
  targets.vessel = motion.vessel(t).attachmentPoint(config.vessel.attachment);
  targets.clamps.vessel = monitor::clampDirection(config.vessel, motion.vessel(t).orientation);
  if (config.vehicle_mode != monitor::VehicleMode::FREE)
  {
    targets.vehicle = motion.vehicle(t).attachmentPoint(config.vehicle.attachment);
    targets.clamps.vehicle = -monitor::clampDirection(config.vehicle, motion.vehicle(t).orientation);
  }
  if (motion.hasPayout())
    targets.payout = motion.payout(t);
  return targets;
}

std::vector<double> outputTimes(const Motion& motion, double rate)
{
  if (rate <= 0.0)
    return motion.times();
  std::vector<double> times;
  for (long i = 0; motion.begin() + i / rate <= motion.end() + 1e-9 / rate; ++i)
    times.push_back(std::min(motion.begin() + i / rate, motion.end()));
  return times;
}

// Gives a row to the estimator; what it refuses shows in the status.
void add(const MeasurementRow& row, monitor::TetherEstimator& estimator)
{
  using monitor::Rejection;
  const auto note = [&](Rejection rejection)
  {
    if (rejection != Rejection::NONE)
      estimator.noteRejectedInput(row.t);
  };
  if (row.vessel)
    note(estimator.addVessel(*row.vessel));
  if (row.vessel_rates)
    note(estimator.addVessel(*row.vessel_rates));
  if (row.vehicle)
    note(estimator.addVehicle(*row.vehicle));
  if (row.vehicle_rates)
    note(estimator.addVehicle(*row.vehicle_rates));
  if (row.tension)
    note(estimator.addTension(row.t, *row.tension));
  if (row.direction)
    note(estimator.addDirection(row.t, *row.direction));
}

// Calls visit(t) at every step and write() at every output: between outputs equal parts of at most `step`.
template <typename Visit>
void run(const Motion& motion, const ReplayOptions& options, monitor::TetherEstimator& estimator,
         ResultRecorder& recorder, const Visit& visit)
{
  const std::vector<double> times = outputTimes(motion, options.rate);
  const double step = estimator.config().solver.step;
  bool is_whole = options.parting.has_value();
  if (is_whole && !(options.parting->t >= motion.begin() && options.parting->t < motion.end()))
    throw std::runtime_error("the tether cannot part at t = " + std::to_string(options.parting->t) +
                             " s: the motion is from " + std::to_string(motion.begin()) + " to " +
                             std::to_string(motion.end()) + " s");
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const double from = i == 0 ? times[0] : times[i - 1];
    const int parts = i == 0 ? 1 : std::max(1, static_cast<int>(std::ceil((times[i] - from) / step - 1e-9)));
    for (int k = 1; k <= parts; ++k)
    {
      const double t = k == parts ? times[i] : from + k * (times[i] - from) / parts;
      if (motion.hasCurrent())
        estimator.setCurrent(core::CurrentProfile(motion.current(t)));
      if (motion.hasThrust())
        estimator.setThrust(t, {motion.thrust(t), core::Vector3::Zero()});
      if (is_whole && t > options.parting->t)
        is_whole = !estimator.part(options.parting->s);
      recorder.startTimer();
      visit(t, i == 0);
      recorder.stopTimer();
      recorder.accumulate(estimator);
    }
    recorder.writeRow(estimator);
    if (options.is_interrupted && options.is_interrupted())
      return;
    if (options.progress)
      options.progress((i + 1.0) / times.size());
  }
}
}  // namespace

monitor::Config preparedToPart(monitor::Config config, const Parting& parting)
{
  if (config.vehicle_mode == monitor::VehicleMode::OBSERVED)
    throw std::invalid_argument(
        "a tether can part in modes tracked and free only: in mode observed the "
        "measurements would be those of a whole one");
  if (!(parting.s > 0.0 && parting.s < config.tether.length))
    throw std::invalid_argument("the tether cannot part at " + std::to_string(parting.s) +
                                " m: it must be > 0 and < tether.length");
  core::Attachment nothing;
  nothing.name = "parting";
  nothing.s = parting.s;
  config.layout.attachments.push_back(nothing);
  while (!core::validateElementCount(config.elements, config.tether.length, config.layout).empty() &&
         core::validateElementCount(config.elements + 1).empty())
    ++config.elements;
  return config;
}

void replayMotion(const Motion& motion, const ReplayOptions& options, monitor::TetherEstimator& estimator,
                  ResultRecorder& recorder)
{
  run(motion, options, estimator, recorder,
      [&](double t, bool is_first)
      {
        const monitor::EndTargets ends = targets(motion, estimator.config(), t);
        if (is_first)
          estimator.begin(t, ends);
        else
          estimator.advance(t, ends);
      });
}

void replayMeasurements(const RecordedMeasurements& measurements, const Motion& motion,
                        const ReplayOptions& options, monitor::TetherEstimator& estimator,
                        ResultRecorder& recorder)
{
  const auto& rows = measurements.rows();
  std::size_t next = 0;
  const std::optional<monitor::BodyState> vessel = measurements.vesselAtFirstRow();
  bool has_begun = !vessel;  // its velocity must be found out first
  if (vessel)
    estimator.setInitialVesselMotion(rows.front().t, *vessel);
  run(motion, options, estimator, recorder,
      [&](double t, bool)
      {
        for (; next < rows.size() && rows[next].t <= t; ++next)
          add(rows[next], estimator);
        if (motion.hasPayout())
          estimator.addPayout(t, motion.payout(t).length, motion.payout(t).rate);
        if (has_begun || !estimator.canBegin(t))
        {
          estimator.tick(t);
          return;
        }
        has_begun = true;
        estimator.beginFromTracks(t);
      });
}

}  // namespace tether_monitor::replay
