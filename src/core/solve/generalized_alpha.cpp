#include "tether_monitor/core/solve/generalized_alpha.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"
#include "tether_monitor/core/base/so3.h"

namespace tether_monitor::core
{
namespace
{
constexpr double SLOW_CONVERGENCE_RATIO = 0.02;  // a residual that falls by less wants the complete tangent
constexpr int EXTRAPOLATION_MAX_ITERATIONS = 2;  // of a step after which the motion is taken to be smooth
constexpr double LEAST_LAG = 0.05;               // of the algorithmic acceleration, to extrapolate with
}  // namespace

GeneralizedAlpha::GeneralizedAlpha(const CableModel& model, double spectral_radius, const NewtonOptions& options)
  : options_(options), cable_(model), residual_(model.nodes(), NodeCoords::Zero()), tangent_(model.nodes())
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
  trial_.deployment.drag_factor.reserve(model.elements());
  prepareObstacles(model);
}

void GeneralizedAlpha::prepareObstacles(const CableModel& model)
{
  bordered_ = borderedSystemFor(model.environment().obstacles(), model.nodes(), movable_obstacles_);
  cable_.update(model, trial_.deployment);
  cable_.initializeContact(trial_);
}

template <typename Value>
void GeneralizedAlpha::predictAcceleration(const Value& a, const Value& from_algorithmic, double growth,
                                           Value& to_a, Value& to_algorithmic) const
{
  to_a = a + growth * (a - from_algorithmic);
  to_algorithmic = ((1.0 - alpha_f_) * to_a + alpha_f_ * a - alpha_m_ * from_algorithmic) / (1.0 - alpha_m_);
}

void GeneralizedAlpha::predictAttitude(const AttitudeState& from, double growth, double h, AttitudeState& to,
                                       Vector3& rotation)
{
  predictAcceleration(from.acceleration, from.algorithmic_acceleration, growth, to.acceleration,
                      to.algorithmic_acceleration);
  to.velocity =
      from.velocity + h * ((1.0 - gamma_) * from.algorithmic_acceleration + gamma_ * to.algorithmic_acceleration);
  rotation = h * from.velocity +
             h * h * ((0.5 - beta_) * from.algorithmic_acceleration + beta_ * to.algorithmic_acceleration);
  to.orientation = from.orientation * expSO3(rotation);
}

void GeneralizedAlpha::predictObstacles(const CableState& state, double growth, double h)
{
  trial_.obstacles = state.obstacles;
  for (ObstacleMotion& obstacle : trial_.obstacles)
    obstacle.position += h * obstacle.velocity;
  for (const int k : movable_obstacles_)
  {
    const ObstacleMotion& from = state.obstacles[k];
    ObstacleMotion& to = trial_.obstacles[k];
    predictAcceleration(from.acceleration, from.algorithmic_acceleration, growth, to.acceleration,
                        to.algorithmic_acceleration);
    to.velocity = from.velocity +
                  h * ((1.0 - gamma_) * from.algorithmic_acceleration + gamma_ * to.algorithmic_acceleration);
    to.position = from.position + h * from.velocity +
                  h * h * ((0.5 - beta_) * from.algorithmic_acceleration + beta_ * to.algorithmic_acceleration);
  }
}

