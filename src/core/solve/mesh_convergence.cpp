#include "tether_monitor/core/solve/mesh_convergence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "tether_monitor/core/assembly/end_forces.h"
#include "tether_monitor/core/solve/dynamic_relaxation.h"

namespace tether_monitor::core
{
namespace
{
constexpr double DURATION = 24.0, SAMPLE = 0.2, RAMP = 8.0;  // [s]
constexpr double HEAVE = 1.0, HEAVE_PERIOD = 8.0;            // [m], [s]
constexpr double CIRCLE = 5.0, CIRCLE_PERIOD = 60.0;         // [m], [s]
constexpr double SURGE_SPEED = 1.5;                          // [m/s]
constexpr double LEAST_ORDER = 0.25, SLOW_ORDER = 1.5;       // of convergence
constexpr double ANCHORED = 2.0;                             // diameters over the floor
constexpr double SLACK_SHARE = 0.25, LEAST_MOTION = 2e-4;    // of the slack, of the length
constexpr double BUDGET = 6e6;        // iterations times elements of all trials: a second at most, or two
constexpr int TRIAL_ITERATIONS = 60;  // of a full step
constexpr int MOST_HALVINGS = 4;      // of the step
constexpr int WIDTH = kernel::BLOCK;  // elements come in blocks
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

  EndMotion vessel(double t) const
  {
    const Ramp ramp(t);
    const double w = 2.0 * M_PI / HEAVE_PERIOD;
    EndMotion end = common(ends.vessel, t);
    end.position.z() += heave * ramp.share * std::sin(w * t);
    end.velocity.z() += heave * (ramp.rate * std::sin(w * t) + ramp.share * w * std::cos(w * t));
    return end;
  }
  EndMotion vehicle(double t) const
  {
    const double w = 2.0 * M_PI / CIRCLE_PERIOD, angle = w * Ramp(t).integral, rate = w * Ramp(t).share;
    EndMotion end = common(ends.vehicle, t);
    end.position += circle * Vector3(std::cos(angle) - 1.0, std::sin(angle), 0.0);
    end.velocity += circle * rate * Vector3(-std::sin(angle), std::cos(angle), 0.0);
    return end;
  }
  EndMotion common(const Vector3& place, double t) const
  {
    return {place + t * ends.velocity + Ramp(t).integral * way, ends.velocity + Ramp(t).share * way};
  }
};

// End tensions at every sample; empty if the motion could not be followed.
using Tensions = std::vector<Vector3>;  // vessel, vehicle, nothing

Tensions simulateTrial(const CableModel& model, const CableState& start, const TrialMotion& motion,
                       const StepperOptions& options, double& budget)
{
  Tensions record;
  CableState state = start;
  AdaptiveStepper stepper(model, options);
  DeployedCable cable(model, state.deployment);
  for (int i = 1; i * SAMPLE <= DURATION + 1e-9; ++i)
  {
    const double t0 = state.time, t = i * SAMPLE;
    BoundaryConditions paths;
    paths.vessel = EndTrajectory::between(t0, motion.vessel(t0), t, motion.vessel(t));
    if (!model.bodies().vehicle)
      paths.vehicle = EndTrajectory::between(t0, motion.vehicle(t0), t, motion.vehicle(t));
    const SolveReport report = stepper.advance(model, paths, t, state);
    budget -= static_cast<double>(report.iterations + report.steps) * model.elements();
    if (!report.converged() || budget < 0.0)
      return {};
    cable.update(model, state.deployment);
    const EndForces forces = endForces(cable, state);
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
    {
      if (!std::isfinite(mean[end] + square[end]))
        return INFINITE;
      if (mean[end] > 0.0)
        worst = std::max(worst, std::sqrt(square[end] / n) / (mean[end] / n));
    }
  }
  return std::isfinite(worst) ? worst : INFINITE;
}

// Horizontal direction in which the tether leads; where it hangs straight down, that of the flow.
Vector3 aheadOf(const CableModel& model, const SteadyEnds& ends)
{
  const Vector3 flow = ends.velocity - model.environment().current().at(0.0);
  for (Vector3 direction : {Vector3(ends.vessel - ends.vehicle), flow})
  {
    direction.z() = 0.0;
    if (direction.norm() > 1e-6 * model.length(ends.deployment))
      return direction.normalized();
  }
  return Vector3::UnitX();
}

// An end that lies on the floor is an anchor: nobody moves it about.
bool isAnchored(const CableModel& model, const Vector3& end)
{
  if (!model.environment().hasSeabed() || model.bodies().vehicle)
    return false;
  const Seabed::Place floor = model.environment().floorAt(end);
  const CableProperties& tether = model.elementProperties(model.elements() - 1);
  return (end.z() - floor.z) * floor.normal.z() < ANCHORED * tether.contact_diameter.value_or(tether.diameter);
}

class MeshConvergenceStudy
{
 public:
  MeshConvergenceStudy(const std::function<CableModel(int)>& make, const SteadyEnds& ends)
    : make_(make), ends_(ends)
  {
  }

