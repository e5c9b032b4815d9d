#include "tether_monitor/simulation/position_sensor.h"

namespace tether_monitor::simulation
{
Sensor::Sensor(const SensorModel& plan, unsigned seed) : plan_(plan), generator_(seed)
{
}

core::Vector3 Sensor::noise(double stddev)
{
  std::normal_distribution<double> normal;
  const double x = normal(generator_), y = normal(generator_), z = normal(generator_);
  return stddev * core::Vector3(x, y, z);
}

Measurement Sensor::measure(double t, const monitor::BodyState& truth)
{
  std::uniform_real_distribution<double> share;
  Measurement m{t, truth, plan_.velocity};
  m.body.position += noise(plan_.position_stddev);
  m.body.velocity += noise(plan_.velocity_stddev);
  const core::Vector3 turn = noise(plan_.orientation_stddev);
  if (turn.norm() > 0.0)
    m.body.orientation = truth.orientation * Eigen::AngleAxisd(turn.norm(), turn.normalized());
  const core::Vector3 away = noise(1.0);
  if (share(generator_) < plan_.outlier)
    m.body.position +=
        (plan_.outlier_min + (plan_.outlier_size - plan_.outlier_min) * share(generator_)) * away.normalized();
  return m;
}

std::vector<Measurement> Sensor::sample(double t, const monitor::BodyState& truth)
{
  std::uniform_real_distribution<double> share;
  if (t >= next_ - 1e-9)
  {
    next_ += 1.0 / plan_.rate;
    if (next_ < t)
      next_ = t + 1.0 / plan_.rate;
    const Measurement m = measure(t, truth);
    const bool in_gap = t >= plan_.gap_from && t < plan_.gap_to;
    if (!(share(generator_) < plan_.dropout) && !in_gap)
      on_the_way_.push_back(m);
  }
  std::vector<Measurement> arrived;
  while (!on_the_way_.empty() && on_the_way_.front().time + plan_.latency <= t + 1e-9)
  {
    arrived.push_back(on_the_way_.front());
    on_the_way_.pop_front();
  }
  return arrived;
}

}  // namespace tether_monitor::simulation
