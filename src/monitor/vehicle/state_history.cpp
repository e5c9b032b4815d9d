// What VehicleObserver remembers: snapshot states, and the steps from there on.
#include <algorithm>
#include <cmath>

#include "tether_monitor/monitor/model/model_factory.h"
#include "tether_monitor/monitor/vehicle/vehicle_observer.h"

namespace tether_monitor::monitor
{
void VehicleObserver::moveObstacle(std::size_t k, const core::ObstacleMotion& now, double t)
{
  for (std::size_t i = 0; i < snapshots_.size(); ++i)
    if (k < snapshots_[i].state.obstacles.size())
    {
      core::ObstacleMotion& then = snapshots_[i].state.obstacles[k];
      then.position = now.position + (snapshots_[i].state.time - t) * now.velocity;
      then.velocity = now.velocity;
    }
}

void VehicleObserver::forgetPast(const core::CableState& state)
{
  if (snapshots_.empty())
    return;
  steps_.clear();
  snapshots_.clear();
  for (StateSnapshot& slot : snapshots_.storage())
    slot.state = state;
  save(state);
}

void VehicleObserver::save(const core::CableState& state)
{
  const double spacing = (navigation_.latency + OUT_OF_ORDER) / (SNAPSHOTS - 4);
  if (!snapshots_.empty() && state.time < snapshots_.back().state.time + spacing)
    return;
  StateSnapshot& snapshot = snapshots_.emplaceBack();
  snapshot.state = state;
  snapshot.filter_state = filter_state_;
}

// Back to the last snapshot state before `from`, and all steps from there rewindAndReplay.
core::SolveReport VehicleObserver::rewindAndReplay(double from, const core::CableModel& model,
                                                   core::AdaptiveStepper& stepper, core::CableState& state)
{
  std::size_t kept = snapshots_.size();
  while (kept > 1 && snapshots_[kept - 1].state.time >= from)
    --kept;
  snapshots_.resizeTo(kept);
  // The newest drag factors are the best for the past as well.
  snapshots_.back().state.deployment.drag_factor = state.deployment.drag_factor;
  state = snapshots_.back().state;
  filter_state_ = snapshots_.back().filter_state;
  core::SolveReport total;
  for (std::size_t i = 0; i < steps_.size(); ++i)
  {
    if (steps_[i].from < state.time - SAME)
      continue;
    const core::SolveReport report = advanceOneStep(steps_[i], model, stepper, state);
    total.addCost(report);
    total.status = report.status;
    total.residual = report.residual;
    replayed_ += report.steps;
    if (!report.converged())
      break;
  }
  return total;
}

bool VehicleObserver::isValid(const core::CableModel& model) const
{
  if (!history_.isValid() || !filter_state_.filter.isValid() || !steps_.isValid(steps_capacity_) ||
      !snapshots_.isValid(SNAPSHOTS))
    return false;
  for (std::size_t i = 0; i < snapshots_.size(); ++i)
    if (!isStateOf(snapshots_[i].state, model) || !snapshots_[i].filter_state.filter.isValid() ||
        (i > 0 && !(snapshots_[i].state.time > snapshots_[i - 1].state.time)))
      return false;
  for (std::size_t i = 0; i < steps_.size(); ++i)
  {
    const StepInput& step = steps_[i];
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
