#include "tether_monitor/replay/replay_run.h"

#include <cmath>

namespace tether_monitor::replay
{
namespace
{
monitor::EndTargets targets(const Motion& motion, const monitor::Config& config, double t)
{
  monitor::EndTargets targets;
  targets.vessel = motion.vessel(t).attachmentPoint(config.vessel.attachment);
  if (config.vehicle_mode != monitor::VehicleMode::FREE)
    targets.vehicle = motion.vehicle(t).attachmentPoint(config.vehicle.attachment);
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
}  // namespace

void replayMotion(const Motion& motion, const ReplayOptions& options, monitor::TetherEstimator& estimator,
                  Recorder& recorder)
{
  const std::vector<double> times = outputTimes(motion, options.rate);
  const double step = estimator.config().solver.step;
  const auto inputs = [&](double t)
  {
    if (motion.hasCurrent())
      estimator.setCurrent(core::CurrentProfile(motion.current(t)));
    if (motion.hasThrust())
      estimator.setThrust(t, {motion.thrust(t), core::Vector3::Zero()});
  };
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const double from = i == 0 ? times[0] : times[i - 1];
    const int parts = i == 0 ? 1 : std::max(1, static_cast<int>(std::ceil((times[i] - from) / step - 1e-9)));
    for (int k = 1; k <= parts; ++k)
    {
      const double t = k == parts ? times[i] : from + k * (times[i] - from) / parts;
      inputs(t);
      recorder.beginStep();
      if (i == 0)
        estimator.begin(t, targets(motion, estimator.config(), t));
      else
        estimator.advance(t, targets(motion, estimator.config(), t));
      recorder.endStep();
      recorder.observe(estimator);
    }
    recorder.write(estimator);
    if (options.progress)
      options.progress((i + 1.0) / times.size());
  }
}

}  // namespace tether_monitor::replay
