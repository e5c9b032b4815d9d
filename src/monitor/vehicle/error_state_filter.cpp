#include "tether_monitor/monitor/vehicle/error_state_filter.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double COVARIANCE_PROPAGATION_INTERVAL = 0.25;  // [s] between propagations of the covariance
constexpr double UNBALANCED_RELATIVE_STDDEV =
    0.2;  // disturbance at the start that is not balanced, over its standard deviation [-]
constexpr double INITIAL_FORCE_RELATIVE_STDDEV =
    0.3;  // uncertainty of the force found at the start, over its size [-]
constexpr double FIXED_PLACE = 0.3, FIXED_SPEED = 0.03,
                 FIXED_FORCE = 0.001;  // a free body's triple pole at 0.1 rad/s
constexpr double DISTURBANCE_TRANSFER_TIME =
    4;  // [s] in which the nominal vehicle takes over what is known of the disturbance
constexpr double CHORD_BIAS_TIME = 60.0;    // [s] in which an error of the chord_bias fades
constexpr double SHAPE_MEMORY_TIME = 60.0;  // [s] in which a tether forgets how it began
constexpr double FEEDBACK_BANDWIDTH = 0.2;  // [1/s] bandwidth with which the nominal vehicle follows the mean
constexpr double MAX_FEEDBACK_RATIO = 2.0;  // feedbackForce over the standard deviation of the disturbance [-]
constexpr double MAX_STDDEV_RATIO =
    2.0;  // standard deviation of the disturbance over that before the first measurement [-]
}  // namespace

void VehicleErrorStateFilter::start(const ProcessNoiseModel& model, const core::Matrix3& position_covariance,
                                    double velocity_stddev, const core::Vector3& force,
                                    const core::Matrix3& initial_force_covariance, const core::Vector3& drag,
                                    const TetherLinearization& stiffness)
{
  model_ = model;
  error_.setZero();
  transferred_disturbance_ = force;
  drag_ = drag;
  drag_force_.setZero();
  drag_share_ = 0.0;
  pending_time_ = 0.0;
  setStiffness(stiffness);
  covariance_.setZero();
  covariance_.block<3, 3>(0, 0) = position_covariance;
  covariance_.diagonal().segment<3>(3).setConstant(velocity_stddev * velocity_stddev);
  // A force that has to be there already says how large such forces are.
  covariance_.diagonal().segment<3>(6) =
      (UNBALANCED_RELATIVE_STDDEV * model.axisRatios() * model.force).cwiseAbs2() +
      (INITIAL_FORCE_RELATIVE_STDDEV * force).cwiseAbs2();
  covariance_.block<3, 3>(6, 6) += initial_force_covariance;
  initial_force_covariance_ = initial_force_covariance;
  covariance_(9, 9) = model.drag * model.drag;
  covariance_(10, 10) = model.initial_chord_bias * model.initial_chord_bias;
  // At the start the vehicle is in balance: what is wrong of its position_covariance or its drag is wrong of the
  // disturbance.
  Matrix balance = Matrix::Identity();
  balance.block<3, 3>(6, 0) = stiffness.stiffness;
  balance.block<3, 1>(6, 9) = -drag;
  covariance_ = (balance * covariance_ * balance.transpose()).eval();
}

void VehicleErrorStateFilter::setStiffness(const TetherLinearization& stiffness)
{
  stiffness_ = stiffness;
  if (model_.gains == ObserverGains::NO_TETHER_MODEL)
  {
    stiffness_.stiffness.setZero();
    stiffness_.damping.setZero();
  }
  mass_inverse_ = stiffness.mass.inverse();
  mean_dt_ = 0.0;
}

VehicleErrorStateFilter::Matrix VehicleErrorStateFilter::systemMatrix() const
{
  Matrix A = Matrix::Zero();
  A.block<3, 3>(0, 3).setIdentity();
  A.block<3, 3>(3, 0) = -mass_inverse_ * stiffness_.stiffness;
  A.block<3, 3>(3, 3) = -mass_inverse_ * stiffness_.damping;
  A.block<3, 3>(3, 6) = mass_inverse_;
  A.block<3, 1>(3, 9) = mass_inverse_ * drag_;
  A(10, 10) = -1.0 / CHORD_BIAS_TIME;
  return A;
}