  std::vector<Tensions> run(int elements, const StepperOptions& given)
  {
    std::vector<Tensions> records(2);
    if (left_ < 0.0)
      return records;
    StepperOptions options = given;
    options.max_iterations = std::min(options.max_iterations, TRIAL_ITERATIONS);
    try
    {
      const CableModel model = make_(elements);
      NodeField shape;
      SteadyStateSolver statics(model.nodes());
      const SolveReport steady = statics.solve(model, ends_, shape);
      left_ -= static_cast<double>(steady.iterations) * elements;
      if (!steady.converged())
        return records;
      TrialMotion motion{ends_, Vector3::Zero(), HEAVE, 0.0};
      motion.ends.vehicle = shape.back().head<3>();
      CableState start(0.0, shape, motion.ends.velocity, motion.ends.deployment);
      initializeContact(model, start);
      const SolveReport settled = settleContact(statics, model, motion.ends, start);
      left_ -= static_cast<double>(settled.iterations) * elements;
      if (!settled.isUsable())
        return records;
      const double slack = model.length(ends_.deployment) - (motion.ends.vessel - motion.ends.vehicle).norm();
      const double room = std::max(SLACK_SHARE * slack, LEAST_MOTION * model.length(ends_.deployment));
      if (!model.bodies().vehicle)
        motion.heave = std::min(HEAVE, room);
      const bool is_anchored = isAnchored(model, motion.ends.vehicle);
      motion.circle = is_anchored ? 0.0 : std::min(CIRCLE, room);
      for (int k = 0; k < 2; ++k)
      {
        motion.way = (is_anchored ? 0.0 : k == 0 ? SURGE_SPEED : -SURGE_SPEED) * aheadOf(model, motion.ends);
        records[k] = simulateTrial(model, start, motion, options, left_);
      }
    }
    catch (const std::invalid_argument&)
    {
      // Too few elements for what is fixed to the tether.
    }
    return records;
  }
  bool isPossible(int elements) const
  {
    try
    {
      make_(elements);
      return true;
    }
    catch (const std::invalid_argument&)
    {
      return false;
    }
  }

 private:
  const std::function<CableModel(int)>& make_;
  SteadyEnds ends_;
  double left_ = BUDGET;
};

int inBlocks(double elements, int fewest)
{
  return std::clamp(static_cast<int>(std::ceil(elements / WIDTH - 1e-9)) * WIDTH, fewest, MOST_ELEMENTS);
}
}  // namespace

MeshSelection selectMesh(const std::function<CableModel(int)>& make, const SteadyEnds& ends, double accuracy,
                         const StepperOptions& options, int fallback)
{
  MeshConvergenceStudy trials(make, ends);
  StepperOptions used = options;
  const MeshSelection given{fallback, options.step, INFINITE, false};
  int fewest = FEWEST_ELEMENTS;
  while (fewest < MOST_ELEMENTS && !trials.isPossible(fewest))
    fewest += WIDTH;
  if (2 * fewest > MOST_ELEMENTS)
    return given;

  MeshSelection choice = given;
  std::vector<Tensions> coarse = trials.run(fewest, used);
  double before = INFINITE;
  for (int elements = fewest; 2 * elements <= MOST_ELEMENTS; elements *= 2)
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
    if (!std::isfinite(choice.error))
      return given;
    // The error falls with a power of the number of elements: the number that is just enough.
    const double order = std::isfinite(before)
                             ? std::clamp(std::log2(before / std::max(choice.error, 1e-300)), LEAST_ORDER, 4.0)
                             : 2.0;
    if (order < SLOW_ORDER)  // much is left beyond the finer mesh
      choice.error /= 1.0 - std::pow(2.0, -order);
    choice.elements = inBlocks(elements * std::pow(choice.error / accuracy, 1.0 / order), fewest);
    choice.error *= std::pow(static_cast<double>(elements) / choice.elements, order);
    choice.converged = choice.error <= accuracy;
    break;
  }
  coarse = trials.run(choice.elements, used);
  for (int halving = 0; halving < MOST_HALVINGS; ++halving)
  {
    used.step = 0.5 * choice.step;
    const std::vector<Tensions> fine = trials.run(choice.elements, used);
    const double change = difference(coarse, fine);
    if (change <= std::max(accuracy, choice.error) || !std::isfinite(change))
      break;
    choice.step = used.step;
    coarse = fine;
  }
  return choice;
}

}  // namespace tether_monitor::core
