#include "tether_monitor/monitor/vessel_filter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tether_monitor::monitor
{
namespace
{
constexpr double CHECKPOINT_EVERY = 0.15;  // [s]
constexpr std::size_t CHECKPOINTS = 32;
constexpr double GATE = 6.0;                       // standard deviations: farther is an outlier
constexpr int CONVINCED = 4;                       // so many outliers in a row are the truth
constexpr double FASTEST_VESSEL = 20.0;            // [m/s]
constexpr double SPEED_DOUBT = 5.0;                // standard deviation of a velocity that nobody knows [m/s]
constexpr double READY_SPEED = 0.3;                // standard deviation of the velocity to begin with [m/s]
constexpr double FIRST_LOOK = 9.5;                 // [s] of recent positions to begin with
constexpr double FADING = 0.3;                     // rate at which a correction fades [1/s]
constexpr double RESTLESS = 3.0;                   // squared innovations over what they should be that mean so
constexpr double FASTEST_FADING = 10.0;            // factor on it then
constexpr double WAVES_RISE = 14.0;                // [s] in which waves come on top of the way at the start
constexpr double MANOEUVRE = 0.015, TIDE = 0.001;  // acceleration of the way, across and up [m/s^2]
constexpr double FASTEST_ERROR = 1.0;              // rate of the errors that fading leaves [1/s]
constexpr double LONGEST_GAP = 60.0;               // [s]; after it a filter begins anew
}  // namespace

VesselFilter::VesselFilter()
{
  log_.reserve(CAPACITY);
  checkpoints_.reserve(CHECKPOINTS);
  clear();
}

void VesselFilter::clear()
{
  filters_ = {AxisFilter(MANOEUVRE), AxisFilter(MANOEUVRE), AxisFilter(TIDE)};
  scatter_ = velocity_scatter_ = std::array<Scatter, 3>();
  log_.clear();
  checkpoints_.clear();
  last_measured_.fill(-std::numeric_limits<double>::infinity());
  surprises_ = {};
  for (WaySamples& recent : recent_)
    recent.clear();
  way_stddev_.setZero();
  following_since_ = -std::numeric_limits<double>::infinity();
}

void VesselFilter::start(double t, const core::EndPoint& end, double position_stddev, double velocity_stddev)
{
  clear();
  for (int i = 0; i < 3; ++i)
  {
    filters_[i].start(t, end.position[i], position_stddev, end.velocity[i], velocity_stddev);
    last_measured_[i] = t;
  }
}

Rejection VesselFilter::addPosition(double t, const core::Vector3& position, const core::Vector3& stddev)
{
  return add({t, false, position, stddev});
}

Rejection VesselFilter::addVelocity(double t, const core::Vector3& velocity, const core::Vector3& stddev)
{
  return add({t, true, velocity, stddev});
}

Rejection VesselFilter::add(const Entry& told)
{
  Entry entry = told;
  std::array<Scatter, 3>& scatter = entry.is_velocity ? velocity_scatter_ : scatter_;
  for (int i = 0; i < 3; ++i)
  {
    const bool is_measured = !(entry.stddev[i] > UNMEASURED);
    if (std::isnan(entry.stddev[i]))
      entry.stddev[i] = 0.0;
    if (is_measured && !std::isfinite(entry.value[i]))
      return Rejection::NOT_FINITE;
    if (!is_measured)
      entry.stddev[i] = std::numeric_limits<double>::infinity();
  }
  if (!std::isfinite(entry.t))
    return Rejection::NOT_FINITE;
  for (auto e = log_.rbegin(); e != log_.rend() && e->t >= entry.t; ++e)
    if (e->t == entry.t && e->is_velocity == entry.is_velocity && e->value == entry.value)
      return Rejection::REPEATED;
  const bool is_late = !log_.empty() && entry.t < log_.back().t;
  if (is_late && (checkpoints_.empty() || entry.t < checkpoints_.front().t))
    return Rejection::TOO_LATE;
  for (int i = 0; i < 3; ++i)
    if (std::isfinite(entry.stddev[i]))
    {
      scatter[i].add(entry.t, entry.value[i]);
      if (!(entry.stddev[i] > 0.0))
        entry.stddev[i] = scatter[i].stddev();
      if (entry.is_velocity)
        continue;
      last_measured_[i] = std::max(last_measured_[i], entry.t);
      recent_[i].add({entry.t, entry.value[i], entry.stddev[i]});
    }
  if (log_.size() == CAPACITY)
  {
    log_.erase(log_.begin(), log_.begin() + CAPACITY / 2);
    const auto first = std::find_if(checkpoints_.begin(), checkpoints_.end(),
                                    [&](const Checkpoint& c) { return c.t >= log_.front().t; });
    checkpoints_.erase(checkpoints_.begin(), first);
  }
  const auto place =
      std::upper_bound(log_.begin(), log_.end(), entry.t, [](double t, const Entry& e) { return t < e.t; });
  const std::size_t index = place - log_.begin();
  log_.insert(place, entry);
  if (!is_late)
  {
    run(entry);
    return Rejection::NONE;
  }
  // Back to before it, and again.
  while (checkpoints_.size() > 1 && checkpoints_.back().t > entry.t)
    checkpoints_.pop_back();
  filters_ = checkpoints_.back().filters;
  surprises_ = checkpoints_.back().surprises;
  const double from = checkpoints_.back().t;
  checkpoints_.pop_back();
  std::size_t first = index;
  while (first > 0 && log_[first - 1].t >= from)
    --first;
  for (std::size_t k = first; k < log_.size(); ++k)
    run(log_[k]);
  return Rejection::NONE;
}

void VesselFilter::remember(double t)
{
  if (checkpoints_.size() == CHECKPOINTS)
    checkpoints_.erase(checkpoints_.begin(), checkpoints_.begin() + CHECKPOINTS / 2);
  checkpoints_.push_back({t, filters_, surprises_});
}

void VesselFilter::run(const Entry& entry)
{
  if (checkpoints_.empty() || checkpoints_.back().t + CHECKPOINT_EVERY <= entry.t)
    remember(entry.t);
  for (int i = 0; i < 3; ++i)
  {
    AxisFilter& filter = filters_[i];
    if (!std::isfinite(entry.stddev[i]))
      continue;
    if (!filter.isStarted() || entry.t - filter.time() > LONGEST_GAP)
    {
      if (!entry.is_velocity)
        filter.start(entry.t, entry.value[i], entry.stddev[i], 0.0, SPEED_DOUBT);
      continue;
    }
    filter.predict(entry.t);
    if (entry.is_velocity)
    {
      const bool is_good = std::abs(filter.velocitySurprise(entry.value[i], entry.stddev[i])) < GATE;
      if (is_good)
        filter.correctVelocity(entry.value[i], entry.stddev[i]);
      outliers_ += is_good ? 0 : 1;
      continue;
    }
    const double surprise = filter.surprise(entry.value[i], entry.stddev[i]);
    if (std::abs(surprise) < GATE)
    {
      surprises_[i] = 0;
      filter.correctPosition(entry.value[i], entry.stddev[i]);
    }
    else if (++surprises_[i] >= CONVINCED)
    {
      surprises_[i] = 0;
      filter.note(surprise);
      const double velocity = filter.at(entry.t).velocity;
      const bool is_usable = std::abs(velocity) < FASTEST_VESSEL;
      filter.start(entry.t, entry.value[i], entry.stddev[i], is_usable ? velocity : 0.0,
                   is_usable ? 1.0 : SPEED_DOUBT);
    }
    else
    {
      ++outliers_;
      if (surprises_[i] > 1)
        filter.note(surprise);
    }
  }
}

bool VesselFilter::hasPosition() const
{
  return std::all_of(filters_.begin(), filters_.end(), [](const AxisFilter& f) { return f.isStarted(); });
}

bool VesselFilter::isReady(double t) const
{
  if (!hasPosition())
    return false;
  for (const WaySamples& recent : recent_)
    if (recent.span(t) < FIRST_LOOK)
      return false;
  return std::all_of(filters_.begin(), filters_.end(),
                     [](const AxisFilter& f) { return f.at(f.time()).velocity_stddev < READY_SPEED; });
}

double VesselFilter::age(double t) const
{
  return t - *std::min_element(last_measured_.begin(), last_measured_.end());
}

VesselFilter::Motion VesselFilter::at(double t) const
{
  return motionOf(filters_, t);
}

void VesselFilter::followFrom(double t, const core::EndPoint& from)
{
  offset_ = core::EndPoint();
  begun_ = from;
  shown_ = filters_;
  shown_at_ = following_since_ = t;
}

VesselFilter::Motion VesselFilter::follow(double t)
{
  Motion motion = at(t);
  if (!(following_since_ > -std::numeric_limits<double>::infinity()))
  {
    followFrom(t, motion.end);
    following_since_ -= WAVES_RISE;  // from the midst of the motion
  }
  const double dt = t - shown_at_;
  if (dt > 0.0)
  {
    // What the measurements since then have changed, and its critically damped fading.
    const core::EndPoint expected = motionOf(shown_, t).end;
    // An axis that its filter does not predict has to be followed faster.
    for (int i = 0; i < 3; ++i)
    {
      const double w = FADING * std::clamp(filters_[i].restlessness() / RESTLESS, 1.0, FASTEST_FADING);
      const double decay = std::exp(-w * dt), drive = offset_.velocity[i] + w * offset_.position[i];
      offset_.position[i] =
          decay * (offset_.position[i] + dt * drive) - (motion.end.position[i] - expected.position[i]);
      offset_.velocity[i] =
          decay * (offset_.velocity[i] - w * dt * drive) - (motion.end.velocity[i] - expected.velocity[i]);
    }
  }
  shown_ = filters_;
  shown_at_ = t;
  motion.end.position += offset_.position;
  motion.end.velocity += offset_.velocity;
  riseFromTheWay(t, motion);
  return motion;
}

bool VesselFilter::isRising(double t) const
{
  return t - following_since_ < WAVES_RISE;
}

// What is not shown yet of the waves is known to be missing.
void VesselFilter::riseFromTheWay(double t, Motion& motion) const
{
  if (!isRising(t))
    return;
  const double x = std::max(0.0, (t - following_since_) / WAVES_RISE);
  const double share = x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
  const double rate = 30.0 * x * x * (1.0 - x) * (1.0 - x) / WAVES_RISE;
  const core::Vector3 way = begun_.position + (t - following_since_) * begun_.velocity;
  const core::Vector3 off = motion.end.position - way;
  motion.position_stddev =
      (motion.position_stddev.cwiseAbs2() + (1.0 - share) * (1.0 - share) * off.cwiseAbs2()).cwiseSqrt();
  motion.end.velocity = begun_.velocity + share * (motion.end.velocity - begun_.velocity) + rate * off;
  motion.end.position = way + share * off;
}

VesselFilter::Motion VesselFilter::motionOf(const Filters& filters, double t)
{
  Motion motion;
  for (int i = 0; i < 3; ++i)
  {
    const AxisFilter::Motion m = filters[i].at(std::clamp(t, filters[i].time(), filters[i].time() + LONGEST_GAP));
    motion.end.position[i] = m.position;
    motion.end.velocity[i] = m.velocity;
    motion.position_stddev[i] = m.position_stddev;
    motion.acceleration_stddev[i] = m.acceleration_stddev;
  }
  return motion;
}

core::EndPoint VesselFilter::findWay(double t)
{
  core::EndPoint end = at(t).end;
  way_stddev_.setConstant(SPEED_DOUBT);
  WaveOdds odds = anyWave();
  for (const int i : {2, 0, 1})
  {
    if (recent_[i].empty())
      continue;
    const Way found = recent_[i].fit(t, i == 2, odds);  // no vessel rises for long
    if (i == 2)
      odds = found.odds;
    end.position[i] = found.position;
    end.velocity[i] = found.velocity;
    way_stddev_[i] = found.velocity_stddev;
    if (!(found.wave_rate > 0.0))
      continue;
    filters_[i].expectWaves(found.wave_rate, found.wave_height);
    for (Checkpoint& checkpoint : checkpoints_)
      checkpoint.filters[i].expectWaves(found.wave_rate, found.wave_height);
  }
  return end;
}

double VesselFilter::errorRate(const Motion& motion)
{
  return std::clamp(
      std::sqrt(motion.acceleration_stddev.maxCoeff() / std::max(motion.position_stddev.maxCoeff(), 1e-6)), 0.3,
      FASTEST_ERROR);
}

bool VesselFilter::isSound() const
{
  const auto areSound = [](const auto& list)
  { return std::all_of(list.begin(), list.end(), [](const auto& item) { return item.isSound(); }); };
  bool sound = log_.size() <= CAPACITY && checkpoints_.size() <= CHECKPOINTS && areSound(filters_) &&
               areSound(shown_) && areSound(recent_) && areSound(scatter_) && areSound(velocity_scatter_) &&
               std::isfinite(shown_at_) && offset_.position.allFinite() && offset_.velocity.allFinite() &&
               begun_.position.allFinite() && begun_.velocity.allFinite() && way_stddev_.allFinite() &&
               following_since_ <= shown_at_;
  for (std::size_t i = 0; i < log_.size(); ++i)
    sound = sound && std::isfinite(log_[i].t) && (i == 0 || log_[i].t >= log_[i - 1].t);
  for (std::size_t i = 0; i < checkpoints_.size(); ++i)
    sound = sound && std::isfinite(checkpoints_[i].t) && areSound(checkpoints_[i].filters) &&
            (i == 0 || checkpoints_[i].t >= checkpoints_[i - 1].t);
  return sound;
}

}  // namespace tether_monitor::monitor