core::Vector3 VehicleErrorStateFilter::feedbackForce() const
{
  const core::Vector3 wanted = stiffness_.mass * (FEEDBACK_BANDWIDTH * FEEDBACK_BANDWIDTH * error_.segment<3>(0) +
                                                  2.0 * FEEDBACK_BANDWIDTH * velocityError());
  const double most = MAX_FEEDBACK_RATIO * model_.force;
  return wanted.norm() > most ? core::Vector3(most / wanted.norm() * wanted) : wanted;
}

void VehicleErrorStateFilter::predict(double dt, const core::Vector3& drag, double processNoiseScale)
{
  if (!(dt > 0.0))
    return;
  // The mean, by the trapezoidal rule (stable for whatever is stiff).
  const Matrix I = Matrix::Identity();
  if (std::abs(dt - mean_dt_) > 1e-9 * dt)
  {
    const Matrix A = systemMatrix();
    const Eigen::PartialPivLU<Matrix> lu(I - 0.5 * dt * A);
    mean_transition_ = lu.solve(I + 0.5 * dt * A);
    Eigen::Matrix<double, STATES, 3> B = Eigen::Matrix<double, STATES, 3>::Zero();
    B.block<3, 3>(3, 0) = -mass_inverse_;
    mean_drive_ = lu.solve(dt * B);
    mean_dt_ = dt;
  }
  error_ = (mean_transition_ * error_ + mean_drive_ * feedbackForce()).eval();
  const double share = 1.0 - std::exp(-dt / DISTURBANCE_TRANSFER_TIME);
  transferred_disturbance_ += share * error_.segment<3>(6);
  error_.segment<3>(6) *= 1.0 - share;
  drag_share_ += share * error_[9];
  error_[9] *= 1.0 - share;
  drag_ = drag;
  drag_force_ = drag_share_ * drag;

  process_noise_scale_ = processNoiseScale;
  pending_time_ += dt;
  if (pending_time_ >= COVARIANCE_PROPAGATION_INTERVAL)
    propagateCovariance();
}

// Brings the covariance up to now.
void VehicleErrorStateFilter::propagateCovariance()
{
  if (!(pending_time_ > 0.0))
    return;
  // Backward Euler: stable for whatever is stiff.
  const Matrix phi = (Matrix::Identity() - pending_time_ * systemMatrix()).inverse();
  covariance_ = (phi * covariance_ * phi.transpose()).eval();
  covariance_.diagonal().segment<3>(3).array() += pending_time_ * model_.acceleration * model_.acceleration;
  // Unrest has no favourite direction.
  const double walk = model_.force_random_walk * model_.force_random_walk * pending_time_;
  covariance_.diagonal().segment<3>(6) +=
      walk * (model_.axisRatios().cwiseAbs2() +
              core::Vector3::Constant(process_noise_scale_ * process_noise_scale_ - 1.0));
  // A tether that does not begin in the steady state pulls differently until it is there.
  const double left = std::exp(-2.0 * pending_time_ / SHAPE_MEMORY_TIME);
  covariance_.block<3, 3>(6, 6) += (1.0 - left) * initial_force_covariance_;
  initial_force_covariance_ *= left;
  const double drag_random_walk = process_noise_scale_ * model_.drag_random_walk;
  covariance_(9, 9) += pending_time_ * drag_random_walk * drag_random_walk;
  covariance_(10, 10) += pending_time_ * 2.0 * model_.chord_bias * model_.chord_bias / CHORD_BIAS_TIME;
  // Nobody can be much less sure of the disturbance than before the first measurement.
  for (int i = 6; i < 10; ++i)
  {
    const double most = MAX_STDDEV_RATIO * (i < 9 ? model_.force : model_.drag);
    const double excess = std::sqrt(std::max(covariance_(i, i), 0.0)) / most;
    if (excess > 1.0)
    {
      covariance_.row(i) /= excess;
      covariance_.col(i) /= excess;
    }
  }
  pending_time_ = 0.0;
}

