// What VehicleObserver remembers: saved states, and the steps from there on.
#include <algorithm>
#include <cmath>

#include "tether_monitor/monitor/deployed_model.h"
#include "tether_monitor/monitor/vehicle_observer.h"

namespace tether_monitor::monitor
{
void VehicleObserver::moveObstacle(std::size_t k, const core::ObstacleMotion& now, double t)
{
  for (std::size_t i = 0; i < saved_.size(); ++i)
    if (k < saved_[i].state.obstacles.size())
    {
      core::ObstacleMotion& then = saved_[i].state.obstacles[k];
      then.position = now.position + (saved_[i].state.time - t) * now.velocity;
      then.velocity = now.velocity;
    }
}

void VehicleObserver::forgetPast(const core::CableModel& model, const core::CableState& state)
{
  if (saved_.empty())
    return;
  steps_.clear();
  saved_.clear();
  for (Saved& slot : saved_.slots())
    slot.state = state;
  save(model, state);
}

void VehicleObserver::save(const core::CableModel& model, const core::CableState& state)
{
  const double spacing = (navigation_.latency + OUT_OF_ORDER) / (SAVED - 4);
  if (!saved_.empty() && state.time < saved_.back().state.time + spacing)
    return;
  Saved& saved = saved_.extend();
  saved.state = state;
  saved.payout = model.payout();
  saved.live = live_;
}

// Back to the last saved state before `from`, and all steps from there again.
core::SolveReport VehicleObserver::again(double from, core::CableModel& model, core::Stepper& stepper,
                                         core::CableState& state)
{
  std::size_t kept = saved_.size();
  while (kept > 1 && saved_[kept - 1].state.time >= from)
    --kept;
  saved_.truncate(kept);
  state = saved_.back().state;
  live_ = saved_.back().live;
  if (saved_.back().payout.length != model.length() || saved_.back().payout.rate != model.payout().rate)
    model.setPayout(saved_.back().payout);
  core::SolveReport total;
  for (std::size_t i = 0; i < steps_.size(); ++i)
  {
    if (steps_[i].from < state.time - SAME)
      continue;
    const core::SolveReport report = make(steps_[i], model, stepper, state);
    total.addCost(report);
    total.status = report.status;
    total.residual = report.residual;
    repeated_ += report.steps;
    if (!report.converged())
      break;
  }
  return total;
}

bool VehicleObserver::isSound(const core::CableModel& model, const VehicleObserver& original) const
{
  if (!log_.isSound() || !live_.filter.isSound() || !steps_.isSound(original.steps_.capacity()) ||
      !saved_.isSound(original.saved_.capacity()))
    return false;
  for (std::size_t i = 0; i < saved_.size(); ++i)
    if (!isStateOf(saved_[i].state, model) || !saved_[i].live.filter.isSound() ||
        !(saved_[i].payout.length > 0.0) || (i > 0 && !(saved_[i].state.time > saved_[i - 1].state.time)))
      return false;
  for (std::size_t i = 0; i < steps_.size(); ++i)
  {
    const Step& step = steps_[i];
    const bool is_finite = std::isfinite(step.from) && step.to > step.from && std::isfinite(step.to) &&
                           step.paths.vessel.position(step.to).allFinite() &&
                           step.paths.vehicle_thrust.force.allFinite() && step.attitude.coeffs().allFinite() &&
                           step.vessel_stddev.allFinite();
    if (!is_finite || (i > 0 && step.from < steps_[i - 1].from))
      return false;
  }
  return true;
}

}  // namespace tether_monitor::monitor
