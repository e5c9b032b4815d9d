#include "tether_monitor/monitor/ensemble/ensemble_start.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "tether_monitor/core/analysis/dynamic_stiffness.h"
#include "tether_monitor/core/assembly/end_forces.h"
#include "tether_monitor/core/bodies/rigid_body_dynamics.h"
#include "tether_monitor/monitor/ensemble/random_numbers.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double STATIC_RATE = 0.003;    // rate of growth that stands for a steady state [1/s]
constexpr int PARTS = 4;                 // in which the measurement is assimilated
constexpr int PASSES = 6, HALVINGS = 5;  // of the search for the likeliest place
constexpr double GOOD = 1e-2;            // gain of a pass that is not worth another
constexpr double LARGEST_FAILING_SHARE = 0.25;
constexpr double LEAST_SHEAR_DEPTH = 10.0;  // [m]

class Search
{
 public:
  Search(core::SteadyStateSolver& statics, const core::CableModel& model, const EnsembleStartInputs& in)
    : statics_(statics),
      held_(model.withBodies({}).withEnvironment(model.environment().withoutWaves())),
      body_(*model.bodies().vehicle),
      in_(in),
      information_(in.position_covariance.inverse()),
      force_variance_(in.force.slow_stddev * in.force.slow_stddev + in.force.fast_stddev * in.force.fast_stddev),
      solver_(model.nodes())
  {
    start_.shear_depth = std::max(-in.ends.vehicle.z(), LEAST_SHEAR_DEPTH);
  }

  bool run(const ParameterPrior& prior, int members, const core::NodeField& shape)
  {
    draw(prior, members, shape);
    for (int part = 0; part <= PARTS; ++part)
    {
      if (!placeAll())
        return false;
      if (part < PARTS)
        assimilate();
    }
    for (int i = 0; i < members; ++i)
      start_.members[i].parameters = drawn_.col(i).head<PARAMETERS>();
    return true;
  }
  EnsembleStart& result() { return start_; }

 private:
  void draw(const ParameterPrior& prior, int members, const core::NodeField& shape)
  {
    RandomNumbers random(in_.seed);
    drawn_.resize(PARAMETERS + 3, members);
    random.fillUncorrelated(drawn_);
    drawn_.topRows<PARAMETERS>().array().colwise() *= prior.stddev.array();
    drawn_.bottomRows<3>().array().colwise() *= in_.velocity_stddev.array();
    start_.members.assign(members, MemberStart());
    place_.resize(3, members);
    stiffness_.assign(members, core::Matrix3::Zero());
    for (int i = 0; i < members; ++i)
    {
      start_.members[i].shape = shape;
      place_.col(i) = shape.back().head<3>();
    }
  }

  // Members that have no place take that of one that has.
  bool placeAll()
  {
    const int members = static_cast<int>(start_.members.size());
    std::vector<int> lost;
    int found = -1;
    for (int i = 0; i < members; ++i)
      if (place(i))
        found = i;
      else
        lost.push_back(i);
    if (found < 0 || static_cast<double>(lost.size()) > LARGEST_FAILING_SHARE * members)
      return false;
    for (const int i : lost)
    {
      drawn_.col(i) = drawn_.col(found);
      start_.members[i] = start_.members[found];
      place_.col(i) = place_.col(found);
      stiffness_[i] = stiffness_[found];
    }
    return true;
  }

