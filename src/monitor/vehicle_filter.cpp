#include "tether_monitor/monitor/vehicle_filter.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double STRIDE = 0.25;  // [s] between looks at the covariance
constexpr double UNBALANCED =
    0.2;                          // disturbance at the start that is not balanced, over its standard deviation [-]
constexpr double SURPRISE = 0.3;  // uncertainty of the force found at the start, over its size [-]
constexpr double FIXED_PLACE = 0.3, FIXED_SPEED = 0.03,
                 FIXED_FORCE = 0.001;  // a free body's triple pole at 0.1 rad/s
constexpr double HANDOVER = 4;  // [s] in which the nominal vehicle takes over what is known of the disturbance
constexpr double REACH_TIME = 60.0;  // [s] in which an error of the reach fades
constexpr double SHAPE_TIME = 60.0;  // [s] in which a tether forgets how it began
constexpr double PULL_RATE = 0.2;    // [1/s] bandwidth with which the nominal vehicle follows the mean
constexpr double STRONGEST = 2.0;    // pull over the standard deviation of the disturbance [-]
constexpr double MOST_DOUBT =
    2.0;  // standard deviation of the disturbance over that before the first measurement [-]
}  // namespace

void VehicleFilter::start(const DisturbanceModel& model, const core::Matrix3& place, double velocity_stddev,
                          const core::Vector3& force, const core::Matrix3& force_doubt, const core::Vector3& drag,
                          const EndStiffness& stiffness)
{
  model_ = model;
  error_.setZero();
  disturbance_ = force;
  drag_ = drag;
  drag_force_.setZero();
  drag_share_ = 0.0;
  waiting_ = 0.0;
  setStiffness(stiffness);
  covariance_.setZero();
  covariance_.block<3, 3>(0, 0) = place;
  covariance_.diagonal().segment<3>(3).setConstant(velocity_stddev * velocity_stddev);
  // A force that has to be there already says how large such forces are.
  covariance_.diagonal().segment<3>(6) =
      (UNBALANCED * model.shares() * model.force).cwiseAbs2() + (SURPRISE * force).cwiseAbs2();
  covariance_.block<3, 3>(6, 6) += force_doubt;
  start_doubt_ = force_doubt;
  covariance_(9, 9) = model.drag * model.drag;
  covariance_(10, 10) = model.first_reach * model.first_reach;
  // At the start the vehicle is in balance: what is wrong of its place or its drag is wrong of the disturbance.
  Matrix balance = Matrix::Identity();
  balance.block<3, 3>(6, 0) = stiffness.stiffness;
  balance.block<3, 1>(6, 9) = -drag;
  covariance_ = (balance * covariance_ * balance.transpose()).eval();
}

void VehicleFilter::setStiffness(const EndStiffness& stiffness)
{
  stiffness_ = stiffness;
  if (model_.gains == ObserverGains::WITHOUT_TETHER)
  {
    stiffness_.stiffness.setZero();
    stiffness_.damping.setZero();
  }
  mass_inverse_ = stiffness.mass.inverse();
  mean_dt_ = 0.0;
}

VehicleFilter::Matrix VehicleFilter::rates() const
{
  Matrix A = Matrix::Zero();
  A.block<3, 3>(0, 3).setIdentity();
  A.block<3, 3>(3, 0) = -mass_inverse_ * stiffness_.stiffness;
  A.block<3, 3>(3, 3) = -mass_inverse_ * stiffness_.damping;
  A.block<3, 3>(3, 6) = mass_inverse_;
  A.block<3, 1>(3, 9) = mass_inverse_ * drag_;
  A(10, 10) = -1.0 / REACH_TIME;
  return A;
}

core::Vector3 VehicleFilter::pull() const
{
  const core::Vector3 wanted =
      stiffness_.mass * (PULL_RATE * PULL_RATE * error_.segment<3>(0) + 2.0 * PULL_RATE * velocityError());
  const double most = STRONGEST * model_.force;
  return wanted.norm() > most ? core::Vector3(most / wanted.norm() * wanted) : wanted;
}

void VehicleFilter::predict(double dt, const core::Vector3& drag, double unrest)
{
  if (!(dt > 0.0))
    return;
  // The mean, by the trapezoidal rule (stable for whatever is stiff).
  const Matrix I = Matrix::Identity();
  if (std::abs(dt - mean_dt_) > 1e-9 * dt)
  {
    const Matrix A = rates();
    const Eigen::PartialPivLU<Matrix> lu(I - 0.5 * dt * A);
    mean_transition_ = lu.solve(I + 0.5 * dt * A);
    Eigen::Matrix<double, STATES, 3> B = Eigen::Matrix<double, STATES, 3>::Zero();
    B.block<3, 3>(3, 0) = -mass_inverse_;
    mean_drive_ = lu.solve(dt * B);
    mean_dt_ = dt;
  }
  error_ = (mean_transition_ * error_ + mean_drive_ * pull()).eval();
  const double share = 1.0 - std::exp(-dt / HANDOVER);
  disturbance_ += share * error_.segment<3>(6);
  error_.segment<3>(6) *= 1.0 - share;
  drag_share_ += share * error_[9];
  error_[9] *= 1.0 - share;
  drag_ = drag;
  drag_force_ = drag_share_ * drag;

  unrest_ = unrest;
  waiting_ += dt;
  if (waiting_ >= STRIDE)
    spread();
}

