#pragma once

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::core
{
/// Position [m] and velocity [m/s] of a tether end at one time, world frame.
struct EndMotion
{
  Vector3 position = Vector3::Zero();
  Vector3 velocity = Vector3::Zero();

  template <class Archive>
  void serialize(Archive& a)
  {
    a(position, velocity);
  }
};

/// Motion of a held end over a stretch of time: a cubic in time, continuous in position and velocity, (M17).
class EndTrajectory
{
 public:
  EndTrajectory() = default;

  /// The cubic Hermite path from `from` at time t0 to `to` at time t1 [s]; t1 > t0.
  static EndTrajectory between(double t0, const EndMotion& from, double t1, const EndMotion& to);
  /// Uniform motion through `point` at time t0.
  static EndTrajectory uniform(double t0, const EndMotion& point);

  Vector3 position(double t) const;
  Vector3 velocity(double t) const;
  Vector3 acceleration(double t) const;
  EndMotion at(double t) const { return {position(t), velocity(t)}; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(t0_, c_);
  }

 private:
  double t0_ = 0.0;
  // Coefficients of 1, x, x^2, x^3 with x = t - t0.
  Eigen::Matrix<double, 3, 4> c_ = Eigen::Matrix<double, 3, 4>::Zero();
};

}  // namespace tether_monitor::core
