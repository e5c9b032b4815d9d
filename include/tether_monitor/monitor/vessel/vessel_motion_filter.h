#pragma once

#include <array>
#include <vector>

#include "tether_monitor/core/cable/end_trajectory.h"
#include "tether_monitor/monitor/measurements/correction_blender.h"
#include "tether_monitor/monitor/measurements/measured_vector.h"
#include "tether_monitor/monitor/measurements/noise_estimator.h"
#include "tether_monitor/monitor/measurements/rejection.h"
#include "tether_monitor/monitor/vessel/position_window.h"
#include "tether_monitor/monitor/vessel/vessel_axis_filters.h"

namespace tether_monitor::monitor
{
/**
 * Motion of the vessel's end of the tether out of noisy measurements: (E10)-(E13) of doc/theory/estimation.md.
 *
 * A position is that of the attachment: the caller adds the lever arm with the attitude of the moment. Every axis
 * has its own filter, so that satellite positions and a heave sensor can take turns. Measurements may come
 * late, early and out of order within some seconds: the filters are set back and run again. Allocates only in the
 * constructor.
 */
class VesselMotionFilter
{
 public:
  /// End of the tether at one time, and how sure that is; axes of the world.
  struct Motion
  {
    core::EndMotion end;
    core::Vector3 position_stddev = core::Vector3::Zero();      ///< [m]
    core::Vector3 acceleration_stddev = core::Vector3::Zero();  ///< [m/s^2]
  };

  static constexpr std::size_t CAPACITY = 1024;  ///< measurements that can be run again.

  VesselMotionFilter();

  /// What the next two would answer; nothing changes.
  Rejection checkPosition(double t, const MeasuredVector& position) const;
  Rejection checkVelocity(double t, const MeasuredVector& velocity) const;
  /// Accepts a position of the attachment at time t [s]; where its accuracy is unspecified, its own noise decides.
  Rejection addPosition(double t, const MeasuredVector& position);
  /// The same for its velocity [m/s].
  Rejection addVelocity(double t, const MeasuredVector& velocity);
  /// Begins with a known motion at time t [s], before anything is measured.
  void start(double t, const core::EndMotion& end, double position_stddev, double velocity_stddev);
  void clear();

  /// True when position and velocity are known well enough to begin.
  bool isReady(double t) const;
  /// True when every axis has been measured.
  bool hasPosition() const;
  /// Age at time t of the last measured position of the axis that has waited longest [s]; infinite before.
  double age(double t) const;
  /// At time t [s], from the measurements up to then: one that is stamped later does not count yet. hasPosition()
  /// must hold.
  Motion at(double t) const;
  /// The straight track of the last 20 s, without the motion in the waves, which the filters learn at once;
  /// isReady() must hold.
  core::EndMotion estimateTrack(double t);
  /// Standard deviation of the velocity that estimateTrack() has found [m/s].
  const core::Vector3& trackVelocityStddev() const { return track_velocity_stddev_; }
  /**
   * As at(), for a tether to blend: what a measurement corrects fades in, so that no correction is a shock to a
   * taut tether. Calls in order of t.
   */
  Motion blend(double t);
  /// Begins to blend at time t [s] on the straight track `from`; the rest of the motion comes on top within 14 s.
  void startBlending(double t, const core::EndMotion& from);
  /// True while not all of the motion is on top of the track yet.
  bool isRampingUp(double t) const;
  /// How fast the errors of a motion are [1/s].
  static double errorRate(const Motion& motion);
  const AxisKalmanFilter& axis(int i) const { return estimate_.axes[i]; }
  /// Measurements that were rejected as outliers.
  long outliers() const { return estimate_.outliers; }
  bool isValid() const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(estimate_, position_windows_, noise_, velocity_noise_, log_, snapshots_, last_measured_, last_output_,
      last_output_time_, correction_, fading_, left_square_, ramp_track_, track_velocity_stddev_, blending_since_);
  }

 private:
  using Entry = VesselMeasurement;
  using Filters = std::array<AxisKalmanFilter, 3>;
  struct Snapshot
  {
    double t = 0.0;
    VesselAxisFilters estimate;

    template <class Archive>
    void serialize(Archive& a)
    {
      a(t, estimate);
    }
  };

  static Entry entryOf(double t, bool is_velocity, const MeasuredVector& measured);
  Rejection check(const Entry& entry) const;
  Rejection add(const Entry& entry);
  void estimateNoise(Entry& entry);
  void makeRoom();
  void runAgainFrom(std::size_t index);
  void run(const Entry& entry);
  Filters filtersAt(double t) const;
  void pushSnapshot(double t);
  static Motion motionOf(const Filters& filters, double t);
  void fadeCorrection(const Filters& filters, const Motion& motion, const core::EndMotion& expected, double dt);
  void addCorrection(Motion& motion) const;
  void rampWaveMotion(double t, Motion& motion) const;

  VesselAxisFilters estimate_;  // after all of the log
  std::array<PositionWindow, 3> position_windows_;
  std::array<DifferenceNoiseEstimator, 3> noise_, velocity_noise_;
  std::vector<Entry> log_;           // in order of time
  std::vector<Snapshot> snapshots_;  // likewise: filters before the entries from t on
  std::array<double, 3> last_measured_;
  Filters last_output_;                                          // at the last blend()
  double last_output_time_ = 0.0;                                // time of it
  Correction<core::Vector3> correction_;                         // of what was shown from what is known
  core::Vector3 fading_ = core::Vector3::Zero();                 // of that, by axis [1/s]
  core::Vector3 left_square_ = core::Vector3::Zero();            // mean square of what is left of it [m^2]
  core::EndMotion ramp_track_;                                   // of the track that it began to blend
  core::Vector3 track_velocity_stddev_ = core::Vector3::Zero();  // of its velocity
  double blending_since_;
};

}  // namespace tether_monitor::monitor
