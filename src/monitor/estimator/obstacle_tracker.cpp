#include "tether_monitor/monitor/estimator/obstacle_tracker.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
std::vector<std::string> problems(const std::vector<core::Obstacle>& obstacles)
{
  std::vector<std::string> all;
  for (std::size_t i = 0; i < obstacles.size(); ++i)
    for (const std::string& problem : core::validate(obstacles[i], "obstacles[" + std::to_string(i) + "]."))
      all.push_back(problem);
  return all;
}

// Whether the tether can keep its friction on them.
bool areSameThings(const std::vector<core::Obstacle>& a, const std::vector<core::Obstacle>& b)
{
  const auto is_same = [](const core::Obstacle& x, const core::Obstacle& y)
  { return x.name == y.name && (x.mass > 0.0) == (y.mass > 0.0); };
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), is_same);
}
}  // namespace

std::vector<std::string> ObstacleTracker::set(double t, const std::vector<core::Obstacle>& obstacles, bool running,
                                              CableSimulation& simulation, VehicleEnd& vehicle)
{
  std::vector<std::string> faults = problems(obstacles);
  if (!faults.empty())
    return faults;
  std::vector<core::Obstacle> now = obstacles;
  core::CableState& state = simulation.state;
  if (running)
    for (core::Obstacle& obstacle : now)
      obstacle.position += (state.time - t) * obstacle.velocity;
  const bool keeps_friction = running && areSameThings(now, simulation.model.environment().obstacles());
  simulation.model = simulation.model.withEnvironment(simulation.model.environment().withObstacles(now));
  time_ = running ? state.time : t;
  if (keeps_friction)
  {
    for (std::size_t k = 0; k < now.size(); ++k)
    {
      state.obstacles[k].position = now[k].position - simulation.origin();
      state.obstacles[k].velocity = now[k].velocity;
      vehicle.moveObstacle(k, simulation);
    }
    return {};
  }
  simulation.stepper.prepareObstacles(simulation.model);
  if (running)
  {
    simulation.updatedCable().initializeContact(state);
    vehicle.forgetPast(simulation);
  }
  return {};
}

std::vector<core::Obstacle> ObstacleTracker::at(double t, const CableSimulation& simulation) const
{
  std::vector<core::Obstacle> obstacles = simulation.model.environment().obstacles();
  const core::CableState& state = simulation.state;
  const bool were_stepped = state.obstacles.size() == obstacles.size() && state.time >= time_;
  for (std::size_t k = 0; k < obstacles.size(); ++k)
  {
    if (were_stepped && obstacles[k].mass > 0.0)
      obstacles[k].position = state.obstacles[k].position + simulation.origin();
    else if (std::isfinite(time_))
      obstacles[k].position += (t - time_) * obstacles[k].velocity;
  }
  return obstacles;
}

}  // namespace tether_monitor::monitor
