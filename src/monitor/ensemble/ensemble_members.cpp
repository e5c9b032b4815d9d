#include "tether_monitor/monitor/ensemble/ensemble_members.h"

#include <cmath>

#include "tether_monitor/monitor/measurements/body_state.h"
#include "tether_monitor/monitor/model/model_factory.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double ATTITUDE_RATE = 1.0;            // [rad/s] with which a vehicle turns to its measured attitude
constexpr double RAMP = 2.0, LENGTH_RAMP = 5.0;  // [s] of each of two stages
constexpr double VARIATION_INTERVAL = 0.2;       // [s] between changes of what acts
constexpr double LARGEST_FAILING_SHARE = 0.25;

}  // namespace

core::Vector3 torqueTowards(const core::RigidBody& body, const Eigen::Quaterniond& attitude,
                            const core::AttitudeState& now)
{
  Eigen::Quaterniond off = now.orientation.conjugate() * attitude;
  if (off.w() < 0.0)
    off.coeffs() *= -1.0;
  return (body.inertia + body.added_inertia)
      .cwiseProduct(ATTITUDE_RATE * ATTITUDE_RATE * 2.0 * off.vec() - 2.0 * ATTITUDE_RATE * now.velocity);
}

MemberMotion::MemberMotion(int members)
  : position(MemberVectors::Zero(3, members)),
    velocity(MemberVectors::Zero(3, members)),
    direction(MemberVectors::Zero(3, members)),
    vessel_tension(Eigen::RowVectorXd::Zero(members)),
    vehicle_tension(Eigen::RowVectorXd::Zero(members))
{
}

EnsembleMembers::EnsembleMembers(const Config& config)
  : count_(config.uncertainty.members),
    options_(config.solver),
    body_(config.vehicle_body),
    failed_(config.uncertainty.members, 0),
    motion_(config.uncertainty.members)
{
  body_.attachment = config.vehicle.attachment;
}

void EnsembleMembers::prepare(const core::CableModel& model)
{
  members_.clear();
  members_.reserve(count_);
  for (int i = 0; i < count_; ++i)
    members_.emplace_back(model, options_);
}

void EnsembleMembers::begin(const EnsembleStart& start, const CableSimulation& simulation)
{
  options_.step = simulation.stepper.options().step;
  if (members_.empty() || members_.front().cable.nodes() != simulation.model.nodes())
    prepare(simulation.model);
  shear_depth_ = start.shear_depth;
  varied_at_ = simulation.state.time;
  for (int i = 0; i < count_; ++i)
  {
    Member& member = members_[i];
    const MemberStart& from = start.members[i];
    member.state = simulation.state;
    member.state.q = from.shape;
    member.towards = member.acting = from.parameters;
    member.state.deployment.variation = variationOf(from.parameters, shear_depth_);
    member.cable.update(simulation.model, member.state.deployment);
    member.cable.initializeContact(member.state);
    member.stepper.prepareObstacles(simulation.model);
    observe(i, simulation.model);
  }
}

void EnsembleMembers::takeObstacles(const CableSimulation& simulation)
{
  for (Member& member : members_)
  {
    member.cable.update(simulation.model, member.state.deployment);
    member.cable.initializeContact(member.state);
    member.stepper.prepareObstacles(simulation.model);
  }
}

void EnsembleMembers::moveObstacle(std::size_t k, const core::ObstacleMotion& now)
{
  for (Member& member : members_)
    if (k < member.state.obstacles.size())
    {
      member.state.obstacles[k].position = now.position;
      member.state.obstacles[k].velocity = now.velocity;
    }
}

// Two stages of first order: no jump, and no jump of a rate.
void EnsembleMembers::vary(double dt, const ParameterMatrix& parameters)
{
  const double usual_share = 1.0 - std::exp(-dt / RAMP), length_share = 1.0 - std::exp(-dt / LENGTH_RAMP);
  for (int i = 0; i < count_; ++i)
  {
    Member& member = members_[i];
    for (int k = 0; k < PARAMETERS; ++k)
    {
      const double share = k == LENGTH ? length_share : usual_share;
      member.towards[k] += share * (parameters(k, i) - member.towards[k]);
      member.acting[k] += share * (member.towards[k] - member.acting[k]);
    }
    member.state.deployment.variation = variationOf(member.acting, shear_depth_);
  }
}

void EnsembleMembers::observe(int i, const core::CableModel& model)
{
  Member& member = members_[i];
  member.cable.update(model, member.state.deployment);
  const BodyState body =
      BodyState::ofNode(member.state, member.state.q.size() - 1, member.state.vehicle, body_.attachment);
  const core::EndForces forces = core::endForces(member.cable, member.state);
  motion_.position.col(i) = body.position;
  motion_.velocity.col(i) = body.velocity;
  motion_.direction.col(i) = member.state.q.front().tail<3>().normalized();
  motion_.vessel_tension[i] = forces.vessel.norm();
  motion_.vehicle_tension[i] = forces.vehicle.norm();
}

core::SolveReport EnsembleMembers::advance(const core::CableModel& model, const core::BoundaryConditions& paths,
                                           double t, const ParameterMatrix& parameters, const MemberVectors& force,
                                           const std::optional<Eigen::Quaterniond>& attitude)
{
  if (t >= varied_at_ + VARIATION_INTERVAL)
  {
    vary(t - varied_at_, parameters);
    varied_at_ = t;
  }
  core::SolveReport total;
  int failures = 0, sound = -1;
  for (int i = 0; i < count_; ++i)
  {
    Member& member = members_[i];
    core::BoundaryConditions own = paths;
    own.vehicle_force += force.col(i);
    if (attitude)
      own.vehicle_thrust.torque += torqueTowards(body_, *attitude, member.state.vehicle);
    const core::SolveReport report = member.stepper.advance(model, own, t, member.state);
    total.addCost(report);
    failed_[i] = !report.converged() || !member.state.q.back().allFinite();
    failures += failed_[i];
    sound = failed_[i] ? sound : i;
    if (!failed_[i])
      total.residual = report.residual;
    if (failed_[i])
      total.status = report.status;
  }
  if (failures > LARGEST_FAILING_SHARE * count_)
    return total;
  total.status = core::SolveStatus::CONVERGED;
  for (int i = 0; i < count_; ++i)
  {
    if (failed_[i])
      replace(i, sound);
    observe(i, model);
  }
  return total;
}

void EnsembleMembers::replace(int i, int from)
{
  members_[i].state = members_[from].state;
  members_[i].acting = members_[from].acting;
  members_[i].towards = members_[from].towards;
  ++replaced_;
}

bool EnsembleMembers::isValid(const core::CableModel& model) const
{
  if (static_cast<int>(members_.size()) != count_)
    return false;
  for (const Member& member : members_)
    if (!isStateOf(member.state, model) || !member.acting.allFinite() || !member.towards.allFinite() ||
        !member.state.deployment.variation.isValid())
      return false;
  return motion_.position.allFinite() && motion_.position.cols() == count_;
}

}  // namespace tether_monitor::monitor
