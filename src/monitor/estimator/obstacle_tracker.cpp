#include <algorithm>
#include <cmath>

#include "tether_monitor/monitor/estimator/tether_estimator.h"

namespace tether_monitor::monitor
{
std::vector<std::string> TetherEstimator::setObstacles(double t, const std::vector<core::Obstacle>& obstacles)
{
  std::vector<std::string> faults;
  for (std::size_t i = 0; i < obstacles.size(); ++i)
    for (const std::string& fault : core::validate(obstacles[i], "obstacles[" + std::to_string(i) + "]."))
      faults.push_back(fault);
  if (!faults.empty())
    return faults;
  std::vector<core::Obstacle> now = obstacles;
  if (settled_)
    for (core::Obstacle& obstacle : now)
      obstacle.position += (state_.time - t) * obstacle.velocity;

  const std::vector<core::Obstacle>& old = model_.environment().obstacles;
  const bool same =
      now.size() == old.size() && std::equal(now.begin(), now.end(), old.begin(),
                                             [](const core::Obstacle& a, const core::Obstacle& b)
                                             { return a.name == b.name && (a.mass > 0.0) == (b.mass > 0.0); });
  model_.sea().setObstacles(now);
  obstacles_at_ = settled_ ? state_.time : t;
  if (same && settled_)
  {
    // The tether keeps its grip: only the surfaces move.
    for (std::size_t k = 0; k < now.size(); ++k)
    {
      state_.obstacles[k].position = now[k].position - origin_;
      state_.obstacles[k].velocity = now[k].velocity;
      observer_.moveObstacle(k, state_.obstacles[k], state_.time);
    }
    return {};
  }
  stepper_.prepareObstacles(model_);
  estimate_.contact.obstacles.assign(now.size(), core::ContactSummary::ObstacleContact());
  if (settled_)
  {
    core::initializeContact(model_, state_);
    observer_.forgetPast(model_, state_);
  }
  return {};
}

// Takes the obstacles of the model to time t: those that are pushed from where they were last, the others on their
// way.
void TetherEstimator::moveObstacles(double t, const core::Vector3& origin)
{
  std::vector<core::Obstacle> obstacles = model_.environment().obstacles;
  const bool were_stepped = state_.obstacles.size() == obstacles.size() && state_.time >= obstacles_at_;
  for (std::size_t k = 0; k < obstacles.size(); ++k)
  {
    if (were_stepped && obstacles[k].mass > 0.0)
      obstacles[k].position = state_.obstacles[k].position + origin;
    else if (std::isfinite(obstacles_at_))
      obstacles[k].position += (t - obstacles_at_) * obstacles[k].velocity;
  }
  obstacles_at_ = t;
  model_.sea().setObstacles(obstacles);
}

}  // namespace tether_monitor::monitor
