#include "tether_monitor/core/mesh_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "tether_monitor/core/cable_forces.h"
#include "tether_monitor/core/contact.h"
#include "tether_monitor/core/settling.h"

namespace tether_monitor::core
{
namespace
{
constexpr double DURATION = 24.0, SAMPLE = 0.2, RAMP = 8.0;  // [s]
constexpr double HEAVE = 1.0, HEAVE_PERIOD = 8.0;            // [m], [s]
constexpr double CIRCLE = 5.0, CIRCLE_PERIOD = 60.0;         // [m], [s]
constexpr double WAY = 1.5;                                  // [m/s]
constexpr double SLACK_SHARE = 0.25, LEAST_MOTION = 2e-4;    // of the slack, of the length
constexpr int WIDTH = kernel::BLOCK;                         // elements come in blocks
constexpr double INFINITE = std::numeric_limits<double>::infinity();

// A motion that begins with a smooth ramp: its share and the time it has gone on for.
struct Ramp
{
  double share, rate, integral;
  explicit Ramp(double t)
  {
    const double u = std::min(t / RAMP, 1.0);
    share = u * u * (3.0 - 2.0 * u);
    rate = 6.0 * u * (1.0 - u) / RAMP;
    integral = RAMP * (u * u * u - 0.5 * u * u * u * u) + std::max(t - RAMP, 0.0);
  }
};

struct TrialMotion
{
  SteadyEnds ends;
  Vector3 way;  // velocity that is gathered
  double heave, circle;

  EndPoint vessel(double t) const
  {
    const Ramp ramp(t);
    const double w = 2.0 * M_PI / HEAVE_PERIOD;
    EndPoint end = common(ends.vessel, t);
    end.position.z() += heave * ramp.share * std::sin(w * t);
    end.velocity.z() += heave * (ramp.rate * std::sin(w * t) + ramp.share * w * std::cos(w * t));
    return end;
  }
  EndPoint vehicle(double t) const
  {
    const double w = 2.0 * M_PI / CIRCLE_PERIOD, angle = w * Ramp(t).integral, rate = w * Ramp(t).share;
    EndPoint end = common(ends.vehicle, t);
    end.position += circle * Vector3(std::cos(angle) - 1.0, std::sin(angle), 0.0);
    end.velocity += circle * rate * Vector3(-std::sin(angle), std::cos(angle), 0.0);
    return end;
  }
  EndPoint common(const Vector3& place, double t) const
  {
    return {place + t * ends.velocity + Ramp(t).integral * way, ends.velocity + Ramp(t).share * way};
  }
};

// End tensions at every sample; empty if the motion could not be followed.
using Tensions = std::vector<Vector3>;  // vessel, vehicle, nothing

Tensions tryOut(CableModel& model, const NodeField& shape, const TrialMotion& motion,
                const StepperOptions& options)
{
  Tensions record;
  CableState state(0.0, shape, motion.ends.velocity);
  beginContact(model, state);
  Stepper stepper(model, options);
  for (int i = 1; i * SAMPLE <= DURATION + 1e-9; ++i)
  {
    const double t0 = state.time, t = i * SAMPLE;
    EndPaths paths;
    paths.vessel = EndPath::between(t0, motion.vessel(t0), t, motion.vessel(t));
    if (!model.bodies().vehicle)
      paths.vehicle = EndPath::between(t0, motion.vehicle(t0), t, motion.vehicle(t));
    if (!stepper.advance(model, paths, t, state).converged())
      return {};
    const EndForces forces = endForces(model, state);
    record.emplace_back(forces.vessel.norm(), forces.vehicle.norm(), 0.0);
  }
  return record;
}

double difference(const std::vector<Tensions>& coarse, const std::vector<Tensions>& fine)
{
  double worst = 0.0;
  for (std::size_t k = 0; k < coarse.size(); ++k)
  {
    if (coarse[k].empty() || fine[k].empty())
      return INFINITE;
    Vector3 square = Vector3::Zero(), mean = Vector3::Zero();
    for (std::size_t i = 0; i < coarse[k].size(); ++i)
    {
      square += (coarse[k][i] - fine[k][i]).cwiseAbs2();
      mean += fine[k][i];
    }
    const double n = static_cast<double>(coarse[k].size());
    for (int end = 0; end < 2; ++end)
      if (mean[end] > 0.0)
        worst = std::max(worst, std::sqrt(square[end] / n) / (mean[end] / n));
  }
  return std::isfinite(worst) ? worst : INFINITE;
}

class Trials
{
 public:
  Trials(const std::function<CableModel(int)>& make, const SteadyEnds& ends) : make_(make)
  {
    Vector3 ahead = ends.vessel - ends.vehicle;
    ahead.z() = 0.0;
    ahead = ahead.norm() > 1e-9 ? Vector3(ahead.normalized()) : Vector3::UnitX();
    for (const double way : {WAY, -WAY})
      motions_.push_back({ends, way * ahead, 0.0, 0.0});
  }

