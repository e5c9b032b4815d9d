#include "tether_monitor/monitor/measurements/motion_plausibility.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double UNKNOWN_SCATTER = 0.5;  // before it has been measured [m]
constexpr double LEAST_LEAP = 0.02;      // [m]
constexpr double SCATTERS = 8.0;         // standard deviations of the scatter that a position may be off
constexpr double HORIZONTAL_ACCELERATION = 3.0,
                 VERTICAL_ACCELERATION = 6.0;  // of a vessel's side in a seaway, of a vehicle [m/s^2]
constexpr double FASTEST = 20.0;               // of a body whose velocity is not known yet [m/s]
constexpr double LONGEST_PREDICTION = 5.0;     // [s]; beyond, a body may be anywhere
constexpr int LEAPS_BELIEVED = 4;              // so many in a row in one place are the truth
constexpr double SLOWEST_MOTION = 0.05;        // [m/s]
constexpr double LONGEST_REPEAT = 0.3;         // [s]
constexpr double WINDOW = 0.8;                 // [s] over which a velocity is held against the positions
constexpr double LONGEST_STEP = 0.5;           // [s] between velocities
constexpr double VELOCITY_SHARE = 0.1, VELOCITY_OFF = 0.1;  // of the displacement, [m/s]: a velocity may be off
constexpr double FITS = 0.5;  // of the displacement: so much nearer are other axes, if it is them
}  // namespace

double MotionPlausibility::scatter() const
{
  return std::max({noise_[0].stddev(), noise_[1].stddev(), noise_[2].stddev()});
}

double MotionPlausibility::tolerance(double acceleration, double dt, const MotionBuffer& track, double t) const
{
  const double lag = track.hasRates(t) ? 0.5 * dt + track.rateAge(track.lastPoseTime())
                                       : 0.5 * (dt + MotionBuffer::VELOCITY_WINDOW + track.poseInterval(t));
  const double unknown = track.hasRates(t) || track.poseInterval(t) > 0.0 ? 0.0 : FASTEST;
  const double scattered = noise_[0].isKnown() ? scatter() : UNKNOWN_SCATTER;
  return LEAST_LEAP + SCATTERS * scattered + (acceleration * lag + unknown) * dt;
}

void MotionPlausibility::watchRepeats(double t, const core::Vector3& position, const MotionBuffer& track)
{
  const BodyState before = track.at(track.lastPoseTime());
  if (position != before.position)
  {
    repeated_since_ = std::numeric_limits<double>::infinity();
    return;
  }
  if (!(repeated_since_ <= t))
  {
    repeated_since_ = track.lastPoseTime();
    speed_before_ = before.velocity.norm();
  }
  const bool was_moving = std::max(speed_before_, before.velocity.norm()) > SLOWEST_MOTION;
  if (was_moving && t - repeated_since_ > LONGEST_REPEAT)
    note(Implausibility::FROZEN_POSITION, t);
}

// Whether a position goes on from the poses alone.
bool MotionPlausibility::fitsPoses(double t, const core::Vector3& position, const MotionBuffer& track) const
{
  const double dt = t - track.lastPoseTime();
  const double lag = 0.5 * (dt + MotionBuffer::VELOCITY_WINDOW + track.poseInterval(t));
  const core::Vector3 off = position - track.extrapolatedByPoses(t);
  return off.norm() < LEAST_LEAP + SCATTERS * scatter() + VERTICAL_ACCELERATION * lag * dt;
}

