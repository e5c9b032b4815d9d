#include "tether_monitor/monitor/ensemble/tether_linearization.h"

#include <Eigen/Eigenvalues>

#include "tether_monitor/core/assembly/end_forces.h"

namespace tether_monitor::monitor
{
namespace
{
TensionJacobian slopeBetween(const RowVector3& slow, const RowVector3& fast)
{
  TensionJacobian slope;
  slope.velocity = (fast - slow) / (TetherLinearization::FIT_RATE_HIGH - TetherLinearization::FIT_RATE_LOW);
  slope.position = slow - TetherLinearization::FIT_RATE_LOW * slope.velocity;
  return slope;
}

// Whether there was a negative part of its quadratic form; it is taken off.
bool takeOffNegativePart(core::Matrix3& matrix)
{
  const Eigen::SelfAdjointEigenSolver<core::Matrix3> eigen(0.5 * (matrix + matrix.transpose()));
  if (eigen.eigenvalues()[0] >= 0.0)
    return false;
  matrix -=
      eigen.eigenvectors() * eigen.eigenvalues().cwiseMin(0.0).asDiagonal() * eigen.eigenvectors().transpose();
  return true;
}
}  // namespace

bool TetherLinearization::fitMotion(const core::Matrix3& slow, const core::Matrix3& fast)
{
  constexpr double A = FIT_RATE_LOW, B = FIT_RATE_HIGH;
  damping = (fast - slow - (B * B - A * A) * mass) / (B - A);
  const bool damps = !takeOffNegativePart(damping);
  stiffness = slow - A * damping - A * A * mass;
  takeOffNegativePart(stiffness);
  return damps;
}

void TetherLinearization::blend(const TetherLinearization& other, double share)
{
  const auto mix = [share](auto& mine, const auto& theirs) { mine += share * (theirs - mine); };
  mix(mass, other.mass);
  mix(damping, other.damping);
  mix(stiffness, other.stiffness);
  mix(vessel.position, other.vessel.position);
  mix(vessel.velocity, other.vessel.velocity);
  mix(vehicle.position, other.vehicle.position);
  mix(vehicle.velocity, other.vehicle.velocity);
  mix(vessel_tension_jacobian, other.vessel_tension_jacobian);
  mix(chord, other.chord);
  chord.normalize();
}

bool linearizeTether(core::EndDynamicStiffnessSolver& solver, const core::DeployedCable& cable,
                     const core::CableState& state, double wave_rate, TetherLinearization& fit)
{
  core::EndDynamicStiffness slow, fast, wave;
  if (!solver.solve(cable, state, TetherLinearization::FIT_RATE_LOW, slow) ||
      !solver.solve(cable, state, TetherLinearization::FIT_RATE_HIGH, fast) ||
      !solver.solve(cable, state, wave_rate, wave))
    return false;
  const core::RigidBody& body = *cable.bodies().vehicle;
  const core::Matrix3 R = state.vehicle.orientation.toRotationMatrix();
  const core::EndForces forces = core::endForces(cable, state);
  const RowVector3 at_vessel =
      -forces.vessel.normalized().transpose();  // a node receives what its body gets, negative
  const RowVector3 at_vehicle = -forces.vehicle.normalized().transpose();
  fit.mass =
      R * core::Matrix3((core::Vector3::Constant(body.mass) + body.added_mass).asDiagonal()) * R.transpose();
  const bool damps = fit.fitMotion(slow.vehicle, fast.vehicle);
  fit.chord = (state.q.back().head<3>() - state.q.front().head<3>()).normalized();
  fit.vessel = slopeBetween(at_vessel * slow.transfer, at_vessel * (damps ? fast : slow).transfer);
  fit.vehicle = slopeBetween(at_vehicle * slow.tether, at_vehicle * (damps ? fast : slow).tether);
  fit.vessel_tension_jacobian = at_vessel * wave.vessel;
  return true;
}

}  // namespace tether_monitor::monitor