  std::vector<Tensions> run(int elements, const StepperOptions& options)
  {
    std::vector<Tensions> records(motions_.size());
    try
    {
      CableModel model = make_(elements);
      NodeField shape;
      Statics statics(model.nodes());
      SteadyEnds ends = motions_.front().ends;
      if (!findSteadyState(statics, model, ends, shape).converged())
        return records;
      ends.vehicle = shape.back().head<3>();
      const double slack = SLACK_SHARE * std::max(model.length() - (ends.vessel - ends.vehicle).norm(), 0.0);
      const double room = std::max(slack, LEAST_MOTION * model.length());
      for (std::size_t k = 0; k < motions_.size(); ++k)
      {
        TrialMotion motion = motions_[k];
        motion.heave = model.bodies().vehicle ? HEAVE : std::min(HEAVE, room);
        motion.circle = std::min(CIRCLE, room);
        records[k] = tryOut(model, shape, motion, options);
      }
    }
    catch (const std::invalid_argument&)
    {
      // Too few elements for what is fixed to the tether.
    }
    return records;
  }

 private:
  const std::function<CableModel(int)>& make_;
  std::vector<TrialMotion> motions_;
};

int inBlocks(double elements)
{
  return std::clamp(static_cast<int>(std::ceil(elements / WIDTH - 1e-9)) * WIDTH, FEWEST_ELEMENTS, MOST_ELEMENTS);
}
}  // namespace

MeshChoice chooseMesh(const std::function<CableModel(int)>& make, const SteadyEnds& ends, double accuracy,
                      const StepperOptions& options)
{
  Trials trials(make, ends);
  StepperOptions used = options;
  MeshChoice choice{MOST_ELEMENTS, options.step, INFINITE, false};
  std::vector<Tensions> coarse = trials.run(FEWEST_ELEMENTS, used);
  double before = INFINITE;
  for (int elements = FEWEST_ELEMENTS; elements <= MOST_ELEMENTS / 2; elements *= 2)
  {
    const std::vector<Tensions> fine = trials.run(2 * elements, used);
    choice.error = difference(coarse, fine);
    coarse = fine;
    const bool is_last = 4 * elements > MOST_ELEMENTS;
    if (choice.error > accuracy && !is_last)
    {
      before = choice.error;
      continue;
    }
    // The error falls with a power of the number of elements: the number that is just enough.
    const double order = std::isfinite(before) ? std::clamp(std::log2(before / choice.error), 1.0, 4.0) : 2.0;
    const double enough = elements * std::pow(choice.error / accuracy, 1.0 / order);
    choice.elements = std::isfinite(enough) ? inBlocks(enough) : MOST_ELEMENTS;
    choice.error *= std::pow(static_cast<double>(elements) / choice.elements, order);
    choice.reached = choice.error <= accuracy;
    break;
  }
  coarse = trials.run(choice.elements, used);
  for (int halving = 0; halving < 4; ++halving)
  {
    used.step = 0.5 * choice.step;
    const std::vector<Tensions> fine = trials.run(choice.elements, used);
    if (difference(coarse, fine) <= accuracy)
      break;
    choice.step = used.step;
    coarse = fine;
  }
  return choice;
}

}  // namespace tether_monitor::core