// Brings the covariance up to now.
void VehicleFilter::spread()
{
  if (!(waiting_ > 0.0))
    return;
  // Backward Euler: stable for whatever is stiff.
  const Matrix phi = (Matrix::Identity() - waiting_ * rates()).inverse();
  covariance_ = (phi * covariance_ * phi.transpose()).eval();
  covariance_.diagonal().segment<3>(3).array() += waiting_ * model_.acceleration * model_.acceleration;
  // Unrest has no favourite direction.
  const double walk = model_.force_walk * model_.force_walk * waiting_;
  covariance_.diagonal().segment<3>(6) +=
      walk * (model_.shares().cwiseAbs2() + core::Vector3::Constant(unrest_ * unrest_ - 1.0));
  // A tether that does not begin in the steady state pulls differently until it is there.
  const double left = std::exp(-2.0 * waiting_ / SHAPE_TIME);
  covariance_.block<3, 3>(6, 6) += (1.0 - left) * start_doubt_;
  start_doubt_ *= left;
  const double drag_walk = unrest_ * model_.drag_walk;
  covariance_(9, 9) += waiting_ * drag_walk * drag_walk;
  covariance_(10, 10) += waiting_ * 2.0 * model_.reach * model_.reach / REACH_TIME;
  // Nobody can be much less sure of the disturbance than before the first measurement.
  for (int i = 6; i < 10; ++i)
  {
    const double most = MOST_DOUBT * (i < 9 ? model_.force : model_.drag);
    const double excess = std::sqrt(std::max(covariance_(i, i), 0.0)) / most;
    if (excess > 1.0)
    {
      covariance_.row(i) /= excess;
      covariance_.col(i) /= excess;
    }
  }
  waiting_ = 0.0;
}

VehicleFilter::Look VehicleFilter::positionLook() const
{
  Look H = Look::Zero();
  H.block<3, 3>(0, 0).setIdentity();
  H.col(10) = stiffness_.chord;
  return H;
}

VehicleFilter::Look VehicleFilter::velocityLook() const
{
  Look H = Look::Zero();
  H.block<3, 3>(0, 3).setIdentity();
  return H;
}

double VehicleFilter::mahalanobis(const Look& H, const core::Vector3& offset, const core::Vector3& stddev) const
{
  core::Matrix3 S = H * covariance_ * H.transpose();
  S.diagonal() += stddev.cwiseAbs2();
  const core::Vector3 innovation = offset - H * error_;
  return innovation.dot(S.ldlt().solve(innovation));
}

void VehicleFilter::correct(const Look& H, const core::Vector3& offset, const core::Vector3& stddev)
{
  if (model_.gains == ObserverGains::FIXED)
  {
    const core::Vector3 innovation = offset - H * error_;
    error_.segment<3>(0) += FIXED_PLACE * innovation;
    error_.segment<3>(3) += FIXED_SPEED * innovation;
    error_.segment<3>(6) += FIXED_FORCE * (stiffness_.mass * innovation);
    return;
  }
  spread();
  const Eigen::Matrix<double, STATES, 3> columns = covariance_ * H.transpose();
  core::Matrix3 S = H * columns;
  S.diagonal() += stddev.cwiseAbs2();
  const Eigen::Matrix<double, STATES, 3> gain = columns * S.inverse();
  error_ += gain * (offset - H * error_);
  covariance_ -= gain * columns.transpose();
  covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval();
}

double VehicleFilter::distance(const core::Vector3& offset, const core::Vector3& stddev) const
{
  return mahalanobis(positionLook(), offset, stddev);
}

double VehicleFilter::velocityDistance(const core::Vector3& offset, const core::Vector3& stddev) const
{
  return mahalanobis(velocityLook(), offset, stddev);
}

void VehicleFilter::correctPosition(const core::Vector3& offset, const core::Vector3& stddev)
{
  correct(positionLook(), offset, stddev);
}

void VehicleFilter::correctVelocity(const core::Vector3& offset, const core::Vector3& stddev)
{
  correct(velocityLook(), offset, stddev);
}

core::Vector3 VehicleFilter::positionStddev() const
{
  const Look H = positionLook();
  return (H * covariance_ * H.transpose()).diagonal().cwiseMax(0.0).cwiseSqrt();
}

void VehicleFilter::doubtPosition(double stddev)
{
  covariance_.diagonal().segment<3>(0).array() += stddev * stddev;
}

core::Vector3 VehicleFilter::forceStddev() const
{
  Look H = Look::Zero();
  H.block<3, 3>(0, 6).setIdentity();
  H.col(9) = drag_;
  return (H * covariance_ * H.transpose()).diagonal().cwiseMax(0.0).cwiseSqrt();
}

double VehicleFilter::tensionStddev(const TensionSlope& slope) const
{
  Eigen::Matrix<double, 1, 6> h;
  h << slope.position, slope.velocity;
  return std::sqrt(std::max((h * covariance_.topLeftCorner<6, 6>() * h.transpose())(0), 0.0));
}

}  // namespace tether_monitor::monitor
