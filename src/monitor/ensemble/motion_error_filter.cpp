#include "tether_monitor/monitor/ensemble/motion_error_filter.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double ACCELERATION_NOISE = 0.002;  // that the model does not explain [m/s^2/sqrt(Hz)]

core::Matrix3 diagonal(double stddev)
{
  return stddev * stddev * core::Matrix3::Identity();
}
}  // namespace

void MotionErrorFilter::start(const UnknownForce& force, const core::Matrix3& position_covariance,
                              double velocity_stddev, double balance, const TetherLinearization& tether)
{
  force_ = force;
  setTether(tether);
  covariance_.setZero();
  covariance_.block<3, 3>(POSITION, POSITION) = position_covariance;
  covariance_.block<3, 3>(VELOCITY, VELOCITY) = diagonal(velocity_stddev);
  covariance_.block<3, 3>(FAST, FAST) = diagonal(force.fast_stddev);
  covariance_.block<3, 3>(SLOW, SLOW) = diagonal(force.slow_stddev);
  // At rest: the unknown forces are what the tether takes.
  Jacobian rest = Jacobian::Zero();
  rest.block<3, 3>(0, POSITION) = -tether.stiffness;
  rest.block<3, 3>(0, FAST).setIdentity();
  rest.block<3, 3>(0, SLOW).setIdentity();
  const Eigen::Matrix<double, STATES, 3> columns = covariance_ * rest.transpose();
  const core::Matrix3 S = rest * columns + diagonal(balance);
  covariance_ -= columns * S.inverse() * columns.transpose();
  covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval();
}

void MotionErrorFilter::setTether(const TetherLinearization& tether)
{
  tether_ = tether;
  dt_ = 0.0;
}

MotionErrorFilter::Covariance MotionErrorFilter::systemMatrix() const
{
  const core::Matrix3 inverse = tether_.mass.inverse();
  Covariance A = Covariance::Zero();
  A.block<6, 6>(POSITION, POSITION) = tether_.systemMatrix();
  A.block<3, 3>(VELOCITY, FAST) = inverse;
  A.block<3, 3>(VELOCITY, SLOW) = inverse;
  A.block<3, 3>(FAST, FAST) = -core::Matrix3::Identity() / force_.fast_memory;
  A.block<3, 3>(SLOW, SLOW) = -core::Matrix3::Identity() / force_.slow_memory;
  return A;
}

// The trapezoidal rule: stable for whatever is stiff.
void MotionErrorFilter::prepare(double dt)
{
  const Covariance A = systemMatrix(), I = Covariance::Identity();
  const Eigen::PartialPivLU<Covariance> lu(I - 0.5 * dt * A);
  transition_ = lu.solve(I + 0.5 * dt * A);
  Eigen::Matrix<double, STATES, 3> B = Eigen::Matrix<double, STATES, 3>::Zero();
  B.block<3, 3>(VELOCITY, 0) = -tether_.mass.inverse();
  drive_ = lu.solve(dt * B);
  noise_.setZero();
  noise_.diagonal().segment<3>(VELOCITY).setConstant(dt * ACCELERATION_NOISE * ACCELERATION_NOISE);
  const auto walk = [&](double stddev, double memory)
  { return stddev * stddev * -std::expm1(-2.0 * dt / memory); };
  noise_.diagonal().segment<3>(FAST).setConstant(walk(force_.fast_stddev, force_.fast_memory));
  noise_.diagonal().segment<3>(SLOW).setConstant(walk(force_.slow_stddev, force_.slow_memory));
  dt_ = dt;
}

void MotionErrorFilter::predict(double dt, const MemberVectors& applied)
{
  if (!(dt > 0.0))
    return;
  if (!(std::abs(dt - dt_) <= 1e-6 * dt))
    prepare(dt);
  for (Eigen::Index i = 0; i < means_.cols(); ++i)
    means_.col(i) = (transition_ * means_.col(i) + drive_ * applied.col(i)).eval();
  covariance_ = (transition_ * covariance_ * transition_.transpose() + noise_).eval();
}

core::Matrix3 MotionErrorFilter::innovationCovariance(const Jacobian& jacobian, const core::Matrix3& noise) const
{
  return jacobian * covariance_ * jacobian.transpose() + noise;
}

void MotionErrorFilter::correct(const Jacobian& jacobian, const MemberVectors& innovations,
                                const core::Matrix3& noise)
{
  const Eigen::Matrix<double, STATES, 3> columns = covariance_ * jacobian.transpose();
  const core::Matrix3 S = jacobian * columns + noise;
  const Eigen::Matrix<double, STATES, 3> gain = columns * S.inverse();
  for (Eigen::Index i = 0; i < means_.cols(); ++i)
    means_.col(i) += gain * innovations.col(i);
  covariance_ -= gain * columns.transpose();
  covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval();
}

void MotionErrorFilter::inflate(double position_stddev, double force_stddev)
{
  covariance_.diagonal().segment<3>(POSITION).array() += position_stddev * position_stddev;
  covariance_.diagonal().segment<3>(SLOW).array() += force_stddev * force_stddev;
}

void MotionErrorFilter::setForce(const UnknownForce& force)
{
  const auto added = [](double now, double before) { return std::max(now * now - before * before, 0.0); };
  covariance_.diagonal().segment<3>(SLOW).array() += added(force.slow_stddev, force_.slow_stddev);
  covariance_.diagonal().segment<3>(FAST).array() += added(force.fast_stddev, force_.fast_stddev);
  force_ = force;
  dt_ = 0.0;
}

MotionErrorFilter::Jacobian MotionErrorFilter::positionJacobian()
{
  Jacobian H = Jacobian::Zero();
  H.block<3, 3>(0, POSITION).setIdentity();
  return H;
}

MotionErrorFilter::Jacobian MotionErrorFilter::velocityJacobian()
{
  Jacobian H = Jacobian::Zero();
  H.block<3, 3>(0, VELOCITY).setIdentity();
  return H;
}

MotionErrorFilter::Jacobian MotionErrorFilter::tensionJacobian(const TensionJacobian& tension)
{
  Jacobian H = Jacobian::Zero();
  H.block<1, 3>(0, POSITION) = tension.position;
  H.block<1, 3>(0, VELOCITY) = tension.velocity;
  return H;
}

double MotionErrorFilter::tensionCovariance(const TensionJacobian& a, const TensionJacobian& b) const
{
  return tensionJacobian(a).row(0) * covariance_ * tensionJacobian(b).row(0).transpose();
}

double MotionErrorFilter::tensionStddev(const TensionJacobian& tension) const
{
  return std::sqrt(std::max(tensionCovariance(tension, tension), 0.0));
}

void MotionErrorFilter::save(Belief& belief) const
{
  belief.means = means_;
  belief.covariance = covariance_;
}

void MotionErrorFilter::restore(const Belief& belief)
{
  means_ = belief.means;
  covariance_ = belief.covariance;
}

}  // namespace tether_monitor::monitor
