#pragma once

#include <array>
#include <vector>

#include "tether_monitor/core/end_path.h"
#include "tether_monitor/monitor/axis_filter.h"
#include "tether_monitor/monitor/body_track.h"
#include "tether_monitor/monitor/scatter.h"
#include "tether_monitor/monitor/way_samples.h"

namespace tether_monitor::monitor
{
/**
 * Motion of the vessel's end of the tether out of noisy measurements: (E10)-(E13) of doc/estimation.md.
 *
 * A position is that of the attachment: the caller adds the lever arm with the attitude of the moment. Every axis
 * has its own filter, so that satellite positions and a heave sensor can take turns. Measurements may come late
 * and out of order within some seconds: the filters are set back and run again. Allocates only in the constructor.
 */
class VesselFilter
{
 public:
  /// End of the tether at one time, and how sure that is; axes of the world.
  struct Motion
  {
    core::EndPoint end;
    core::Vector3 position_stddev = core::Vector3::Zero();      ///< [m]
    core::Vector3 acceleration_stddev = core::Vector3::Zero();  ///< [m/s^2]
  };

  static constexpr std::size_t CAPACITY = 1024;  ///< measurements that can be run again.
  static constexpr double UNMEASURED = 100.0;    ///< a standard deviation from which an axis was not measured [m].

  VesselFilter();

  /**
   * Takes a position of the attachment at time t [s].
   *
   * @param stddev  of every axis [m]; NaN or 0: as its own scatter says; above UNMEASURED: not measured.
   */
  Rejection addPosition(double t, const core::Vector3& position, const core::Vector3& stddev);
  /// The same for its velocity [m/s].
  Rejection addVelocity(double t, const core::Vector3& velocity, const core::Vector3& stddev);
  /// Begins with a known motion at time t [s], before anything is measured.
  void start(double t, const core::EndPoint& end, double position_stddev, double velocity_stddev);
  void clear();

  /// True when position and velocity are known well enough to begin.
  bool isReady(double t) const;
  /// True when every axis has been measured.
  bool hasPosition() const;
  /// Age at time t of the last measured position of the axis that has waited longest [s]; infinite before.
  double age(double t) const;
  /// At time t [s]; hasPosition() must hold.
  Motion at(double t) const;
  /// The straight way of the last 20 s, without the motion in the waves, which the filters learn at once;
  /// isReady() must hold.
  core::EndPoint findWay(double t);
  /// Standard deviation of the velocity that findWay() has found [m/s].
  const core::Vector3& wayStddev() const { return way_stddev_; }
  /**
   * As at(), for a tether to follow: what a measurement corrects fades in, so that no correction is a shock to a
   * taut tether. Calls in order of t.
   */
  Motion follow(double t);
  /// Begins to follow at time t [s] on the straight way `from`; the rest of the motion comes on top within 14 s.
  void followFrom(double t, const core::EndPoint& from);
  /// True while not all of the motion is on top of the way yet.
  bool isRising(double t) const;
  /// How fast the errors of a motion are [1/s].
  static double errorRate(const Motion& motion);
  const AxisFilter& axis(int i) const { return filters_[i]; }
  /// Measurements that were far beyond what the filter could believe.
  long outliers() const { return outliers_; }
  bool isSound() const;

  template <class Archive>
  void archive(Archive& a)
  {
    a(filters_, recent_, scatter_, velocity_scatter_, log_, checkpoints_, last_measured_, outliers_, surprises_,
      shown_, shown_at_, offset_, begun_, way_stddev_, following_since_);
  }

 private:
  struct Entry
  {
    double t = 0.0;
    bool is_velocity = false;
    core::Vector3 value = core::Vector3::Zero();
    core::Vector3 stddev = core::Vector3::Zero();

    template <class Archive>
    void archive(Archive& a)
    {
      a(t, is_velocity, value, stddev);
    }
  };
  using Filters = std::array<AxisFilter, 3>;
  struct Checkpoint
  {
    double t = 0.0;
    Filters filters;
    std::array<int, 3> surprises{};

    template <class Archive>
    void archive(Archive& a)
    {
      a(t, filters, surprises);
    }
  };

  Rejection add(const Entry& entry);
  void run(const Entry& entry);
  void remember(double t);
  static Motion motionOf(const Filters& filters, double t);
  void riseFromTheWay(double t, Motion& motion) const;

  Filters filters_;
  std::array<WaySamples, 3> recent_;
  std::array<Scatter, 3> scatter_, velocity_scatter_;
  std::vector<Entry> log_;               // in order of time
  std::vector<Checkpoint> checkpoints_;  // likewise: filters before the entries from t on
  std::array<double, 3> last_measured_;
  long outliers_ = 0;
  std::array<int, 3> surprises_{};
  Filters shown_;                                     // at the last follow()
  double shown_at_ = 0.0;                             // time of it
  core::EndPoint offset_;                             // of what was shown from what is known
  core::EndPoint begun_;                              // of the way that it began to follow
  core::Vector3 way_stddev_ = core::Vector3::Zero();  // of its velocity
  double following_since_;
};

}  // namespace tether_monitor::monitor
