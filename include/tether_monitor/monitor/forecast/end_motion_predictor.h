#pragma once

#include <array>
#include <optional>

#include "tether_monitor/core/cable/end_trajectory.h"
#include "tether_monitor/monitor/ensemble/random_numbers.h"
#include "tether_monitor/monitor/forecast/vessel_plan.h"
#include "tether_monitor/monitor/measurements/correction_blender.h"
#include "tether_monitor/monitor/vessel/vessel_axis_filters.h"

namespace tether_monitor::monitor
{
/**
 * Learns from the motion that an end of the tether has made how it may go on: speed, turn rate and waves, (F1) of
 * doc/theory/forecast.md. Plain data: copy it to save it.
 */
class EndMotionPredictor
{
 public:
  /// @param floats  the end is that of a vessel: it does not climb but in the waves.
  explicit EndMotionPredictor(bool floats = true) : floats_(floats) {}

  /// The end at time t [s], world. A time that is not later, or later by a minute, begins anew.
  void observe(double t, const core::EndMotion& end);
  void clear() { *this = EndMotionPredictor(floats_); }
  /// True once it has been observed for ten seconds.
  bool isReady() const;
  bool isValid() const;
  double time() const { return filters_.axes[0].time(); }
  const AxisKalmanFilter& axis(int i) const { return filters_.axes[i]; }
  bool floats() const { return floats_; }
  /// Standard deviation of the low-frequency acceleration, across and up, as it has been [m/s^2].
  double accelerationStddev(int axis) const;
  /// How much there has been of the waves that the filter of an axis takes to be there [-], 0..1.
  double waveShare(int axis) const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(filters_, horizontal_square_, vertical_square_, velocity_mean_, velocity_square_, observed_for_);
  }

 private:
  bool isStarted() const { return filters_.axes[0].isStarted(); }
  void start(double t, const core::EndMotion& end);
  void learnAcceleration(double dt);

  bool floats_;
  VesselAxisFilters filters_;
  double horizontal_square_ = 0.0, vertical_square_ = 0.0;  // means of squared accelerations [m^2/s^4]
  core::Vector3 velocity_mean_ = core::Vector3::Zero(), velocity_square_ = core::Vector3::Zero();  // of a minute
  double observed_for_ = 0.0;                                                                      // [s]
};

/// What a helmsman is to do instead of going on as now.
struct MotionCommand
{
  std::optional<core::Vector3> velocity;  ///< of the low-frequency motion, world [m/s]; reached within seconds.
  std::optional<double> turn_rate;        ///< [rad/s], to the left positive; with a velocity, none if not given.
  const VesselPlan* plan = nullptr;       ///< followed where neither is given; must outlive its users.
};

/**
 * Possible continuations of a motion, in equal steps: the state of the predictor's filters is drawn from its
 * covariance, and its process noise goes on.
 */
class EndMotionSampler
{
 public:
  /// @param predictor  ready. @param now  where the end really is: what differs fades. @param step  [s], > 0.
  EndMotionSampler(const EndMotionPredictor& predictor, const core::EndMotion& now, double step,
                   const MotionCommand& command = MotionCommand());

  /// One continuation.
  struct Course
  {
    double t = 0.0;  ///< [s]
    std::array<AxisKalmanFilter::Vector, 3> axes;
    double turn_rate = 0.0;                           ///< [rad/s]
    core::Vector3 commanded = core::Vector3::Zero();  ///< velocity that is steered for, turned with the course.
    Correction<core::Vector3> offset;
  };
  Course begin(RandomNumbers& random) const;
  /// The next step. @return where the end is then.
  core::EndMotion advance(Course& course, RandomNumbers& random) const;

 private:
  using Matrix = AxisKalmanFilter::Matrix;
  bool followPlan(Course& course) const;
  void steer(Course& course) const;

  const EndMotionPredictor& predictor_;
  core::EndMotion now_;
  double step_;
  MotionCommand command_;
  std::array<Matrix, 3> transition_, noise_, spread_;  // the last two: square roots of covariances
  std::array<double, 3> liveliness_;                   // of the accelerations, over that of the filters
};

}  // namespace tether_monitor::monitor