VehicleErrorStateFilter::MeasurementMatrix VehicleErrorStateFilter::positionJacobian() const
{
  MeasurementMatrix H = MeasurementMatrix::Zero();
  H.block<3, 3>(0, 0).setIdentity();
  H.col(10) = stiffness_.chord;
  return H;
}

VehicleErrorStateFilter::MeasurementMatrix VehicleErrorStateFilter::velocityJacobian() const
{
  MeasurementMatrix H = MeasurementMatrix::Zero();
  H.block<3, 3>(0, 3).setIdentity();
  return H;
}

double VehicleErrorStateFilter::mahalanobis(const MeasurementMatrix& H, const core::Vector3& offset,
                                            const core::Matrix3& noise) const
{
  core::Matrix3 S = H * covariance_ * H.transpose();
  S += noise;
  const core::Vector3 innovation = offset - H * error_;
  return innovation.dot(S.ldlt().solve(innovation));
}

void VehicleErrorStateFilter::correct(const MeasurementMatrix& H, const core::Vector3& offset,
                                      const core::Matrix3& noise)
{
  if (model_.gains == ObserverGains::FIXED)
  {
    const core::Vector3 innovation = offset - H * error_;
    error_.segment<3>(0) += FIXED_PLACE * innovation;
    error_.segment<3>(3) += FIXED_SPEED * innovation;
    error_.segment<3>(6) += FIXED_FORCE * (stiffness_.mass * innovation);
    return;
  }
  propagateCovariance();
  const Eigen::Matrix<double, STATES, 3> columns = covariance_ * H.transpose();
  core::Matrix3 S = H * columns;
  S += noise;
  const Eigen::Matrix<double, STATES, 3> gain = columns * S.inverse();
  error_ += gain * (offset - H * error_);
  covariance_ -= gain * columns.transpose();
  covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval();
}

double VehicleErrorStateFilter::normalizedInnovationSquared(const core::Vector3& offset,
                                                            const core::Matrix3& noise) const
{
  return mahalanobis(positionJacobian(), offset, noise);
}

double VehicleErrorStateFilter::normalizedVelocityInnovationSquared(const core::Vector3& offset,
                                                                    const core::Matrix3& noise) const
{
  return mahalanobis(velocityJacobian(), offset, noise);
}

void VehicleErrorStateFilter::correctPosition(const core::Vector3& offset, const core::Matrix3& noise)
{
  correct(positionJacobian(), offset, noise);
}

void VehicleErrorStateFilter::correctVelocity(const core::Vector3& offset, const core::Matrix3& noise)
{
  correct(velocityJacobian(), offset, noise);
}

core::Matrix3 VehicleErrorStateFilter::positionCovariance() const
{
  const MeasurementMatrix H = positionJacobian();
  return H * covariance_ * H.transpose();
}

void VehicleErrorStateFilter::inflatePositionCovariance(double stddev)
{
  covariance_.diagonal().segment<3>(0).array() += stddev * stddev;
}

core::Vector3 VehicleErrorStateFilter::forceStddev() const
{
  MeasurementMatrix H = MeasurementMatrix::Zero();
  H.block<3, 3>(0, 6).setIdentity();
  H.col(9) = drag_;
  return (H * covariance_ * H.transpose()).diagonal().cwiseMax(0.0).cwiseSqrt();
}

double VehicleErrorStateFilter::tensionStddev(const TensionJacobian& slope) const
{
  Eigen::Matrix<double, 1, 6> h;
  h << slope.position, slope.velocity;
  return std::sqrt(std::max((h * covariance_.topLeftCorner<6, 6>() * h.transpose())(0), 0.0));
}

}  // namespace tether_monitor::monitor