  // The likeliest place of a member, by Gauss and Newton.
  bool place(int i)
  {
    Held now;
    now.shape = start_.members[i].shape;
    core::Vector3 at = place_.col(i);
    if (!hold(i, at, now))
      return false;
    for (int pass = 0; pass < PASSES; ++pass)
    {
      const core::Matrix3& K = now.stiffness;
      const core::Matrix3 H = information_ + K.transpose() * K / force_variance_;
      core::Vector3 step =
          -H.ldlt().solve(information_ * (at - in_.ends.vehicle) + K.transpose() * now.force / force_variance_);
      bool better = false;
      double gain = 0.0;
      for (int halving = 0; halving < HALVINGS && !better; ++halving, step *= 0.5)
      {
        Held next = now;
        const core::Vector3 there = at + step;
        if (!hold(i, there, next) || !(next.cost < now.cost))
          continue;
        better = true;
        gain = now.cost - next.cost;
        now = std::move(next);
        at = there;
      }
      if (!better || gain < GOOD * (1.0 + now.cost))
        break;
    }
    start_.members[i].shape = now.shape;
    start_.members[i].force = now.force;
    stiffness_[i] = now.stiffness;
    place_.col(i) = at;
    return true;
  }

  // A member whose tether ends at a given place.
  struct Held
  {
    core::NodeField shape;
    core::Vector3 force = core::Vector3::Zero();
    core::Matrix3 stiffness = core::Matrix3::Zero();
    double cost = 0.0;
  };

  bool hold(int i, const core::Vector3& at, Held& held)
  {
    core::SteadyEnds ends = in_.ends;
    ends.vehicle = at;
    ends.velocity += drawn_.col(i).tail<3>();
    ends.deployment.variation = variationOf(drawn_.col(i).head<PARAMETERS>(), start_.shear_depth);
    if (!statics_.solveFrom(held_, ends, held.shape).converged() &&
        !statics_.solve(held_, ends, held.shape).converged())
      return false;
    core::CableState state(0.0, held.shape, ends.velocity, ends.deployment);
    const core::DeployedCable cable(held_, state.deployment);
    cable.initializeContact(state);
    core::EndDynamicStiffness stiffness;
    if (!solver_.solve(cable, state, STATIC_RATE, stiffness))
      return false;
    const core::RigidBodyMotion motion = core::rigidBodyMotion(state, state.q.size() - 1, core::AttitudeState());
    const core::Vector3 needed = core::rigidBodyResidual(body_, held_.environment(), motion, core::Wrench(),
                                                         core::TangentWeights{0.0, 0.0, 0.0})
                                     .force;
    held.force = needed - core::endForces(cable, state).vehicle - in_.thrust;
    held.stiffness = stiffness.vehicle;
    const core::Vector3 off = at - in_.ends.vehicle;
    held.cost = off.dot(information_ * off) + held.force.squaredNorm() / force_variance_;
    return std::isfinite(held.cost);
  }

  void assimilate()
  {
    const int members = static_cast<int>(start_.members.size());
    core::Matrix3 K = core::Matrix3::Zero();
    for (const core::Matrix3& k : stiffness_)
      K += k / members;
    MemberVectors needed(3, members);
    for (int i = 0; i < members; ++i)
      needed.col(i) = start_.members[i].force + K * (in_.ends.vehicle - place_.col(i));
    const core::Matrix3 S =
        force_variance_ * core::Matrix3::Identity() + K * in_.position_covariance * K.transpose();
    EnsembleTransform transform(members);
    transform.set(needed, -needed.rowwise().mean(), PARTS * S);
    transform.apply(drawn_);
  }

  core::SteadyStateSolver& statics_;
  core::CableModel held_;
  core::RigidBody body_;
  const EnsembleStartInputs& in_;
  core::Matrix3 information_;
  double force_variance_;
  core::EndDynamicStiffnessSolver solver_;
  Eigen::MatrixXd drawn_;  // parameters, and three rows of what is wrong of the velocity
  MemberVectors place_;
  std::vector<core::Matrix3> stiffness_;
  EnsembleStart start_;
};
}  // namespace

bool findEnsembleStart(const ParameterPrior& prior, int members, core::SteadyStateSolver& statics,
                       const core::CableModel& model, const EnsembleStartInputs& inputs,
                       const core::NodeField& shape, EnsembleStart& start)
{
  Search search(statics, model, inputs);
  if (!search.run(prior, members, shape))
    return false;
  start = std::move(search.result());
  return true;
}

}  // namespace tether_monitor::monitor
