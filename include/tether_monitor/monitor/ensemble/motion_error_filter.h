#pragma once

#include "tether_monitor/monitor/ensemble/ensemble_transform.h"
#include "tether_monitor/monitor/ensemble/tether_linearization.h"
#include "tether_monitor/monitor/ensemble/unknown_force.h"

namespace tether_monitor::monitor
{
/**
 * Kalman filters of the vehicle's motion, one for each member of an ensemble, all with the same covariance and
 * gains: (E1)-(E4) of doc/theory/estimation.md, the bias-free filter of Friedland (1969).
 *
 * A member's simulated vehicle is the nominal motion. Twelve states: what has to be added to its position and
 * velocity, the slow and the fast unknown force. The covariance is that which is left if the member's parameters
 * are right; it does not depend on them. Allocates only in the constructor. Plain data: copy it to save it.
 */
class MotionErrorFilter
{
 public:
  static constexpr int STATES = 12, POSITION = 0, VELOCITY = 3, FAST = 6, SLOW = 9;
  using Covariance = Eigen::Matrix<double, STATES, STATES>;
  using Means = Eigen::Matrix<double, STATES, Eigen::Dynamic>;
  using Jacobian = Eigen::Matrix<double, 3, STATES>;

  explicit MotionErrorFilter(int members = 0) : means_(Means::Zero(STATES, members)) {}

  /**
   * Begins with vehicles at rest in the flow.
   *
   * @param position_covariance  of the measured position [m^2].
   * @param velocity_stddev      [m/s]
   * @param balance              the forces balance to within this [N], > 0.
   */
  void start(const UnknownForce& force, const core::Matrix3& position_covariance, double velocity_stddev,
             double balance, const TetherLinearization& tether);
  /// The tether's part in the motion, from now on.
  void setTether(const TetherLinearization& tether);

  /// Goes on by dt [s]. @param applied  force on every nominal vehicle beyond the model, in force meanwhile [N].
  void predict(double dt, const MemberVectors& applied);
  /**
   * Kalman's update of every member.
   *
   * @param innovations  measured less what each member predicts, its states included.
   * @param noise        of the measurement.
   */
  void correct(const Jacobian& jacobian, const MemberVectors& innovations, const core::Matrix3& noise);
  /// Covariance of the innovation of a member whose parameters are right.
  core::Matrix3 innovationCovariance(const Jacobian& jacobian, const core::Matrix3& noise) const;
  /// Doubts position [m] and slow force [N] by so much more.
  void inflate(double position_stddev, double force_stddev);

  static Jacobian positionJacobian();
  static Jacobian velocityJacobian();
  /// Of a tension, in the first row.
  static Jacobian tensionJacobian(const TensionJacobian& tension);

  Means& means() { return means_; }
  const Means& means() const { return means_; }
  const Covariance& covariance() const { return covariance_; }
  const TetherLinearization& tether() const { return tether_; }
  const UnknownForce& force() const { return force_; }
  /// Standard deviation of a tension [N] if the parameters are right.
  double tensionStddev(const TensionJacobian& tension) const;
  /// What is uncertain of two tensions together [N^2].
  double tensionCovariance(const TensionJacobian& a, const TensionJacobian& b) const;
  bool isValid() const { return means_.allFinite() && covariance_.allFinite(); }

  /// Mean and covariance at one time.
  struct Belief
  {
    Means means;
    Covariance covariance = Covariance::Identity();

    template <class Archive>
    void serialize(Archive& a)
    {
      a(means, covariance);
    }
  };
  /// The unknown forces are told to be of another size: what is larger than before adds to their variance.
  void setForce(const UnknownForce& force);
  void save(Belief& belief) const;
  void restore(const Belief& belief);

  template <class Archive>
  void serialize(Archive& a)
  {
    a(force_.slow_stddev, force_.slow_memory, force_.fast_stddev, force_.fast_memory, tether_, means_, covariance_,
      transition_, drive_, noise_, dt_);
  }

 private:
  Covariance systemMatrix() const;
  void prepare(double dt);

  UnknownForce force_;
  TetherLinearization tether_;
  Means means_;
  Covariance covariance_ = Covariance::Identity();
  Covariance transition_ = Covariance::Identity(), noise_ = Covariance::Zero();  // over dt_
  Eigen::Matrix<double, STATES, 3> drive_ = Eigen::Matrix<double, STATES, 3>::Zero();
  double dt_ = 0.0;
};

}  // namespace tether_monitor::monitor
