#include "tether_monitor/monitor/vehicle_start.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "tether_monitor/core/cable_forces.h"
#include "tether_monitor/core/contact.h"
#include "tether_monitor/core/end_impedance.h"
#include "tether_monitor/core/settling.h"

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
  core::CableModel held = model;
  held.setBodies({});
  return held;
}

// What keeps the vehicle in balance where a tether ends, from other than the sea and the tether.
core::Vector3 holdingForce(const core::CableModel& model, const core::CableModel& held,
                           const core::NodeField& shape, const core::Vector3& velocity)
{
  core::CableState state(0.0, shape, velocity);
  core::beginContact(held, state);
  core::Sea calm = model.sea();
  calm.calm();
  return -core::steadyForce(*model.bodies().vehicle, calm, shape.back().head<3>(), velocity) -
         core::endForces(held, state).vehicle;
}

class Search
{
 public:
  Search(core::Statics& statics, const core::CableModel& model, const core::SteadyEnds& ends, double place_stddev,
         const core::Vector3& thrust, const core::Vector3& force_stddev)
    : statics_(statics),
      model_(model),
      body_(*model.bodies().vehicle),
      ends_(ends),
      thrust_(thrust),
      certain_(1.0 / (place_stddev * place_stddev)),
      known_(force_stddev.cwiseAbs2().cwiseInverse().asDiagonal()),
      solver_(model.nodes())
  {
  }

  bool hasFound() const { return std::isfinite(cost_); }
  const VehicleStart& best() const { return best_; }
  const core::SolveReport& report() const { return report_; }

  // Over the force, by Gauss and Newton with halved steps.
  void hang()
  {
    core::Vector3 force = core::Vector3::Zero();
    if (!tryForce(force))
      return;
    for (int pass = 0; pass < PASSES && hasFound(); ++pass)
    {
      const double before = cost_;
      const core::Matrix3 Y = compliance_;
      const core::Matrix3 H = certain_ * Y.transpose() * Y + known_;
      core::Vector3 step = -H.ldlt().solve(certain_ * Y.transpose() * off_ + known_ * best_.force);
      bool better = false;
      for (int halving = 0; halving < 4 && !better; ++halving, step *= 0.5)
        better = tryForce(best_.force + step);
      if (!better || before - cost_ < GOOD * before)
        return;
    }
  }

  // At the measured place, as far as the tether reaches.
  void hold()
  {
    core::SteadyEnds at = ends_;
    const core::Vector3 away = ends_.vehicle - ends_.vessel;
    at.vehicle = ends_.vessel + std::min(1.0, LONGEST_REACH * model_.length() / away.norm()) * away;
    core::NodeField shape;
    const core::CableModel held = withoutVehicle(model_);
    const core::SolveReport report = core::findSteadyState(statics_, held, at, shape);
    if (!report.converged())
      return;
    const core::Vector3 force = holdingForce(model_, held, shape, at.velocity) - thrust_;
    take(force, shape, report);
  }

 private:
  bool tryForce(const core::Vector3& force)
  {
    core::RigidBody body = body_;
    body.force += force + thrust_;
    core::CableModel loaded = model_;
    loaded.setBodies({std::nullopt, body});
    core::NodeField shape;
    const core::SolveReport report = statics_.solve(loaded, ends_, shape);
    return report.converged() && take(force, shape, report);
  }

  // Keeps a solution if it is the likeliest so far.
  bool take(const core::Vector3& force, const core::NodeField& shape, const core::SolveReport& report)
  {
    const core::Vector3 off = shape.back().head<3>() - ends_.vehicle;
    const double cost = certain_ * off.squaredNorm() + force.dot(known_ * force);
    if (!(cost < cost_))
      return false;
    core::CableState state(0.0, shape, ends_.velocity);
    core::beginContact(model_, state);
    core::EndImpedance impedance;
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
    best_.place = (certain_ * core::Matrix3::Identity() + K.transpose() * known_ * K).inverse();
    return true;
  }

  core::Statics& statics_;
  const core::CableModel& model_;
  core::RigidBody body_;
  core::SteadyEnds ends_;
  core::Vector3 thrust_;
  double certain_;
  core::Matrix3 known_;
  core::EndImpedanceSolver solver_;
  VehicleStart best_;
  double cost_ = std::numeric_limits<double>::infinity();
  core::Vector3 off_ = core::Vector3::Zero();
  core::Matrix3 compliance_ = core::Matrix3::Zero();
  core::SolveReport report_;
};
}  // namespace

core::SolveReport findVehicleStart(core::Statics& statics, const core::CableModel& model,
                                   const core::SteadyEnds& ends, double place_stddev, const core::Vector3& thrust,
                                   const core::Vector3& force_stddev, VehicleStart& start)
{
  Search search(statics, model, ends, place_stddev, thrust, force_stddev);
  search.hang();
  search.hold();
  core::SolveReport report = search.report();
  if (!search.hasFound())
    report.status = core::SolveStatus::NOT_CONVERGED;
  else
    start = search.best();
  return report;
}

core::Matrix3 forceOfWay(core::Statics& statics, const core::CableModel& model, const core::SteadyEnds& ends,
                         const core::Vector3& velocity_stddev, const VehicleStart& start)
{
  core::Matrix3 covariance = core::Matrix3::Zero();
  const core::CableModel held = withoutVehicle(model);
  const core::Vector3 usual = holdingForce(model, held, start.shape, ends.velocity);
  core::SteadyEnds at = ends;
  at.vehicle = start.shape.back().head<3>();
  for (int i = 0; i < 3; ++i)
  {
    at.velocity = ends.velocity;
    at.velocity[i] += velocity_stddev[i];
    core::NodeField shape = start.shape;
    if (!(velocity_stddev[i] > 0.0) || (!statics.solveFrom(held, at, shape).converged() &&
                                        !core::findSteadyState(statics, held, at, shape).converged()))
      continue;
    const core::Vector3 force = holdingForce(model, held, shape, at.velocity) - usual;
    covariance += force * force.transpose();
  }
  return covariance;
}

}  // namespace tether_monitor::monitor
