#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <vector>

#include "tether_monitor/monitor/measurements/body_state.h"
#include "tether_monitor/monitor/measurements/rejection.h"

namespace tether_monitor::monitor
{
/**
 * Measured motion of one body: poses, and rates and attitudes where something measures them alone.
 *
 * Between two poses: cubic Hermite in position, slerp in orientation. Beyond the last pose: constant velocity.
 * Where attitudes come by themselves (a motion sensor), the orientation is theirs. A
 * velocity that is not measured is the slope of a straight line through the poses of the last VELOCITY_WINDOW.
 * Holds measurements of the last seconds of each kind, at most CAPACITY, SPACING apart but for the last, however
 * fast they come: those that are stamped ahead leave room for those of the past. Allocates only in the
 * constructor.
 */
class MotionBuffer
{
 public:
  static constexpr std::size_t CAPACITY = 1024;
  static constexpr double SPACING = 0.004;        ///< [s]
  static constexpr double VELOCITY_WINDOW = 0.3;  ///< [s]

  MotionBuffer();

  /// What addPose(), addTwist() and addAttitude() would answer; nothing changes.
  Rejection checkPose(double t, const core::Vector3& position, const Eigen::Quaterniond& orientation) const;
  Rejection checkTwist(double t, const core::Vector3& velocity, const core::Vector3& angular_velocity) const;
  Rejection checkAttitude(double t, const Eigen::Quaterniond& orientation,
                          const std::optional<core::Vector3>& angular_velocity) const;
  /// Accepts a pose at time t [s]. The orientation is normalised.
  Rejection addPose(double t, const core::Vector3& position, const Eigen::Quaterniond& orientation);
  /// Accepts measured rates at time t [s], world axes.
  Rejection addTwist(double t, const core::Vector3& velocity, const core::Vector3& angular_velocity);
  /// Accepts an attitude at time t [s] of which no position is known. It is normalised.
  /// @param angular_velocity  world axes [rad/s]; none: from the attitudes.
  Rejection addAttitude(double t, const Eigen::Quaterniond& orientation,
                        const std::optional<core::Vector3>& angular_velocity = std::nullopt);
  void clear();
  /// Forgets the rates alone.
  void clearRates() { rates_.clear(); }

  bool hasPose() const { return !poses_.empty(); }
  /// True once a pose or an attitude has come.
  bool hasOrientation() const { return !poses_.empty() || !attitudes_.empty(); }
  /// True if something measures the rates at time t [s].
  bool hasRates(double t) const { return measuredRates(t).has_value(); }
  /// How far the measured rates that stand for time t [s] are from it [s]; 0 between two; infinite without any.
  double rateAge(double t) const;
  /// Age at time t of the last pose that is not later than t [s]; infinite without one.
  double age(double t) const;
  /// True if a pose at or after t is known, so that at(t) interpolates.
  bool canInterpolate(double t) const;
  /// Time from the pose before the last one that is not later than t to that one [s]; 0 if there are no two.
  double poseInterval(double t) const;
  /// The last orientation that came, for rates that are measured in body axes. Identity without one.
  Eigen::Quaterniond lastOrientation() const;
  /// Time of the last pose [s]; -infinity without one.
  double lastPoseTime() const;
  /// Orientation at time t [s]; identity if none has come.
  Eigen::Quaterniond orientationAt(double t) const;
  /// How far time t [s] is beyond the last pose [s]; 0 before it. hasPose() must hold.
  double extrapolation(double t) const { return std::max(0.0, t - poses_.back().t); }
  /// State at time t [s]; hasPose() must hold.
  BodyState at(double t) const;
  /// Position beyond the last pose at time t [s] by the poses alone, without the rates that were measured.
  core::Vector3 extrapolatedByPoses(double t) const;
  /// False for what no measurements can have made: for states that come from outside.
  bool isValid() const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(poses_, rates_, attitudes_);
  }

 private:
  struct Pose
  {
    double t;
    core::Vector3 position;
    Eigen::Quaterniond orientation;

    template <class Archive>
    void serialize(Archive& a)
    {
      a(t, position, orientation);
    }
  };
  struct Rates
  {
    double t;
    core::Vector3 velocity;
    core::Vector3 angular_velocity;

    template <class Archive>
    void serialize(Archive& a)
    {
      a(t, velocity, angular_velocity);
    }
  };
  struct Attitude
  {
    double t;
    Eigen::Quaterniond orientation;
    std::optional<core::Vector3> angular_velocity;

    template <class Archive>
    void serialize(Archive& a)
    {
      a(t, orientation, angular_velocity);
    }
  };
  struct Turning
  {
    Eigen::Quaterniond orientation;
    core::Vector3 angular_velocity;
  };
  struct Slope
  {
    core::Vector3 velocity;
    core::Vector3 angular_velocity;
  };

  std::optional<Rates> measuredRates(double t) const;
  std::optional<Turning> measuredTurning(double t) const;
  BodyState poseAt(double t) const;
  Slope ratesAt(std::size_t pose, double t) const;
  Slope slopeAt(std::size_t pose) const;

  std::vector<Pose> poses_;   // in order of time, at most CAPACITY
  std::vector<Rates> rates_;  // likewise
  std::vector<Attitude> attitudes_;
};

}  // namespace tether_monitor::monitor
