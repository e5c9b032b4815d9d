#include "tether_monitor/core/integrator.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tether_monitor/core/bounds.h"
#include "tether_monitor/core/rotation.h"

namespace tether_monitor::core
{
namespace
{
constexpr double SLOW = 0.02;  // a residual that falls by less in an iteration wants the complete tangent
constexpr int EASY = 2;        // Newton iterations of a step after which the motion is taken to be smooth
}  // namespace

GeneralizedAlpha::GeneralizedAlpha(const CableModel& model, double spectral_radius, const NewtonOptions& options)
  : options_(options), residual_(model.nodes(), NodeCoords::Zero()), tangent_(model.nodes())
{
  BoundsCheck check;
  check.within("spectral_radius", spectral_radius, 0.0, 1.0, "[-]");
  throwIfAny("GeneralizedAlpha", check.problems());
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
  border_ = borderFor(model, pushed_);
  beginContact(model, trial_);
}

void GeneralizedAlpha::predict(const CableModel& model, const EndPaths& ends, double h, const CableState& state)
{
  // After an easy step the acceleration goes on as it did: aux lags behind it by a known part of a step, (M12).
  // Else it stays.
  const double lag = alpha_f_ - alpha_m_;
  const double more = state.effort <= EASY && lag > 0.05 ? 1.0 / lag : 0.0;
  trial_.time = state.time + h;
  trial_.step = h;
  const auto next = [&](const auto& a, const auto& b) { return (a + more * (a - b)).eval(); };
  const auto aux = [&](const auto& a, const auto& from_a, const auto& b)
  { return (((1.0 - alpha_f_) * a + alpha_f_ * from_a - alpha_m_ * b) / (1.0 - alpha_m_)).eval(); };
  for (std::size_t i = 0; i < state.q.size(); ++i)
  {
    trial_.a[i] = next(state.a[i], state.aux[i]);
    trial_.aux[i] = aux(trial_.a[i], state.a[i], state.aux[i]);
    trial_.v[i] = state.v[i] + h * ((1.0 - gamma_) * state.aux[i] + gamma_ * trial_.aux[i]);
    trial_.q[i] = state.q[i] + h * state.v[i] + h * h * ((0.5 - beta_) * state.aux[i] + beta_ * trial_.aux[i]);
  }
  const auto rotate = [&](const Rotation& from, Rotation& to, Turning& turning)
  {
    to.acceleration = next(from.acceleration, from.aux);
    to.aux = aux(to.acceleration, from.acceleration, from.aux);
    to.velocity = from.velocity + h * ((1.0 - gamma_) * from.aux + gamma_ * to.aux);
    turning.turn = h * from.velocity + h * h * ((0.5 - beta_) * from.aux + beta_ * to.aux);
    to.orientation = from.orientation * rotationBy(turning.turn);
  };
  if (model.bodies().vessel)
    rotate(state.vessel, trial_.vessel, vessel_);
  if (model.bodies().vehicle)
    rotate(state.vehicle, trial_.vehicle, vehicle_);
  trial_.obstacles = state.obstacles;
  for (ObstacleMotion& obstacle : trial_.obstacles)
    obstacle.position += h * obstacle.velocity;
  for (const int k : pushed_)
  {
    const ObstacleMotion& from = state.obstacles[k];
    ObstacleMotion& to = trial_.obstacles[k];
    to.acceleration = next(from.acceleration, from.aux);
    to.aux = aux(to.acceleration, from.acceleration, from.aux);
    to.velocity = from.velocity + h * ((1.0 - gamma_) * from.aux + gamma_ * to.aux);
    to.position = from.position + h * from.velocity + h * h * ((0.5 - beta_) * from.aux + beta_ * to.aux);
  }
  trial_.contact = state.contact;
  trial_.contact.step = h;
  placeHeldEnds(model, ends, trial_);
}

ResidualSize GeneralizedAlpha::assemble(const CableModel& model, const EndPaths& ends,
                                        const TangentWeights& weights, Wanted wanted)
{
  ObstacleBorder* border = pushed_.empty() ? nullptr : &border_;
  if (border)
    border->setZero();
  kernel_ = &model.kernel();
  if (wanted == Wanted::RESIDUAL)
    model.assemble(trial_, residual_);
  else
    model.assemble(trial_, weights, residual_, tangent_,
                   wanted == Wanted::COMPLETE ? TangentKind::COMPLETE : TangentKind::SYMMETRIC, border);

  double reaction = 0.0, unbalanced = 0.0;
  const auto couple = [&](const RigidBody& body, std::size_t node, const Rotation& rotation, const Wrench& thrust,
                          Turning& turning)
  {
    reaction = std::max({reaction, residual_[node].head<3>().norm(), 1e-3 * 9.81 * body.mass});

    const double open =
        turning.coupling.assemble(body, model.sea(), trial_.time, attachmentMotion(trial_, node), rotation, thrust,
                                  weights, residual_[node], tangent_.diagonal(static_cast<int>(node)));
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
  for (const int k : pushed_)
  {
    const double mass = model.environment().obstacles[k].mass;
    border_.residual(k) += mass * trial_.obstacles[k].acceleration;
    border_.diagonal(k) += weights.mass * mass * Matrix3::Identity();
    unbalanced = std::max(unbalanced, border_.residual(k).norm());
  }
  const HeldEnds held = heldEnds(model);
  ResidualSize size = holdEnds(model, trial_.q, options_, held, residual_, reaction);
  if (unbalanced > size.largest || std::isnan(unbalanced))
    size.largest = unbalanced;
  if (model.bodies().vessel)
    vessel_.coupling.condense(residual_.front());
  if (model.bodies().vehicle)
    vehicle_.coupling.condense(residual_.back());
  holdEnds(held, tangent_);
  for (const int k : pushed_)
  {
    if (held.vessel)
      border_.column(k, 0).topRows<3>().setZero();
    if (held.vehicle)
      border_.column(k, model.elements()).topRows<3>().setZero();
  }
  return size;
}

bool GeneralizedAlpha::solve()
{
  if (pushed_.empty())
    return tangent_.solve(*kernel_, residual_);
  return border_.solve(tangent_, residual_);
}

void GeneralizedAlpha::correct(const CableModel& model, const TangentWeights& weights, double scale,
                               const CableState& state)
{
  for (std::size_t i = 0; i < residual_.size(); ++i)
  {
    trial_.a[i] -= residual_[i];
    trial_.aux[i] -= scale * residual_[i];
    trial_.v[i] -= weights.damping * residual_[i];
    trial_.q[i] -= weights.stiffness * residual_[i];
  }
  const auto rotate = [&](const Rotation& from, Rotation& to, Turning& turning, const NodeCoords& node)
  {
    const Vector3 delta = turning.coupling.solve(node);
    to.acceleration -= delta;
    to.aux -= scale * delta;
    to.velocity -= weights.damping * delta;
    turning.turn -= weights.stiffness * delta;
    to.orientation = from.orientation * rotationBy(turning.turn);
  };
  if (model.bodies().vessel)
    rotate(state.vessel, trial_.vessel, vessel_, residual_.front());
  if (model.bodies().vehicle)
    rotate(state.vehicle, trial_.vehicle, vehicle_, residual_.back());
  for (const int k : pushed_)
  {
    ObstacleMotion& to = trial_.obstacles[k];
    const Vector3 delta = border_.solution(k);
    to.acceleration -= delta;
    to.aux -= scale * delta;
    to.velocity -= weights.damping * delta;
    to.position -= weights.stiffness * delta;
  }
}

SolveReport GeneralizedAlpha::step(CableModel& model, const EndPaths& ends, double h, CableState& state)
{
  const double scale = (1.0 - alpha_f_) / (1.0 - alpha_m_);
  const TangentWeights weights{1.0, gamma_ * h * scale, beta_ * h * h * scale};
  if (ends.payout)
    model.setPayout(ends.payout->at(state.time + h));
  if (state.obstacles.size() != model.environment().obstacles.size())
    beginContact(model, state);
  predict(model, ends, h, state);

  SolveReport report;
  report.status = SolveStatus::NOT_CONVERGED;
  double previous = 0.0;
  Wanted wanted = state.effort == 0 && pushed_.empty() ? Wanted::RESIDUAL : Wanted::SYMMETRIC,
         tangent = Wanted::SYMMETRIC;
  for (int k = 0;; ++k)
  {
    ResidualSize size = assemble(model, ends, weights, wanted);
    report.residual = size.largest;
    if (size.largest <= size.tolerance)
    {
      report.status = SolveStatus::CONVERGED;
      report.steps = 1;
      trial_.effort = report.iterations;
      trial_.vessel.orientation.normalize();
      trial_.vehicle.orientation.normalize();
      acceptContact(model, trial_);
      std::swap(state, trial_);
      return report;
    }
    const bool diverging = k >= 3 && size.largest > 2.0 * previous;
    if (k == options_.max_iterations || diverging)
      return report;
    if (k >= 2 && size.largest > SLOW * previous)
      tangent = Wanted::COMPLETE;
    if (wanted == Wanted::RESIDUAL)
      size = assemble(model, ends, weights, tangent);
    // What the next residual will be if it falls as before: the tangent is made only where it will be used.
    const double fall = k == 0 ? (state.effort <= 1 ? 0.0 : 1.0) : size.largest / previous;
    wanted = fall * size.largest <= size.tolerance && pushed_.empty() ? Wanted::RESIDUAL : tangent;
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

SolveReport GeneralizedAlpha::initialiseAcceleration(CableModel& model, const EndPaths& ends, CableState& state)
{
  SolveReport report;
  if (ends.payout)
    model.setPayout(ends.payout->at(state.time));
  trial_ = state;
  for (NodeCoords& a : trial_.a)
    a.setZero();
  for (Rotation* rotation : {&trial_.vessel, &trial_.vehicle})
    rotation->acceleration.setZero();
  for (ObstacleMotion& obstacle : trial_.obstacles)
    obstacle.acceleration.setZero();
  placeHeldEnds(model, ends, trial_);
  report.residual = assemble(model, ends, TangentWeights{1.0, 0.0, 0.0}, Wanted::SYMMETRIC).largest;
  report.iterations = 1;
  if (!std::isfinite(report.residual) || !solve())
  {
    report.status = SolveStatus::SINGULAR;
    return report;
  }
  correct(model, TangentWeights{1.0, 0.0, 0.0}, 0.0, state);
  trial_.aux = trial_.a;
  for (Rotation* rotation : {&trial_.vessel, &trial_.vehicle})
    rotation->aux = rotation->acceleration;
  for (ObstacleMotion& obstacle : trial_.obstacles)
    obstacle.aux = obstacle.acceleration;
  std::swap(state, trial_);
  return report;
}

}  // namespace tether_monitor::core
