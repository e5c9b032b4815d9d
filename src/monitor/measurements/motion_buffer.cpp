#include "tether_monitor/monitor/measurements/motion_buffer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tether_monitor::monitor
{
namespace
{
constexpr double RATES_REACH = 0.5;     // [s] over which a measured rate may stand for another time
constexpr double ATTITUDE_REACH = 0.5;  // [s] over which an attitude goes on turning
constexpr double UNIT_TOLERANCE = 0.01;

// Keeps a full buffer from growing: what comes too fast takes the place of the last, else the older half goes.
template <typename T>
void makeRoom(std::vector<T>& buffer)
{
  const std::size_t n = buffer.size();
  if (n >= 2 && buffer[n - 1].t - buffer[n - 2].t < MotionBuffer::SPACING)
    buffer.pop_back();
  else if (n == MotionBuffer::CAPACITY)
    buffer.erase(buffer.begin(), buffer.begin() + MotionBuffer::CAPACITY / 2);
}

core::Vector3 rotationRate(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to, double duration)
{
  Eigen::Quaterniond turn = to * from.conjugate();
  if (turn.w() < 0.0)
    turn.coeffs() *= -1.0;
  const double sine = turn.vec().norm();
  if (sine < 1e-12)
    return core::Vector3::Zero();
  return turn.vec() * (2.0 * std::atan2(sine, turn.w()) / (sine * duration));
}

Eigen::Quaterniond turned(const Eigen::Quaterniond& from, const core::Vector3& rate, double duration)
{
  const double angle = rate.norm() * duration;
  if (std::abs(angle) < 1e-12)
    return from;
  return (Eigen::Quaterniond(Eigen::AngleAxisd(angle, rate.normalized())) * from).normalized();
}

Rejection checkOrientation(double t, const Eigen::Quaterniond& orientation)
{
  if (!std::isfinite(t) || !orientation.coeffs().allFinite())
    return Rejection::NOT_FINITE;
  return std::abs(orientation.norm() - 1.0) > UNIT_TOLERANCE ? Rejection::BAD_QUATERNION : Rejection::NONE;
}
}  // namespace

MotionBuffer::MotionBuffer()
{
  poses_.reserve(CAPACITY);
  rates_.reserve(CAPACITY);
  attitudes_.reserve(CAPACITY);
}

Rejection MotionBuffer::checkPose(double t, const core::Vector3& position,
                                  const Eigen::Quaterniond& orientation) const
{
  const Rejection rejection = position.allFinite() ? checkOrientation(t, orientation) : Rejection::NOT_FINITE;
  if (rejection != Rejection::NONE)
    return rejection;
  return !poses_.empty() && t <= poses_.back().t ? Rejection::OUT_OF_ORDER : Rejection::NONE;
}

Rejection MotionBuffer::checkTwist(double t, const core::Vector3& velocity,
                                   const core::Vector3& angular_velocity) const
{
  if (!std::isfinite(t) || !velocity.allFinite() || !angular_velocity.allFinite())
    return Rejection::NOT_FINITE;
  return !rates_.empty() && t <= rates_.back().t ? Rejection::OUT_OF_ORDER : Rejection::NONE;
}

Rejection MotionBuffer::addPose(double t, const core::Vector3& position, const Eigen::Quaterniond& orientation)
{
  const Rejection rejection = checkPose(t, position, orientation);
  if (rejection != Rejection::NONE)
    return rejection;
  makeRoom(poses_);
  poses_.push_back({t, position, orientation.normalized()});
  return Rejection::NONE;
}

Rejection MotionBuffer::addTwist(double t, const core::Vector3& velocity, const core::Vector3& angular_velocity)
{
  const Rejection rejection = checkTwist(t, velocity, angular_velocity);
  if (rejection != Rejection::NONE)
    return rejection;
  makeRoom(rates_);
  rates_.push_back({t, velocity, angular_velocity});
  return Rejection::NONE;
}

Rejection MotionBuffer::checkAttitude(double t, const Eigen::Quaterniond& orientation,
                                      const std::optional<core::Vector3>& angular_velocity) const
{
  const bool is_finite = !angular_velocity || angular_velocity->allFinite();
  const Rejection rejection = is_finite ? checkOrientation(t, orientation) : Rejection::NOT_FINITE;
  if (rejection != Rejection::NONE)
    return rejection;
  return !attitudes_.empty() && t <= attitudes_.back().t ? Rejection::OUT_OF_ORDER : Rejection::NONE;
}

Rejection MotionBuffer::addAttitude(double t, const Eigen::Quaterniond& orientation,
                                    const std::optional<core::Vector3>& angular_velocity)
{
  const Rejection rejection = checkAttitude(t, orientation, angular_velocity);
  if (rejection != Rejection::NONE)
    return rejection;
  makeRoom(attitudes_);
  attitudes_.push_back({t, orientation.normalized(), angular_velocity});
  return Rejection::NONE;
}

void MotionBuffer::clear()
{
  poses_.clear();
  rates_.clear();
  attitudes_.clear();
}

double MotionBuffer::age(double t) const
{
  const auto after =
      std::upper_bound(poses_.begin(), poses_.end(), t, [](double x, const Pose& p) { return x < p.t; });
  return after == poses_.begin() ? std::numeric_limits<double>::infinity() : t - std::prev(after)->t;
}

double MotionBuffer::poseInterval(double t) const
{
  const auto after =
      std::upper_bound(poses_.begin(), poses_.end(), t, [](double x, const Pose& p) { return x < p.t; });
  return after - poses_.begin() < 2 ? 0.0 : std::prev(after)->t - std::prev(after, 2)->t;
}

double MotionBuffer::rateAge(double t) const
{
  if (rates_.empty())
    return std::numeric_limits<double>::infinity();
  return std::max({0.0, t - rates_.back().t, rates_.front().t - t});
}

bool MotionBuffer::canInterpolate(double t) const
{
  return !poses_.empty() && poses_.back().t >= t;
}

Eigen::Quaterniond MotionBuffer::lastOrientation() const
{
  const bool is_attitude = !attitudes_.empty() && attitudes_.back().t >= lastPoseTime();
  if (is_attitude)
    return attitudes_.back().orientation;
  return poses_.empty() ? Eigen::Quaterniond::Identity() : poses_.back().orientation;
}

double MotionBuffer::lastPoseTime() const
{
  return poses_.empty() ? -std::numeric_limits<double>::infinity() : poses_.back().t;
}

std::optional<MotionBuffer::Rates> MotionBuffer::measuredRates(double t) const
{
  if (rates_.empty())
    return std::nullopt;
  const auto after =
      std::lower_bound(rates_.begin(), rates_.end(), t, [](const Rates& r, double x) { return r.t < x; });
  if (after == rates_.end())
    return t - rates_.back().t <= RATES_REACH ? std::optional<Rates>(rates_.back()) : std::nullopt;
  if (after == rates_.begin())
    return after->t - t <= RATES_REACH ? std::optional<Rates>(*after) : std::nullopt;
  const Rates& lo = *std::prev(after);
  if (after->t - lo.t > 2.0 * RATES_REACH)
    return std::nullopt;
  const double x = (t - lo.t) / (after->t - lo.t);
  return Rates{t, lo.velocity + x * (after->velocity - lo.velocity),
               lo.angular_velocity + x * (after->angular_velocity - lo.angular_velocity)};
}

MotionBuffer::Slope MotionBuffer::ratesAt(std::size_t pose, double t) const
{
  if (const std::optional<Rates> measured = measuredRates(t))
    return {measured->velocity, measured->angular_velocity};
  return slopeAt(pose);
}

core::Vector3 MotionBuffer::extrapolatedByPoses(double t) const
{
  return poses_.back().position + (t - poses_.back().t) * slopeAt(poses_.size() - 1).velocity;
}

MotionBuffer::Slope MotionBuffer::slopeAt(std::size_t pose) const
{
  if (poses_.size() < 2)
    return {core::Vector3::Zero(), core::Vector3::Zero()};

  // Straight line through the poses around `pose`: half a window to each side, at least one neighbour.
  std::size_t first = pose;
  std::size_t last = pose;
  while (first > 0 && poses_[pose].t - poses_[first - 1].t <= 0.5 * VELOCITY_WINDOW)
    --first;
  while (last + 1 < poses_.size() && poses_[last + 1].t - poses_[pose].t <= 0.5 * VELOCITY_WINDOW)
    ++last;
  if (last == pose)
    while (first > 0 && poses_[pose].t - poses_[first - 1].t <= VELOCITY_WINDOW)
      --first;
  if (first == last && first > 0)
    --first;
  else if (first == last)
    ++last;

  const double n = last - first + 1;
  double mean_t = 0.0;
  core::Vector3 mean = core::Vector3::Zero();
  for (std::size_t i = first; i <= last; ++i)
  {
    mean_t += (poses_[i].t - poses_[first].t) / n;
    mean += (poses_[i].position - poses_[first].position) / n;
  }
  double spread = 0.0;
  core::Vector3 slope = core::Vector3::Zero();
  for (std::size_t i = first; i <= last; ++i)
  {
    const double dt = poses_[i].t - poses_[first].t - mean_t;
    spread += dt * dt;
    slope += dt * (poses_[i].position - poses_[first].position - mean);
  }
  return {slope / spread,
          rotationRate(poses_[first].orientation, poses_[last].orientation, poses_[last].t - poses_[first].t)};
}

bool MotionBuffer::isValid() const
{
  bool sound = poses_.size() <= CAPACITY && rates_.size() <= CAPACITY && attitudes_.size() <= CAPACITY;
  for (std::size_t i = 0; i < poses_.size(); ++i)
    sound = sound && std::isfinite(poses_[i].t) && poses_[i].position.allFinite() &&
            std::abs(poses_[i].orientation.norm() - 1.0) < 1e-6 && (i == 0 || poses_[i].t > poses_[i - 1].t);
  for (std::size_t i = 0; i < rates_.size(); ++i)
    sound = sound && std::isfinite(rates_[i].t) && rates_[i].velocity.allFinite() &&
            rates_[i].angular_velocity.allFinite() && (i == 0 || rates_[i].t > rates_[i - 1].t);
  for (std::size_t i = 0; i < attitudes_.size(); ++i)
    sound = sound && std::isfinite(attitudes_[i].t) && std::abs(attitudes_[i].orientation.norm() - 1.0) < 1e-6 &&
            (!attitudes_[i].angular_velocity || attitudes_[i].angular_velocity->allFinite()) &&
            (i == 0 || attitudes_[i].t > attitudes_[i - 1].t);
  return sound;
}

std::optional<MotionBuffer::Turning> MotionBuffer::measuredTurning(double t) const
{
  const auto after = std::upper_bound(attitudes_.begin(), attitudes_.end(), t,
                                      [](double x, const Attitude& a) { return x < a.t; });
  if (after == attitudes_.begin())
    return std::nullopt;
  const Attitude& last = *std::prev(after);
  const bool is_between = after != attitudes_.end();
  if (t - last.t > ATTITUDE_REACH)
    return std::nullopt;
  if (is_between)
  {
    const double share = (t - last.t) / (after->t - last.t);
    return Turning{last.orientation.slerp(share, after->orientation),
                   rotationRate(last.orientation, after->orientation, after->t - last.t)};
  }
  core::Vector3 rate = core::Vector3::Zero();
  if (last.angular_velocity)
    rate = *last.angular_velocity;
  else if (after - attitudes_.begin() >= 2)
    rate = rotationRate(std::prev(after, 2)->orientation, last.orientation, last.t - std::prev(after, 2)->t);
  return Turning{turned(last.orientation, rate, t - last.t), rate};
}

Eigen::Quaterniond MotionBuffer::orientationAt(double t) const
{
  if (const std::optional<Turning> turning = measuredTurning(t))
    return turning->orientation;
  return hasPose() ? poseAt(t).orientation : lastOrientation();
}

BodyState MotionBuffer::at(double t) const
{
  BodyState state = poseAt(t);
  if (const std::optional<Turning> turning = measuredTurning(t))
  {
    state.orientation = turning->orientation;
    state.angular_velocity = turning->angular_velocity;
  }
  return state;
}

BodyState MotionBuffer::poseAt(double t) const
{
  const auto after =
      std::upper_bound(poses_.begin(), poses_.end(), t, [](double x, const Pose& p) { return x < p.t; });
  const std::size_t hi = after - poses_.begin();
  if (hi == 0 || hi == poses_.size())
  {
    const std::size_t known = hi == 0 ? 0 : poses_.size() - 1;
    const Pose& pose = poses_[known];
    const Slope rates = ratesAt(known, pose.t);
    const double dt = hi == 0 ? 0.0 : t - pose.t;
    return {pose.position + dt * rates.velocity, turned(pose.orientation, rates.angular_velocity, dt),
            rates.velocity, rates.angular_velocity};
  }
  const Pose& a = poses_[hi - 1];
  const Pose& b = poses_[hi];
  const core::EndTrajectory path = core::EndTrajectory::between(a.t, {a.position, ratesAt(hi - 1, a.t).velocity},
                                                                b.t, {b.position, ratesAt(hi, b.t).velocity});
  return {path.position(t), a.orientation.slerp((t - a.t) / (b.t - a.t), b.orientation), path.velocity(t),
          rotationRate(a.orientation, b.orientation, b.t - a.t)};
}

}  // namespace tether_monitor::monitor
