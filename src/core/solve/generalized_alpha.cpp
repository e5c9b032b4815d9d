#include "tether_monitor/core/solve/generalized_alpha.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tether_monitor/core/base/bounds_check.h"
#include "tether_monitor/core/base/so3.h"

namespace tether_monitor::core
{
namespace
{
constexpr double SLOW_CONVERGENCE_RATIO =
    0.02;  // a residual that falls by less in an iteration wants the complete tangent
constexpr int EXTRAPOLATION_MAX_ITERATIONS =
    2;  // Newton iterations of a step after which the motion is taken to be smooth
}  // namespace

GeneralizedAlpha::GeneralizedAlpha(const CableModel& model, double spectral_radius, const NewtonOptions& options)
  : options_(options), residual_(model.nodes(), NodeCoords::Zero()), tangent_(model.nodes())
{
  BoundsCheck check;
  check.within("spectral_radius", spectral_radius, 0.0, 1.0, "[-]");
  throwIfInvalid("GeneralizedAlpha", check.problems());
  // Chung & Hulbert (1993): least damping of slow motion for the wanted damping of fast motion.
  alpha_m_ = (2.0 * spectral_radius - 1.0) / (spectral_radius + 1.0);
  alpha_f_ = spectral_radius / (spectral_radius + 1.0);
  gamma_ = 0.5 - alpha_m_ + alpha_f_;
  beta_ = 0.25 * (1.0 + alpha_f_ - alpha_m_) * (1.0 + alpha_f_ - alpha_m_);
  trial_ = CableState(0.0, residual_, Vector3::Zero());
  prepareObstacles(model);
}

void GeneralizedAlpha::prepareObstacles(const CableModel& model)
{
  bordered_ = borderedSystemFor(model, movable_obstacles_);
  initializeContact(model, trial_);
}

void GeneralizedAlpha::predict(const CableModel& model, const BoundaryConditions& ends, double h,
                               const CableState& state)
{
  // After an easy step the acceleration goes on as it did: aux lags behind it by a known part of a step, (M12).
  // Else it stays.
  const double lag = alpha_f_ - alpha_m_;
  const double more = state.last_iterations <= EXTRAPOLATION_MAX_ITERATIONS && lag > 0.05 ? 1.0 / lag : 0.0;
  trial_.time = state.time + h;
  trial_.step = h;
  const auto next = [&](const auto& a, const auto& b) { return (a + more * (a - b)).eval(); };
  const auto aux = [&](const auto& a, const auto& from_a, const auto& b)
  { return (((1.0 - alpha_f_) * a + alpha_f_ * from_a - alpha_m_ * b) / (1.0 - alpha_m_)).eval(); };
  for (std::size_t i = 0; i < state.q.size(); ++i)
  {
    trial_.a[i] = next(state.a[i], state.algorithmic_acceleration[i]);
    trial_.algorithmic_acceleration[i] = aux(trial_.a[i], state.a[i], state.algorithmic_acceleration[i]);
    trial_.v[i] = state.v[i] + h * ((1.0 - gamma_) * state.algorithmic_acceleration[i] +
                                    gamma_ * trial_.algorithmic_acceleration[i]);
    trial_.q[i] =
        state.q[i] + h * state.v[i] +
        h * h * ((0.5 - beta_) * state.algorithmic_acceleration[i] + beta_ * trial_.algorithmic_acceleration[i]);
  }
  const auto rotate = [&](const AttitudeState& from, AttitudeState& to, RotationIncrement& increment)
  {
    to.acceleration = next(from.acceleration, from.algorithmic_acceleration);
    to.algorithmic_acceleration = aux(to.acceleration, from.acceleration, from.algorithmic_acceleration);
    to.velocity = from.velocity +
                  h * ((1.0 - gamma_) * from.algorithmic_acceleration + gamma_ * to.algorithmic_acceleration);
    increment.rotation_increment =
        h * from.velocity +
        h * h * ((0.5 - beta_) * from.algorithmic_acceleration + beta_ * to.algorithmic_acceleration);
    to.orientation = from.orientation * expSO3(increment.rotation_increment);
  };
  if (model.bodies().vessel)
    rotate(state.vessel, trial_.vessel, vessel_);
  if (model.bodies().vehicle)
    rotate(state.vehicle, trial_.vehicle, vehicle_);
  trial_.obstacles = state.obstacles;
  for (ObstacleMotion& obstacle : trial_.obstacles)
    obstacle.position += h * obstacle.velocity;
  for (const int k : movable_obstacles_)
  {
    const ObstacleMotion& from = state.obstacles[k];
    ObstacleMotion& to = trial_.obstacles[k];
    to.acceleration = next(from.acceleration, from.algorithmic_acceleration);
    to.algorithmic_acceleration = aux(to.acceleration, from.acceleration, from.algorithmic_acceleration);
    to.velocity = from.velocity +
                  h * ((1.0 - gamma_) * from.algorithmic_acceleration + gamma_ * to.algorithmic_acceleration);
    to.position = from.position + h * from.velocity +
                  h * h * ((0.5 - beta_) * from.algorithmic_acceleration + beta_ * to.algorithmic_acceleration);
  }
  trial_.contact = state.contact;
  trial_.contact.step = h;
  placePrescribedEnds(model, ends, trial_);
}

ResidualSize GeneralizedAlpha::assemble(const CableModel& model, const BoundaryConditions& ends,
                                        const TangentWeights& weights, AssemblyMode wanted)
{
  BorderedSystem* border = movable_obstacles_.empty() ? nullptr : &bordered_;
  if (border)
    border->setZero();
  kernel_ = &model.kernel();
  if (wanted == AssemblyMode::RESIDUAL)
    model.assemble(trial_, residual_);
  else
    model.assemble(trial_, weights, residual_, tangent_,
                   wanted == AssemblyMode::COMPLETE ? TangentKind::COMPLETE : TangentKind::SYMMETRIC, border);

  double reaction = 0.0, unbalanced = 0.0;
  const auto couple = [&](const RigidBody& body, std::size_t node, const AttitudeState& rotation,
                          const Wrench& thrust, RotationIncrement& increment)
  {
    reaction = std::max({reaction, residual_[node].head<3>().norm(), 1e-3 * 9.81 * body.mass});

    const double open =
        increment.coupling.assemble(body, model.sea(), trial_.time, attachmentMotion(trial_, node), rotation,
                                    thrust, weights, residual_[node], tangent_.diagonal(static_cast<int>(node)));
    unbalanced = std::max(unbalanced, open);
  };
  if (model.bodies().vessel)
    couple(*model.bodies().vessel, 0, trial_.vessel, ends.vessel_thrust, vessel_);
  if (model.bodies().vehicle)
  {
    RigidBody body = *model.bodies().vehicle;
    body.force += ends.vehicle_force;
    couple(body, residual_.size() - 1, trial_.vehicle, ends.vehicle_thrust, vehicle_);
  }
  for (const int k : movable_obstacles_)
  {
    const double mass = model.environment().obstacles[k].mass;
    bordered_.residual(k) += mass * trial_.obstacles[k].acceleration;
    bordered_.diagonal(k) += weights.mass * mass * Matrix3::Identity();
    unbalanced = std::max(unbalanced, bordered_.residual(k).norm());
  }
  const PrescribedEnds held = prescribedEnds(model);
  ResidualSize size = imposePrescribedEnds(model, trial_.q, options_, held, residual_, reaction);
  if (unbalanced > size.largest || std::isnan(unbalanced))
    size.largest = unbalanced;
  if (model.bodies().vessel)
    vessel_.coupling.condense(residual_.front());
  if (model.bodies().vehicle)
    vehicle_.coupling.condense(residual_.back());
  imposePrescribedEnds(held, tangent_);
  for (const int k : movable_obstacles_)
  {
    if (held.vessel)
      bordered_.column(k, 0).topRows<3>().setZero();
    if (held.vehicle)
      bordered_.column(k, model.elements()).topRows<3>().setZero();
  }
  return size;
}

bool GeneralizedAlpha::solve()
{
  if (movable_obstacles_.empty())
    return tangent_.solve(*kernel_, residual_);
  return bordered_.solve(tangent_, residual_);
}

void GeneralizedAlpha::correct(const CableModel& model, const TangentWeights& weights, double scale,
                               const CableState& state)
{
  for (std::size_t i = 0; i < residual_.size(); ++i)
  {
    trial_.a[i] -= residual_[i];
    trial_.algorithmic_acceleration[i] -= scale * residual_[i];
    trial_.v[i] -= weights.damping * residual_[i];
    trial_.q[i] -= weights.stiffness * residual_[i];
  }
  const auto rotate =
      [&](const AttitudeState& from, AttitudeState& to, RotationIncrement& increment, const NodeCoords& node)
  {
    const Vector3 delta = increment.coupling.solve(node);
    to.acceleration -= delta;
    to.algorithmic_acceleration -= scale * delta;
    to.velocity -= weights.damping * delta;
    increment.rotation_increment -= weights.stiffness * delta;
    to.orientation = from.orientation * expSO3(increment.rotation_increment);
  };
  if (model.bodies().vessel)
    rotate(state.vessel, trial_.vessel, vessel_, residual_.front());
  if (model.bodies().vehicle)
    rotate(state.vehicle, trial_.vehicle, vehicle_, residual_.back());
  for (const int k : movable_obstacles_)
  {
    ObstacleMotion& to = trial_.obstacles[k];
    const Vector3 delta = bordered_.solution(k);
    to.acceleration -= delta;
    to.algorithmic_acceleration -= scale * delta;
    to.velocity -= weights.damping * delta;
    to.position -= weights.stiffness * delta;
  }
}

SolveReport GeneralizedAlpha::step(CableModel& model, const BoundaryConditions& ends, double h, CableState& state)
{
  const double scale = (1.0 - alpha_f_) / (1.0 - alpha_m_);
  const TangentWeights weights{1.0, gamma_ * h * scale, beta_ * h * h * scale};
  if (ends.payout)
    model.setPayout(ends.payout->at(state.time + h));
  if (state.obstacles.size() != model.environment().obstacles.size())
    initializeContact(model, state);
  predict(model, ends, h, state);

  SolveReport report;
  report.status = SolveStatus::NOT_CONVERGED;
  double previous = 0.0;
  AssemblyMode wanted = state.last_iterations == 0 && movable_obstacles_.empty() ? AssemblyMode::RESIDUAL
                                                                                 : AssemblyMode::SYMMETRIC,
               tangent = AssemblyMode::SYMMETRIC;
  for (int k = 0;; ++k)
  {
    ResidualSize size = assemble(model, ends, weights, wanted);
    report.residual = size.largest;
    if (size.largest <= size.tolerance)
    {
      report.status = SolveStatus::CONVERGED;
      report.steps = 1;
      trial_.last_iterations = report.iterations;
      trial_.vessel.orientation.normalize();
      trial_.vehicle.orientation.normalize();
      commitFriction(model, trial_);
      std::swap(state, trial_);
      return report;
    }
    const bool diverging = k >= 3 && size.largest > 2.0 * previous;
    if (k == options_.max_iterations || diverging)
      return report;
    if (k >= 2 && size.largest > SLOW_CONVERGENCE_RATIO * previous)
      tangent = AssemblyMode::COMPLETE;
    if (wanted == AssemblyMode::RESIDUAL)
      size = assemble(model, ends, weights, tangent);
    // What the next residual will be if it falls as before: the tangent is made only where it will be used.
    const double fall = k == 0 ? (state.last_iterations <= 1 ? 0.0 : 1.0) : size.largest / previous;
    wanted =
        fall * size.largest <= size.tolerance && movable_obstacles_.empty() ? AssemblyMode::RESIDUAL : tangent;
    previous = size.largest;
    ++report.iterations;
    if (!std::isfinite(size.largest) || !solve())
    {
      report.status = SolveStatus::SINGULAR;
      return report;
    }
    correct(model, weights, scale, state);
  }
}

SolveReport GeneralizedAlpha::initialiseAcceleration(CableModel& model, const BoundaryConditions& ends,
                                                     CableState& state)
{
  SolveReport report;
  if (ends.payout)
    model.setPayout(ends.payout->at(state.time));
  trial_ = state;
  for (NodeCoords& a : trial_.a)
    a.setZero();
  for (AttitudeState* rotation : {&trial_.vessel, &trial_.vehicle})
    rotation->acceleration.setZero();
  for (ObstacleMotion& obstacle : trial_.obstacles)
    obstacle.acceleration.setZero();
  placePrescribedEnds(model, ends, trial_);
  report.residual = assemble(model, ends, TangentWeights{1.0, 0.0, 0.0}, AssemblyMode::SYMMETRIC).largest;
  report.iterations = 1;
  if (!std::isfinite(report.residual) || !solve())
  {
    report.status = SolveStatus::SINGULAR;
    return report;
  }
  correct(model, TangentWeights{1.0, 0.0, 0.0}, 0.0, state);
  trial_.algorithmic_acceleration = trial_.a;
  for (AttitudeState* rotation : {&trial_.vessel, &trial_.vehicle})
    rotation->algorithmic_acceleration = rotation->acceleration;
  for (ObstacleMotion& obstacle : trial_.obstacles)
    obstacle.algorithmic_acceleration = obstacle.acceleration;
  std::swap(state, trial_);
  return report;
}

}  // namespace tether_monitor::core