MotionPlausibility::Verdict MotionPlausibility::check(double t, const core::Vector3& position,
                                                      const MotionBuffer& track)
{
  const double dt = track.hasPose() ? t - track.lastPoseTime() : LONGEST_PREDICTION;
  Verdict verdict = Verdict::GOOD;
  if (dt < LONGEST_PREDICTION)
  {
    watchRepeats(t, position, track);
    const BodyState expected = track.at(t);
    const core::Vector3 off = position - expected.position;
    // Nearer to where it leapt than to where it was: a leap goes on, however much may have happened since it
    // began.
    const core::Vector3 from_leap = position - leap_position_ - (t - leap_time_) * expected.velocity;
    const bool stays_there = leap_count_ > 0 && from_leap.norm() < 0.5 * off.norm();
    const double most = tolerance(HORIZONTAL_ACCELERATION, dt, track, t);
    const bool is_off = stays_there || off.head<2>().norm() > most ||
                        std::abs(off.z()) > tolerance(VERTICAL_ACCELERATION, dt, track, t);
    if (is_off && leap_count_ == 0 && track.hasRates(t) && fitsPoses(t, position, track))
    {
      // The positions go on as they did: it is the velocity that has changed.
      trusts_velocity_ = false;
      window_.is_open = false;
      note(Implausibility::CONTRADICTORY_VELOCITY, t);
    }
    else if (is_off)
    {
      const bool goes_on = stays_there || (leap_count_ > 0 &&
                                           (position - leap_position_).norm() < most + FASTEST * (t - leap_time_));
      leap_count_ = goes_on ? leap_count_ + 1 : 1;
      leap_time_ = t;
      leap_position_ = position;
      note(Implausibility::LEAP, t);
      verdict = leap_count_ < LEAPS_BELIEVED ? Verdict::DOUBTFUL : Verdict::REACQUIRED;
    }
  }
  if (verdict == Verdict::DOUBTFUL)
    return verdict;
  leap_count_ = 0;
  if (verdict == Verdict::REACQUIRED)
  {
    window_.is_open = false;
    note(Implausibility::RELOCATION, t);
  }
  for (int i = 0; i < 3; ++i)
    noise_[i].add(t, position[i]);
  return verdict;
}

void MotionPlausibility::watch(double t, const core::Vector3& position, const MotionBuffer& track)
{
  if (track.hasPose() && t - track.lastPoseTime() < LONGEST_PREDICTION)
    watchRepeats(t, position, track);
  for (int i = 0; i < 3; ++i)
    noise_[i].add(t, position[i]);
}

void MotionPlausibility::compareVelocity(double t, const core::Vector3& here, double ahead,
                                         const core::Vector3& velocity, const Eigen::Quaterniond& orientation)
{
  const double unsure = 0.5 * HORIZONTAL_ACCELERATION * ahead * ahead;
  if (!window_.is_open || !(t > window_.t) || t - window_.t > LONGEST_STEP)
  {
    window_ = Window();
    window_.is_open = true;
    window_.began = window_.t = t;
    window_.unsure = unsure;
    window_.from = here;
    window_.velocity = velocity;
    return;
  }
  const core::Vector3 step = 0.5 * (t - window_.t) * (window_.velocity + velocity);
  window_.displacement += step;
  window_.turned_back += orientation.conjugate() * step;
  window_.turned_on += orientation * step;
  window_.t = t;
  window_.velocity = velocity;
  if (t - window_.began < WINDOW)
    return;
  checkWindow(here - window_.from, window_.unsure + unsure);
  window_.is_open = false;
}

void MotionPlausibility::checkWindow(const core::Vector3& displacement, double unsure)
{
  const double duration = window_.t - window_.began;
  const double most =
      VELOCITY_OFF * duration + VELOCITY_SHARE * displacement.norm() + SCATTERS * scatter() + unsure;
  const double off = (displacement - window_.displacement).norm();
  trusts_velocity_ = off <= most;
  if (trusts_velocity_)
    return;
  const auto fits = [&](const core::Vector3& other)
  { return (displacement - other).norm() <= std::max(most, FITS * off); };
  const bool back = fits(window_.turned_back), on = fits(window_.turned_on);
  note(back && !on   ? Implausibility::VELOCITY_IN_WORLD_AXES
       : on && !back ? Implausibility::VELOCITY_IN_BODY_AXES
                     : Implausibility::CONTRADICTORY_VELOCITY,
       window_.t);
}

bool MotionPlausibility::isValid() const
{
  bool sound = leap_position_.allFinite() && leap_count_ >= 0 && std::isfinite(leap_time_) &&
               window_.displacement.allFinite() && window_.from.allFinite() && std::isfinite(window_.t) &&
               std::isfinite(window_.unsure);
  for (const DifferenceNoiseEstimator& noise : noise_)
    sound = sound && noise.isValid();
  return sound;
}

}  // namespace tether_monitor::monitor
