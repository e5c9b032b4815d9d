#include "tether_monitor/monitor/ensemble/vehicle_initializer.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "tether_monitor/core/analysis/dynamic_stiffness.h"
#include "tether_monitor/core/assembly/end_forces.h"
#include "tether_monitor/core/bodies/rigid_body_dynamics.h"
#include "tether_monitor/core/solve/dynamic_relaxation.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double STATIC_RATE = 0.003;     // rate of growth that stands for a steady state [1/s]
constexpr double LONGEST_REACH = 0.9995;  // chord over length at which a vehicle can be held
constexpr int PASSES = 8;
constexpr double GOOD = 1e-3;  // relative gain of a pass that is not worth another

core::CableModel withoutVehicle(const core::CableModel& model)
{
  return model.withBodies({});
}

// What keeps the vehicle in balance where a tether ends, from other than the sea and the tether.
core::Vector3 holdingForce(const core::CableModel& model, const core::CableModel& held,
                           const core::NodeField& shape, const core::SteadyEnds& ends)
{
  core::CableState state(0.0, shape, ends.velocity, ends.deployment);
  core::initializeContact(held, state);
  return -core::steadyForce(*model.bodies().vehicle, model.environment().withoutWaves(), shape.back().head<3>(),
                            ends.velocity) -
         core::endForces(held, state).vehicle;
}

class MapSearch
{
 public:
  MapSearch(core::SteadyStateSolver& statics, const core::CableModel& model, const InitializationInputs& inputs)
    : statics_(statics),
      model_(model),
      body_(*model.bodies().vehicle),
      ends_(inputs.ends),
      thrust_(inputs.thrust),
      position_information_(inputs.position_covariance.inverse()),
      force_information_(inputs.force_stddev.cwiseAbs2().cwiseInverse().asDiagonal()),
      solver_(model.nodes())
  {
  }

  bool hasFound() const { return std::isfinite(cost_); }
  const VehicleInitialization& best() const { return best_; }
  const core::SolveReport& report() const { return report_; }

  // Over the force, by Gauss and Newton with halved steps.
  void searchFreeHanging()
  {
    core::Vector3 force = core::Vector3::Zero();
    if (!tryForce(force))
      return;
    for (int pass = 0; pass < PASSES && hasFound(); ++pass)
    {
      const double before = cost_;
      const core::Matrix3 Y = compliance_;
      const core::Matrix3 H = Y.transpose() * position_information_ * Y + force_information_;
      core::Vector3 step =
          -H.ldlt().solve(Y.transpose() * (position_information_ * off_) + force_information_ * best_.force);
      bool better = false;
      for (int halving = 0; halving < 4 && !better; ++halving, step *= 0.5)
        better = tryForce(best_.force + step);
      if (!better || before - cost_ < GOOD * before)
        return;
    }
  }

  // At the measured place, as far as the tether reaches.
  void searchHeld()
  {
    core::SteadyEnds at = ends_;
    const core::Vector3 away = ends_.vehicle - ends_.vessel;
    at.vehicle =
        ends_.vessel + std::min(1.0, LONGEST_REACH * model_.length(ends_.deployment) / away.norm()) * away;
    core::NodeField shape;
    const core::CableModel held = withoutVehicle(model_);
    const core::SolveReport report = core::findSteadyState(statics_, held, at, shape);
    if (!report.isUsable())
      return;
    const core::Vector3 force = holdingForce(model_, held, shape, at) - thrust_;
    acceptIfBetter(force, shape, report);
  }

 private:
  bool tryForce(const core::Vector3& force)
  {
    core::RigidBody body = body_;
    body.force += force + thrust_;
    core::NodeField shape;
    const core::SolveReport report = statics_.solve(model_.withBodies({std::nullopt, body}), ends_, shape);
    return report.converged() && acceptIfBetter(force, shape, report);
  }

  // Keeps a solution if it is the likeliest so far.
  bool acceptIfBetter(const core::Vector3& force, const core::NodeField& shape, const core::SolveReport& report)
  {
    const core::Vector3 off = shape.back().head<3>() - ends_.vehicle;
    const double cost = off.dot(position_information_ * off) + force.dot(force_information_ * force);
    if (!(cost < cost_))
      return false;
    core::CableState state(0.0, shape, ends_.velocity, ends_.deployment);
    core::initializeContact(model_, state);
    core::EndDynamicStiffness impedance;
    if (!solver_.solve(model_, state, STATIC_RATE, impedance))
      return false;
    cost_ = cost;
    off_ = off;
    report_ = report;
    const core::Matrix3& K = impedance.vehicle;
    compliance_ = K.inverse();
    best_.shape = shape;
    best_.force = force;
    best_.cost = cost;
    return true;
  }

  core::SteadyStateSolver& statics_;
  const core::CableModel& model_;
  core::RigidBody body_;
  core::SteadyEnds ends_;
  core::Vector3 thrust_;
  core::Matrix3 position_information_;
  core::Matrix3 force_information_;
  core::EndDynamicStiffnessSolver solver_;
  VehicleInitialization best_;
  double cost_ = std::numeric_limits<double>::infinity();
  core::Vector3 off_ = core::Vector3::Zero();
  core::Matrix3 compliance_ = core::Matrix3::Zero();
  core::SolveReport report_;
};
}  // namespace

core::SolveReport findVehicleInitialization(core::SteadyStateSolver& statics, const core::CableModel& model,
                                            const InitializationInputs& inputs, VehicleInitialization& start)
{
  MapSearch search(statics, model, inputs);
  search.searchFreeHanging();
  search.searchHeld();
  core::SolveReport report = search.report();
  if (!search.hasFound())
    report.status = core::SolveStatus::NOT_CONVERGED;
  else
    start = search.best();
  return report;
}

}  // namespace tether_monitor::monitor
