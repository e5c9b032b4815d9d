#pragma once

#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/vehicle/tether_linearization.h"

namespace tether_monitor::monitor
{
/// What the filter takes the unknown on the vehicle to be.
struct ProcessNoiseModel
{
  double force = 1000.0;  ///< standard deviation of the unmodelled force [N], > 0.
  double vertical_ratio =
      0.15;  ///< of both of its upward part: weight is known better than thrust, drag and current [-].
  double force_random_walk = 10.0;  ///< how it wanders [N/sqrt(s)], > 0.
  double drag = 0.3;                ///< standard deviation of the relative error of the drag areas [-], > 0.
  double drag_random_walk = 0.003;  ///< how that wanders [1/sqrt(s)], > 0.
  ObserverGains gains = ObserverGains::KALMAN;
  double chord_bias = 0.01;  ///< standard deviation of the normalizedInnovationSquared of the ends that the model
                             ///< cannot explain [m], > 0.
  double initial_chord_bias = 0.1;  ///< the same at the start, when the tether's shape is not known yet [m], > 0.
  double acceleration = 0.002;      ///< white acceleration that the model does not explain [m/s^2/sqrt(Hz)], >= 0.

  /// How much of a force there is along every axis [-].
  core::Vector3 axisRatios() const { return {1.0, 1.0, vertical_ratio}; }
};

/**
 * Error-state Kalman filter of a vehicle on a tether: (E1)-(E9) of doc/estimation.md.
 *
 * The simulated vehicle is the nominal motion; the filter knows how far the mean of its belief is from there
 * (error) and how sure it is (covariance). Eleven states: position, velocity, disturbance force, relative error of
 * the drag, error of the chord_bias: the normalizedInnovationSquared of the ends beyond what the model gives. The
 * nominal motion is not corrected by leaps: feedbackForce() is a force that brings it to the mean, and the filter
 * knows it. Plain data: copy it to save it.
 */
class VehicleErrorStateFilter
{
 public:
  static constexpr int STATES = 11;
  using Vector = Eigen::Matrix<double, STATES, 1>;
  using Matrix = Eigen::Matrix<double, STATES, STATES>;

  /**
   * Begins in balance.
   *
   * @param position_covariance            covariance of the position [m^2].
   * @param velocity_stddev  [m/s]
   * @param force            disturbance that is acting [N].
   * @param initial_force_covariance      covariance of it, beyond what is usual [N^2].
   * @param drag             on the vehicle [N].
   */
  void start(const ProcessNoiseModel& model, const core::Matrix3& position_covariance, double velocity_stddev,
             const core::Vector3& force, const core::Matrix3& initial_force_covariance, const core::Vector3& drag,
             const TetherLinearization& stiffness);
  /// The tether's part in the motion, from now on.
  void setStiffness(const TetherLinearization& stiffness);

  /**
   * Goes on by dt [s] under the feedbackForce that was in force.
   *
   * @param drag       drag on the nominal vehicle [N], world axes: what an error of the drag areas is a share of.
   * @param processNoiseScale     factor on the wandering of the disturbance, >= 1.
   */
  void predict(double dt, const core::Vector3& drag, double processNoiseScale);

  /// Normalised innovation squared of a position. @param offset  from the nominal one [m]. @param noise
  /// covariance.
  double normalizedInnovationSquared(const core::Vector3& offset, const core::Matrix3& noise) const;
  void correctPosition(const core::Vector3& offset, const core::Matrix3& noise);
  /// The same for a measured velocity.
  double normalizedVelocityInnovationSquared(const core::Vector3& offset, const core::Matrix3& noise) const;
  void correctVelocity(const core::Vector3& offset, const core::Matrix3& noise);
  /// Doubts the position by `stddev` more [m].
  void inflatePositionCovariance(double stddev);

  /// Force on the nominal vehicle [N], world axes: the disturbance and what brings it to the mean.
  core::Vector3 appliedForce() const { return transferred_disturbance_ + drag_force_ + feedbackForce(); }
  /// The part of it that is feedback, not disturbance.
  core::Vector3 feedbackForce() const;

  core::Vector3 positionError() const { return error_.segment<3>(0) + error_[10] * stiffness_.chord; }
  core::Vector3 velocityError() const { return error_.segment<3>(3); }
  /// Best estimate of the disturbance [N], world axes, the part of the drag included.
  core::Vector3 disturbance() const
  {
    return transferred_disturbance_ + drag_force_ + error_.segment<3>(6) + drag_ * error_[9];
  }
  /// Best estimate of the relative error of the drag areas [-].
  double dragError() const { return drag_share_ + error_[9]; }
  const Matrix& covariance() const { return covariance_; }
  core::Matrix3 positionCovariance() const;
  core::Matrix3 velocityCovariance() const { return covariance_.block<3, 3>(3, 3); }
  core::Vector3 forceStddev() const;
  /// Standard deviation of a tension [N], of the filter's own uncertainty.
  double tensionStddev(const TensionJacobian& slope) const;
  /// False for what no measurements can have made: for states that come from outside.
  bool isValid() const
  {
    return error_.allFinite() && covariance_.allFinite() && mass_inverse_.allFinite() &&
           initial_force_covariance_.allFinite();
  }
  const TetherLinearization& stiffness() const { return stiffness_; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(model_.gains, model_.force, model_.vertical_ratio, model_.force_random_walk, model_.drag,
      model_.drag_random_walk, model_.chord_bias, model_.initial_chord_bias, model_.acceleration, stiffness_,
      mass_inverse_, error_, covariance_, transferred_disturbance_, drag_force_, drag_, drag_share_,
      initial_force_covariance_, mean_transition_, mean_drive_, mean_dt_, pending_time_, process_noise_scale_);
  }

 private:
  Matrix systemMatrix() const;
  void propagateCovariance();
  using MeasurementMatrix = Eigen::Matrix<double, 3, STATES>;
  MeasurementMatrix positionJacobian() const;
  MeasurementMatrix velocityJacobian() const;
  void correct(const MeasurementMatrix& H, const core::Vector3& offset, const core::Matrix3& noise);
  double mahalanobis(const MeasurementMatrix& H, const core::Vector3& offset, const core::Matrix3& noise) const;

  ProcessNoiseModel model_;
  TetherLinearization stiffness_;
  core::Matrix3 mass_inverse_ = core::Matrix3::Identity();
  Vector error_ = Vector::Zero();
  Matrix covariance_ = Matrix::Identity();
  core::Vector3 transferred_disturbance_ = core::Vector3::Zero();  // that the nominal vehicle feels [N]
  core::Vector3 drag_force_ = core::Vector3::Zero();               // likewise, of the error of the drag
  core::Vector3 drag_ = core::Vector3::Zero();                     // on the nominal vehicle [N]
  double drag_share_ = 0.0;                                        // in the nominal motion [-]
  core::Matrix3 initial_force_covariance_ =
      core::Matrix3::Zero();                     // what is left of the uncertainty of the initial force [N^2]
  Matrix mean_transition_ = Matrix::Identity();  // over mean_dt_
  Eigen::Matrix<double, STATES, 3> mean_drive_ = Eigen::Matrix<double, STATES, 3>::Zero();
  double mean_dt_ = 0.0;
  double pending_time_ = 0.0;  // [s] that the covariance is behind
  double process_noise_scale_ = 1.0;
};

}  // namespace tether_monitor::monitor