void GeneralizedAlpha::predict(const CableModel& model, const BoundaryConditions& ends, double h,
                               const CableState& state)
{
  // After an easy step the acceleration goes on as it did: the algorithmic one lags behind it by a known part of a
  // step, (M12). Else it stays.
  const double lag = alpha_f_ - alpha_m_;
  const bool is_smooth = state.last_iterations <= EXTRAPOLATION_MAX_ITERATIONS && lag > LEAST_LAG;
  const double growth = is_smooth ? 1.0 / lag : 0.0;
  trial_.time = state.time + h;
  trial_.step = h;
  trial_.deployment = state.deployment;
  if (ends.payout)
    trial_.deployment.payout = ends.payout->at(trial_.time);
  cable_.update(model, trial_.deployment);
  for (std::size_t i = 0; i < state.q.size(); ++i)
  {
    const NodeCoords& aux = state.algorithmic_acceleration[i];
    NodeCoords& to_aux = trial_.algorithmic_acceleration[i];
    predictAcceleration(state.a[i], aux, growth, trial_.a[i], to_aux);
    trial_.v[i] = state.v[i] + h * ((1.0 - gamma_) * aux + gamma_ * to_aux);
    trial_.q[i] = state.q[i] + h * state.v[i] + h * h * ((0.5 - beta_) * aux + beta_ * to_aux);
  }
  if (model.bodies().vessel)
    predictAttitude(state.vessel, growth, h, trial_.vessel, vessel_rotation_);
  if (model.bodies().vehicle)
    predictAttitude(state.vehicle, growth, h, trial_.vehicle, vehicle_rotation_);
  predictObstacles(state, growth, h);
  trial_.contact = state.contact;
  trial_.contact.step = h;
  placePrescribedEnds(model.bodies(), ends, trial_);
}

ResidualSize GeneralizedAlpha::assemble(const BoundaryConditions& ends, const TangentWeights& weights,
                                        AssemblyMode mode)
{
  BorderedSystem* bordered = movable_obstacles_.empty() ? nullptr : &bordered_;
  if (bordered)
    bordered->setZero();
  if (mode == AssemblyMode::RESIDUAL)
    cable_.assemble(trial_, residual_);
  else
    cable_.assemble(trial_, weights, residual_, tangent_,
                    mode == AssemblyMode::COMPLETE ? TangentKind::COMPLETE : TangentKind::SYMMETRIC, bordered);

  CondensedEndBodies::Sizes sizes = bodies_.assemble(cable_, trial_, ends, weights, residual_, tangent_);
  for (const int k : movable_obstacles_)
  {
    const double mass = cable_.environment().obstacles()[k].mass;
    bordered_.residual(k) += mass * trial_.obstacles[k].acceleration;
    bordered_.diagonal(k) += weights.mass * mass * Matrix3::Identity();
    sizes.unbalanced = std::max(sizes.unbalanced, bordered_.residual(k).norm());
  }
  const PrescribedEnds held = prescribedEnds(cable_.bodies());
  ResidualSize size = imposePrescribedEnds(cable_, trial_.q, options_, held, residual_, sizes.reaction);
  if (sizes.unbalanced > size.largest || std::isnan(sizes.unbalanced))
    size.largest = sizes.unbalanced;
  bodies_.condense(cable_.bodies(), residual_);
  imposePrescribedEnds(held, tangent_);
  for (const int k : movable_obstacles_)
  {
    if (held.vessel)
      bordered_.column(k, 0).topRows<3>().setZero();
    if (held.vehicle)
      bordered_.column(k, cable_.elements()).topRows<3>().setZero();
  }
  return size;
}

bool GeneralizedAlpha::solve()
{
  if (movable_obstacles_.empty())
    return tangent_.solve(cable_.model().kernel().solve, residual_);
  return bordered_.solve(tangent_, residual_);
}

