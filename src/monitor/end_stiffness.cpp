#include "tether_monitor/monitor/end_stiffness.h"

#include "tether_monitor/core/cable_forces.h"

namespace tether_monitor::monitor
{
namespace
{
TensionSlope slopeBetween(const Row3& slow, const Row3& fast)
{
  TensionSlope slope;
  slope.velocity = (fast - slow) / (EndStiffness::FAST - EndStiffness::SLOW);
  slope.position = slow - EndStiffness::SLOW * slope.velocity;
  return slope;
}
}  // namespace

bool fitEndStiffness(core::EndImpedanceSolver& solver, const core::CableModel& model,
                     const core::CableState& state, double wave_rate, EndStiffness& fit)
{
  core::EndImpedance slow, fast, wave;
  if (!solver.solve(model, state, EndStiffness::SLOW, slow) ||
      !solver.solve(model, state, EndStiffness::FAST, fast) || !solver.solve(model, state, wave_rate, wave))
    return false;
  const core::RigidBody& body = *model.bodies().vehicle;
  const core::Matrix3 R = state.vehicle.orientation.toRotationMatrix();
  const core::EndForces forces = core::endForces(model, state);
  const Row3 at_vessel = -forces.vessel.normalized().transpose();  // a node receives what its body gets, negative
  const Row3 at_vehicle = -forces.vehicle.normalized().transpose();
  constexpr double A = EndStiffness::SLOW, B = EndStiffness::FAST;

  fit.mass =
      R * core::Matrix3((core::Vector3::Constant(body.mass) + body.added_mass).asDiagonal()) * R.transpose();
  fit.damping = (fast.vehicle - slow.vehicle - (B * B - A * A) * fit.mass) / (B - A);
  fit.stiffness = slow.vehicle - A * fit.damping - A * A * fit.mass;
  fit.chord = (state.q.back().head<3>() - state.q.front().head<3>()).normalized();
  fit.vessel = slopeBetween(at_vessel * slow.transfer, at_vessel * fast.transfer);
  fit.vehicle = slopeBetween(at_vehicle * slow.tether, at_vehicle * fast.tether);
  fit.vessel_end = at_vessel * wave.vessel;
  return true;
}

}  // namespace tether_monitor::monitor
