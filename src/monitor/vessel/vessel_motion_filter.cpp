#include "tether_monitor/monitor/vessel/vessel_motion_filter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tether_monitor::monitor
{
namespace
{
constexpr double SNAPSHOT_INTERVAL = 0.15;  // [s]
constexpr std::size_t SNAPSHOTS = 32;
constexpr double READY_SPEED = 0.3;     // standard deviation of the velocity to begin with [m/s]
constexpr double INITIAL_WINDOW = 9.5;  // [s] of recent positions to begin with
constexpr double SLOWEST_FADING = 0.3, FASTEST_FADING = 8.0;  // of a correction [1/s]
// Of a correction that may be left: [m], and standard deviations of the filter.
constexpr double LEAST_TOLERABLE = 0.02, TOLERABLE = 1.5;
constexpr double FADING_LEAD = 0.15;          // [s] in which its rate counts with it
constexpr double FADING_GAIN = 0.1;           // [1/s] at which fading gets faster, or slower
constexpr double MOST_EXCESS = 3.0;           // of the square of what is left over what may be
constexpr double LARGE_VARIANCE_RATIO = 3.0;  // squared innovations over what they should be: it does not predict
constexpr double MOST_BY_SURPRISE = 10.0;     // how much faster corrections fade then
constexpr double LEFT_MEMORY = 5.0;           // [s] of how much is left
constexpr double RAMP_DURATION = 14.0;        // [s] in which waves come on top of the track at the start
constexpr double SLOWEST_ERROR = 0.3, FASTEST_ERROR = 10.0;  // rates of errors [1/s]
constexpr double FASTEST_OWN_ERROR = 1.0;                    // of those of the filter itself

double sizeOf(const Correction<double>& left)
{
  return std::hypot(left.value, FADING_LEAD * left.rate);
}
}  // namespace

VesselMotionFilter::VesselMotionFilter()
{
  log_.reserve(CAPACITY);
  snapshots_.reserve(SNAPSHOTS);
  clear();
}

void VesselMotionFilter::clear()
{
  estimate_ = VesselAxisFilters();
  noise_ = velocity_noise_ = std::array<DifferenceNoiseEstimator, 3>();
  log_.clear();
  snapshots_.clear();
  last_measured_.fill(-std::numeric_limits<double>::infinity());
  for (PositionWindow& recent : position_windows_)
    recent.clear();
  track_velocity_stddev_.setZero();
  fading_.setConstant(SLOWEST_FADING);
  left_square_.setZero();
  blending_since_ = -std::numeric_limits<double>::infinity();
}

void VesselMotionFilter::start(double t, const core::EndMotion& end, double position_stddev,
                               double velocity_stddev)
{
  clear();
  for (int i = 0; i < 3; ++i)
  {
    estimate_.axes[i].start(t, end.position[i], position_stddev, end.velocity[i], velocity_stddev);
    last_measured_[i] = t;
  }
}

VesselMotionFilter::Entry VesselMotionFilter::entryOf(double t, bool is_velocity, const MeasuredVector& measured)
{
  Entry entry{t, is_velocity, measured.value()};
  for (int i = 0; i < 3; ++i)
  {
    if (!measured.isMeasured(i))
      entry.stddev[i] = std::numeric_limits<double>::infinity();
    else if (measured.accuracy(i) == Accuracy::SPECIFIED)
      entry.stddev[i] = measured.stddev(i);
  }
  return entry;
}

Rejection VesselMotionFilter::checkPosition(double t, const MeasuredVector& position) const
{
  return position.isValid() ? check(entryOf(t, false, position)) : Rejection::NOT_FINITE;
}

Rejection VesselMotionFilter::checkVelocity(double t, const MeasuredVector& velocity) const
{
  return velocity.isValid() ? check(entryOf(t, true, velocity)) : Rejection::NOT_FINITE;
}

Rejection VesselMotionFilter::addPosition(double t, const MeasuredVector& position)
{
  return position.isValid() ? add(entryOf(t, false, position)) : Rejection::NOT_FINITE;
}

Rejection VesselMotionFilter::addVelocity(double t, const MeasuredVector& velocity)
{
  return velocity.isValid() ? add(entryOf(t, true, velocity)) : Rejection::NOT_FINITE;
}

Rejection VesselMotionFilter::check(const Entry& entry) const
{
  if (!std::isfinite(entry.t))
    return Rejection::NOT_FINITE;
  for (auto e = log_.rbegin(); e != log_.rend() && e->t >= entry.t; ++e)
    if (e->t == entry.t && e->is_velocity == entry.is_velocity && e->value == entry.value)
      return Rejection::REPEATED;
  const bool is_late = !log_.empty() && entry.t < log_.back().t;
  return is_late && (snapshots_.empty() || entry.t < snapshots_.front().t) ? Rejection::TOO_LATE : Rejection::NONE;
}

// Gives the measured axes the accuracy that the data show where none is specified, and notes what was measured.
void VesselMotionFilter::estimateNoise(Entry& entry)
{
  std::array<DifferenceNoiseEstimator, 3>& noise = entry.is_velocity ? velocity_noise_ : noise_;
  for (int i = 0; i < 3; ++i)
  {
    if (!std::isfinite(entry.stddev[i]))
      continue;
    noise[i].add(entry.t, entry.value[i]);
    if (!(entry.stddev[i] > 0.0))
      entry.stddev[i] = noise[i].stddev();
    if (entry.is_velocity)
      continue;
    last_measured_[i] = std::max(last_measured_[i], entry.t);
    position_windows_[i].add({entry.t, entry.value[i], entry.stddev[i]});
  }
}

void VesselMotionFilter::makeRoom()
{
  if (log_.size() < CAPACITY)
    return;
  log_.erase(log_.begin(), log_.begin() + CAPACITY / 2);
  const auto first =
      std::find_if(snapshots_.begin(), snapshots_.end(), [&](const Snapshot& c) { return c.t >= log_.front().t; });
  snapshots_.erase(snapshots_.begin(), first);
}

Rejection VesselMotionFilter::add(const Entry& given)
{
  const Rejection rejection = check(given);
  if (rejection != Rejection::NONE)
    return rejection;
  Entry entry = given;
  const bool is_late = !log_.empty() && entry.t < log_.back().t;
  estimateNoise(entry);
  makeRoom();
  const auto place =
      std::upper_bound(log_.begin(), log_.end(), entry.t, [](double t, const Entry& e) { return t < e.t; });
  const std::size_t index = place - log_.begin();
  log_.insert(place, entry);
  if (is_late)
    runAgainFrom(index);
  else
    run(entry);
  return Rejection::NONE;
}

// Back to before an entry of the log, and again.
void VesselMotionFilter::runAgainFrom(std::size_t index)
{
  while (snapshots_.size() > 1 && snapshots_.back().t > log_[index].t)
    snapshots_.pop_back();
  estimate_ = snapshots_.back().estimate;
  const double from = snapshots_.back().t;
  snapshots_.pop_back();
  std::size_t first = index;
  while (first > 0 && log_[first - 1].t >= from)
    --first;
  for (std::size_t k = first; k < log_.size(); ++k)
    run(log_[k]);
}

void VesselMotionFilter::pushSnapshot(double t)
{
  if (snapshots_.size() == SNAPSHOTS)
    snapshots_.erase(snapshots_.begin(), snapshots_.begin() + SNAPSHOTS / 2);
  snapshots_.push_back({t, estimate_});
}

void VesselMotionFilter::run(const Entry& entry)
{
  if (snapshots_.empty() || snapshots_.back().t + SNAPSHOT_INTERVAL <= entry.t)
    pushSnapshot(entry.t);
  estimate_.apply(entry);
}

// The filters as they were before what is stamped later than t.
VesselMotionFilter::Filters VesselMotionFilter::filtersAt(double t) const
{
  const bool is_past = log_.empty() || log_.back().t <= t;
  const auto after =
      std::find_if(snapshots_.begin(), snapshots_.end(), [&](const Snapshot& s) { return s.t > t; });
  if (is_past || after == snapshots_.begin())
    return estimate_.axes;
  VesselAxisFilters then = std::prev(after)->estimate;
  const double from = std::prev(after)->t;
  const auto first =
      std::lower_bound(log_.begin(), log_.end(), from, [](const Entry& e, double x) { return e.t < x; });
  for (auto entry = first; entry != log_.end() && entry->t <= t; ++entry)
    then.apply(*entry);
  return then.axes;
}

bool VesselMotionFilter::hasPosition() const
{
  return std::all_of(estimate_.axes.begin(), estimate_.axes.end(),
                     [](const AxisKalmanFilter& f) { return f.isStarted(); });
}

bool VesselMotionFilter::isReady(double t) const
{
  if (!hasPosition())
    return false;
  for (const PositionWindow& recent : position_windows_)
    if (recent.span(t) < INITIAL_WINDOW)
      return false;
  return std::all_of(estimate_.axes.begin(), estimate_.axes.end(),
                     [](const AxisKalmanFilter& f) { return f.at(f.time()).velocity_stddev < READY_SPEED; });
}

double VesselMotionFilter::age(double t) const
{
  return std::max(t - *std::min_element(last_measured_.begin(), last_measured_.end()), 0.0);
}

VesselMotionFilter::Motion VesselMotionFilter::at(double t) const
{
  return motionOf(filtersAt(t), t);
}

void VesselMotionFilter::startBlending(double t, const core::EndMotion& from)
{
  correction_ = Correction<core::Vector3>();
  ramp_track_ = from;
  last_output_ = filtersAt(t);
  last_output_time_ = blending_since_ = t;
}

VesselMotionFilter::Motion VesselMotionFilter::blend(double t)
{
  const Filters now = filtersAt(t);
  Motion motion = motionOf(now, t);
  if (!(blending_since_ > -std::numeric_limits<double>::infinity()))
  {
    startBlending(t, motion.end);
    blending_since_ -= RAMP_DURATION;  // from the midst of the motion
  }
  const double dt = t - last_output_time_;
  if (dt > 0.0)
    fadeCorrection(now, motion, motionOf(last_output_, t).end, dt);
  last_output_ = now;
  last_output_time_ = t;
  addCorrection(motion);
  rampWaveMotion(t, motion);
  return motion;
}

// What the measurements of the last dt have changed, and its critically damped fading: so fast that little is
// left.
void VesselMotionFilter::fadeCorrection(const Filters& filters, const Motion& motion,
                                        const core::EndMotion& expected, double dt)
{
  for (int i = 0; i < 3; ++i)
  {
    Correction<double> axis{correction_.value[i], correction_.rate[i]};
    const double tolerable = std::max(TOLERABLE * motion.position_stddev[i], LEAST_TOLERABLE);
    const double excess = std::min(std::pow(sizeOf(axis) / tolerable, 2) - 1.0, MOST_EXCESS);
    fading_[i] = std::clamp(fading_[i] * std::exp(FADING_GAIN * dt * excess), SLOWEST_FADING, FASTEST_FADING);
    const double surprise = filters[i].innovationVarianceRatio() / LARGE_VARIANCE_RATIO;
    const double by_surprise = SLOWEST_FADING * std::clamp(surprise, 1.0, MOST_BY_SURPRISE);
    axis.fade(std::max(fading_[i], by_surprise), dt);
    correction_.value[i] = axis.value - (motion.end.position[i] - expected.position[i]);
    correction_.rate[i] = axis.rate - (motion.end.velocity[i] - expected.velocity[i]);
    const double left = sizeOf({correction_.value[i], correction_.rate[i]});
    left_square_[i] += (1.0 - std::exp(-dt / LEFT_MEMORY)) * (left * left - left_square_[i]);
  }
}

// What has not faded yet is known to be wrong: as much as in the last seconds.
void VesselMotionFilter::addCorrection(Motion& motion) const
{
  for (int i = 0; i < 3; ++i)
  {
    const double now = sizeOf({correction_.value[i], correction_.rate[i]});
    const double left = std::max(std::sqrt(left_square_[i]), 0.5 * now);
    const double own = motion.position_stddev[i];
    const double own_acceleration =
        std::min(motion.acceleration_stddev[i], FASTEST_OWN_ERROR * FASTEST_OWN_ERROR * own);
    motion.position_stddev[i] = std::hypot(own, left);
    motion.acceleration_stddev[i] = std::hypot(own_acceleration, fading_[i] * fading_[i] * left);
  }
  motion.end.position += correction_.value;
  motion.end.velocity += correction_.rate;
}

bool VesselMotionFilter::isRampingUp(double t) const
{
  return t - blending_since_ < RAMP_DURATION;
}

// What is not shown yet of the waves is known to be missing.
void VesselMotionFilter::rampWaveMotion(double t, Motion& motion) const
{
  if (!isRampingUp(t))
    return;
  const double x = std::max(0.0, (t - blending_since_) / RAMP_DURATION);
  const double share = x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
  const double rate = 30.0 * x * x * (1.0 - x) * (1.0 - x) / RAMP_DURATION;
  const core::Vector3 track = ramp_track_.position + (t - blending_since_) * ramp_track_.velocity;
  const core::Vector3 off = motion.end.position - track;
  motion.position_stddev =
      (motion.position_stddev.cwiseAbs2() + (1.0 - share) * (1.0 - share) * off.cwiseAbs2()).cwiseSqrt();
  motion.end.velocity = ramp_track_.velocity + share * (motion.end.velocity - ramp_track_.velocity) + rate * off;
  motion.end.position = track + share * off;
}

VesselMotionFilter::Motion VesselMotionFilter::motionOf(const Filters& filters, double t)
{
  Motion motion;
  for (int i = 0; i < 3; ++i)
  {
    const AxisKalmanFilter::Motion m =
        filters[i].at(std::clamp(t, filters[i].time(), filters[i].time() + VesselAxisFilters::LONGEST_GAP));
    motion.end.position[i] = m.position;
    motion.end.velocity[i] = m.velocity;
    motion.position_stddev[i] = m.position_stddev;
    motion.acceleration_stddev[i] = m.acceleration_stddev;
  }
  return motion;
}

core::EndMotion VesselMotionFilter::estimateTrack(double t)
{
  core::EndMotion end = at(t).end;
  track_velocity_stddev_.setConstant(VesselAxisFilters::INITIAL_VELOCITY_STDDEV);
  WaveProbabilities probabilities = uniformWavePrior();
  for (const int i : {2, 0, 1})
  {
    if (position_windows_[i].empty())
      continue;
    const TrackFit found = position_windows_[i].fit(t, i == 2, probabilities);  // no vessel rises for long
    if (i == 2)
      probabilities = found.probabilities;
    end.position[i] = found.position;
    end.velocity[i] = found.velocity;
    track_velocity_stddev_[i] = found.velocity_stddev;
    if (!(found.wave_frequency > 0.0))
      continue;
    estimate_.axes[i].setWaveModel(found.wave_frequency, found.wave_stddev);
    for (Snapshot& snapshot : snapshots_)
      snapshot.estimate.axes[i].setWaveModel(found.wave_frequency, found.wave_stddev);
  }
  return end;
}

double VesselMotionFilter::errorRate(const Motion& motion)
{
  return std::clamp(
      std::sqrt(motion.acceleration_stddev.maxCoeff() / std::max(motion.position_stddev.maxCoeff(), 1e-6)),
      SLOWEST_ERROR, FASTEST_ERROR);
}

bool VesselMotionFilter::isValid() const
{
  const auto areSound = [](const auto& list)
  { return std::all_of(list.begin(), list.end(), [](const auto& item) { return item.isValid(); }); };
  bool sound = log_.size() <= CAPACITY && snapshots_.size() <= SNAPSHOTS && areSound(estimate_.axes) &&
               areSound(last_output_) && areSound(position_windows_) && areSound(noise_) &&
               areSound(velocity_noise_) && std::isfinite(last_output_time_) && correction_.value.allFinite() &&
               fading_.minCoeff() >= SLOWEST_FADING && fading_.maxCoeff() <= FASTEST_FADING &&
               left_square_.minCoeff() >= 0.0 && left_square_.allFinite() && correction_.rate.allFinite() &&
               ramp_track_.position.allFinite() && ramp_track_.velocity.allFinite() &&
               track_velocity_stddev_.allFinite() && blending_since_ <= last_output_time_;
  for (std::size_t i = 0; i < log_.size(); ++i)
    sound = sound && std::isfinite(log_[i].t) && (i == 0 || log_[i].t >= log_[i - 1].t);
  for (std::size_t i = 0; i < snapshots_.size(); ++i)
    sound = sound && std::isfinite(snapshots_[i].t) && areSound(snapshots_[i].estimate.axes) &&
            (i == 0 || snapshots_[i].t >= snapshots_[i - 1].t);
  return sound;
}

}  // namespace tether_monitor::monitor