void GeneralizedAlpha::correct(const TangentWeights& weights, double scale, const CableState& state)
{
  for (std::size_t i = 0; i < residual_.size(); ++i)
  {
    trial_.a[i] -= residual_[i];
    trial_.algorithmic_acceleration[i] -= scale * residual_[i];
    trial_.v[i] -= weights.damping * residual_[i];
    trial_.q[i] -= weights.stiffness * residual_[i];
  }
  const auto rotate = [&](const AttitudeState& from, const Vector3& delta, AttitudeState& to, Vector3& rotation)
  {
    to.acceleration -= delta;
    to.algorithmic_acceleration -= scale * delta;
    to.velocity -= weights.damping * delta;
    rotation -= weights.stiffness * delta;
    to.orientation = from.orientation * expSO3(rotation);
  };
  if (cable_.bodies().vessel)
    rotate(state.vessel, bodies_.solveVessel(residual_), trial_.vessel, vessel_rotation_);
  if (cable_.bodies().vehicle)
    rotate(state.vehicle, bodies_.solveVehicle(residual_), trial_.vehicle, vehicle_rotation_);
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

void GeneralizedAlpha::accept(int iterations, CableState& state)
{
  trial_.last_iterations = iterations;
  trial_.vessel.orientation.normalize();
  trial_.vehicle.orientation.normalize();
  cable_.commitFriction(trial_);
  std::swap(state, trial_);
}

SolveReport GeneralizedAlpha::step(const CableModel& model, const BoundaryConditions& ends, double h,
                                   CableState& state)
{
  const double scale = (1.0 - alpha_f_) / (1.0 - alpha_m_);
  const TangentWeights weights{1.0, gamma_ * h * scale, beta_ * h * h * scale};
  if (state.obstacles.size() != model.environment().obstacles().size())
  {
    cable_.update(model, state.deployment);
    cable_.initializeContact(state);
  }
  predict(model, ends, h, state);

  SolveReport report;
  report.status = SolveStatus::NOT_CONVERGED;
  double previous = 0.0;
  const bool has_movable = !movable_obstacles_.empty();
  AssemblyMode mode =
      state.last_iterations == 0 && !has_movable ? AssemblyMode::RESIDUAL : AssemblyMode::SYMMETRIC;
  AssemblyMode tangent = AssemblyMode::SYMMETRIC;
  for (int k = 0;; ++k)
  {
    ResidualSize size = assemble(ends, weights, mode);
    report.residual = size.largest;
    if (size.largest <= size.tolerance)
    {
      report.status = SolveStatus::CONVERGED;
      report.steps = 1;
      accept(report.iterations, state);
      return report;
    }
    const bool diverging = k >= 3 && size.largest > 2.0 * previous;
    if (k == options_.max_iterations || diverging)
      return report;
    if (k >= 2 && size.largest > SLOW_CONVERGENCE_RATIO * previous)
      tangent = AssemblyMode::COMPLETE;
    if (mode == AssemblyMode::RESIDUAL)
      size = assemble(ends, weights, tangent);
    // What the next residual will be if it falls as before: the tangent is made only where it will be used.
    const double fall = k == 0 ? (state.last_iterations <= 1 ? 0.0 : 1.0) : size.largest / previous;
    mode = fall * size.largest <= size.tolerance && !has_movable ? AssemblyMode::RESIDUAL : tangent;
    previous = size.largest;
    ++report.iterations;
    if (!std::isfinite(size.largest) || !solve())
    {
      report.status = SolveStatus::SINGULAR;
      return report;
    }
    correct(weights, scale, state);
  }
}

SolveReport GeneralizedAlpha::initializeAcceleration(const CableModel& model, const BoundaryConditions& ends,
                                                     CableState& state)
{
  SolveReport report;
  trial_ = state;
  if (ends.payout)
    trial_.deployment.payout = ends.payout->at(state.time);
  cable_.update(model, trial_.deployment);
  for (NodeCoords& a : trial_.a)
    a.setZero();
  vessel_rotation_.setZero();
  vehicle_rotation_.setZero();
  for (AttitudeState* attitude : {&trial_.vessel, &trial_.vehicle})
    attitude->acceleration.setZero();
  for (ObstacleMotion& obstacle : trial_.obstacles)
    obstacle.acceleration.setZero();
  placePrescribedEnds(model.bodies(), ends, trial_);
  const TangentWeights mass_only{1.0, 0.0, 0.0};
  report.residual = assemble(ends, mass_only, AssemblyMode::SYMMETRIC).largest;
  report.iterations = 1;
  if (!std::isfinite(report.residual) || !solve())
  {
    report.status = SolveStatus::SINGULAR;
    return report;
  }
  correct(mass_only, 0.0, state);
  trial_.algorithmic_acceleration = trial_.a;
  for (AttitudeState* attitude : {&trial_.vessel, &trial_.vehicle})
    attitude->algorithmic_acceleration = attitude->acceleration;
  for (ObstacleMotion& obstacle : trial_.obstacles)
    obstacle.algorithmic_acceleration = obstacle.acceleration;
  std::swap(state, trial_);
  return report;
}

}  // namespace tether_monitor::core
