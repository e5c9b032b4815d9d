#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <optional>

#include "tether_monitor/monitor/measurements/implausibility.h"
#include "tether_monitor/monitor/measurements/motion_buffer.h"
#include "tether_monitor/monitor/measurements/noise_estimator.h"

namespace tether_monitor::monitor
{
/**
 * Whether the positions and velocities that are measured of one body can be those of one body.
 *
 * A position is held against where the track would be, in units of the scatter of the positions and of what a
 * vessel or a vehicle can accelerate; over a second, velocities are held against the displacement between the
 * positions. Plain data.
 */
class MotionPlausibility
{
 public:
  enum class Verdict
  {
    GOOD,
    DOUBTFUL,   ///< a leap: not to be used.
    REACQUIRED  ///< the last of so many doubtful ones in a row, all in one place: that is where the body is.
  };

  /**
   * Checks a position before it goes into the track.
   *
   * @param t      its stamp [s], later than the last pose of the track.
   * @param track  of the positions that were good.
   */
  Verdict check(double t, const core::Vector3& position, const MotionBuffer& track);
  /// Looks at a position that something else has checked for leaps: whether it repeats, and how much it scatters.
  /// Before it goes into the track.
  void watch(double t, const core::Vector3& position, const MotionBuffer& track);
  /**
   * Holds the velocity that was measured against the positions.
   *
   * @param here         where the body is at time t [m].
   * @param ahead        for how long `here` is an extrapolation of the positions [s]; 0: it is none. What the body
   * may have accelerated since is no contradiction.
   * @param velocity     in world axes [m/s].
   * @param orientation  of the body, with which body axes were turned into the world.
   */
  void compareVelocity(double t, const core::Vector3& here, double ahead, const core::Vector3& velocity,
                       const Eigen::Quaterniond& orientation);
  void clear() { *this = MotionPlausibility(); }

  /// Standard deviation of the scatter of the positions, the largest of the axes [m].
  double scatter() const;
  /// The same, 0 until it is known.
  double measuredScatter() const { return noise_[0].isKnown() ? scatter() : 0.0; }
  /// When a kind was last seen [s]; -infinity: never.
  double last(Implausibility what) const { return last_[static_cast<std::size_t>(what)]; }
  /// False while the velocity contradicts the positions.
  bool trustsVelocity() const { return trusts_velocity_; }
  /// True for what measurements can have made.
  bool isValid() const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(noise_, last_, leap_count_, leap_time_, leap_position_, repeated_since_, speed_before_, window_,
      trusts_velocity_);
  }

 private:
  static constexpr std::size_t KINDS = static_cast<std::size_t>(Implausibility::COUNT);
  // Displacements over a stretch of time, by the velocities: as measured, and with their axes turned once more,
  // back or on.
  struct Window
  {
    bool is_open = false;
    double began = 0.0, t = 0.0, unsure = 0.0;  // unsure: of where the body was when it began [m]
    core::Vector3 from = core::Vector3::Zero(), velocity = core::Vector3::Zero(),
                  displacement = core::Vector3::Zero();
    core::Vector3 turned_back = core::Vector3::Zero(), turned_on = core::Vector3::Zero();

    template <class Archive>
    void serialize(Archive& a)
    {
      a(is_open, began, t, unsure, from, velocity, displacement, turned_back, turned_on);
    }
  };
  double tolerance(double acceleration, double dt, const MotionBuffer& track, double t) const;
  bool fitsPoses(double t, const core::Vector3& position, const MotionBuffer& track) const;
  void watchRepeats(double t, const core::Vector3& position, const MotionBuffer& track);
  void note(Implausibility what, double t) { last_[static_cast<std::size_t>(what)] = t; }
  void checkWindow(const core::Vector3& displacement, double unsure);

  std::array<DifferenceNoiseEstimator, 3> noise_;
  std::array<double, KINDS> last_ = none();
  int leap_count_ = 0;
  double leap_time_ = 0.0;
  core::Vector3 leap_position_ = core::Vector3::Zero();
  double repeated_since_ = std::numeric_limits<double>::infinity(), speed_before_ = 0.0;
  Window window_;
  bool trusts_velocity_ = true;

  static std::array<double, KINDS> none()
  {
    std::array<double, KINDS> never{};
    never.fill(-std::numeric_limits<double>::infinity());
    return never;
  }
};

}  // namespace tether_monitor::monitor
