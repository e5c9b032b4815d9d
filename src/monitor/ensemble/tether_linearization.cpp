#include "tether_monitor/monitor/ensemble/tether_linearization.h"

#include <Eigen/Eigenvalues>

#include "tether_monitor/core/assembly/end_forces.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double FASTEST_GROWTH = 0.1;  // of a motion that a tether may drive [1/s]

TensionJacobian slopeBetween(const RowVector3& slow, const RowVector3& fast)
{
  TensionJacobian slope;
  slope.velocity = (fast - slow) / (TetherLinearization::FIT_RATE_HIGH - TetherLinearization::FIT_RATE_LOW);
  slope.position = slow - TetherLinearization::FIT_RATE_LOW * slope.velocity;
  return slope;
}

// That of its quadratic form.
core::Matrix3 withoutNegativePart(const core::Matrix3& matrix)
{
  const Eigen::SelfAdjointEigenSolver<core::Matrix3> eigen(0.5 * (matrix + matrix.transpose()));
  return matrix -
         eigen.eigenvectors() * eigen.eigenvalues().cwiseMin(0.0).asDiagonal() * eigen.eigenvectors().transpose();
}
}  // namespace

bool TetherLinearization::fitMotion(const core::Matrix3& slow, const core::Matrix3& fast)
{
  constexpr double A = FIT_RATE_LOW, B = FIT_RATE_HIGH;
  damping = (fast - slow - (B * B - A * A) * mass) / (B - A);
  stiffness = slow - A * damping - A * A * mass;
  if (growthRate() <= FASTEST_GROWTH)
    return true;
  damping = withoutNegativePart(damping);
  stiffness = withoutNegativePart(slow - A * damping - A * A * mass);
  return false;
}

Eigen::Matrix<double, 6, 6> TetherLinearization::systemMatrix() const
{
  const core::Matrix3 inverse = mass.inverse();
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
  A.topRightCorner<3, 3>().setIdentity();
  A.bottomLeftCorner<3, 3>() = -inverse * stiffness;
  A.bottomRightCorner<3, 3>() = -inverse * damping;
  return A;
}

double TetherLinearization::growthRate() const
{
  return Eigen::EigenSolver<Eigen::Matrix<double, 6, 6>>(systemMatrix(), false).eigenvalues().real().maxCoeff();
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
