#include "tether_monitor/monitor/fix_judge.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double GATE = 16.3;          // squared distance that a good position exceeds once in a thousand
constexpr int PERSISTENT = 5;          // refused positions that agree, after a gap or at the beginning
constexpr int STUBBORN = 30;           // the same against positions that were believed just before
constexpr double GAP = 5.0;            // [s] without a measurement after which the prediction is none to insist on
constexpr double OPEN = 20.0;          // [s] after the start or a gap in which positions need not be defended
constexpr double CONTEST = 600.0;      // [s] for which a change against better knowledge stays in question
constexpr double DRIFT = 0.5;          // speed at which offsets that agree may change [m/s]
constexpr double SQUARE_SHARE = 0.03;  // of the running mean of the squares
constexpr double MEAN_SHARE = 0.1;     // of the running mean of the innovations
constexpr double MOST_SCATTER = 25.0;  // of the variance
constexpr double CALM = 9.0;           // squared bias that chance explains
constexpr double DISPUTE = 25.0;       // squared bias that it does not
constexpr double MOST_UNREST = 100.0;
}  // namespace

void FixJudge::start(double t, double measured)
{
  const double contested_until = contested_until_;
  const InnovationReport report = report_;
  *this = FixJudge();
  contested_until_ = contested_until;
  last_accepted_.setConstant(measured);
  last_seen_ = t;
  open_until_ = t + OPEN;
  report_.accepted = report.accepted;
  report_.refused = report.refused;
  report_.reacquired = report.reacquired;
}

double FixJudge::unrest() const
{
  return std::clamp(report_.bias * report_.bias / CALM, 1.0, MOST_UNREST);
}

bool FixJudge::isDisputed(double t) const
{
  return t < contested_until_ || report_.bias * report_.bias > DISPUTE || refusals_ >= 3;
}

bool FixJudge::isConvinced(const VehicleFix& fix, const core::Vector3& offset)
{
  const double dt = fix.t - last_refused_;
  const double apart = (offset - last_offset_).norm();
  const double reach = 5.0 * fix.stddev.cwiseMin(10.0).norm() + DRIFT * dt;
  refusals_ = refusals_ > 0 && apart <= reach ? refusals_ + 1 : 1;
  last_offset_ = offset;
  last_refused_ = fix.t;
  const bool is_open = fix.t < open_until_;
  if (refusals_ < (is_open ? PERSISTENT : STUBBORN))
    return false;
  if (!is_open)
    contested_until_ = fix.t + CONTEST;
  return true;
}

void FixJudge::learn(const VehicleFix& fix, const core::Vector3& scaled, double square)
{
  ++samples_;
  const double share = std::max(SQUARE_SHARE, 1.0 / (samples_ + 10.0));
  int axes = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (fix.measuresPosition(axis))
    {
      mean_[axis] += MEAN_SHARE * (scaled[axis] - mean_[axis]);
      ++axes;
    }
  square_ += share * (square / axes - square_);
  report_.scatter = std::sqrt(square_);
  report_.bias = mean_.norm() / std::sqrt(MEAN_SHARE / (2.0 - MEAN_SHARE));
}

void FixJudge::judge(const VehicleFix& fix, const core::Vector3& offset, VehicleFilter& filter)
{
  const double scale = std::sqrt(std::clamp(square_, 1.0, MOST_SCATTER));
  const core::Vector3 stddev = scale * fix.stddev.cwiseMin(1e6);
  if (fix.kind == VehicleFix::Kind::VELOCITY)
  {
    const bool is_good = filter.velocityDistance(offset, stddev) < GATE;
    if (is_good)
      filter.correctVelocity(offset, stddev);
    ++(is_good ? report_.accepted : report_.refused);
    return;
  }
  if (fix.t - last_seen_ > GAP)
    open_until_ = fix.t + OPEN;
  last_seen_ = fix.t;
  const core::Vector3 innovation = offset - filter.positionError();
  const core::Vector3 expected = (filter.positionStddev().cwiseAbs2() + stddev.cwiseAbs2()).cwiseSqrt();
  report_.last = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    report_.last = std::hypot(report_.last, fix.measuresPosition(axis) ? innovation[axis] : 0.0);
  const double square = filter.distance(offset, stddev);
  if (square < GATE)
  {
    refusals_ = 0;
    learn(fix, innovation.cwiseQuotient(expected), square);
  }
  else
  {
    ++report_.refused;
    if (!isConvinced(fix, offset))
      return;
    ++report_.reacquired;
    refusals_ = 0;
    filter.doubtPosition(report_.last);
  }
  filter.correctPosition(offset, stddev);
  for (int axis = 0; axis < 3; ++axis)
    if (fix.measuresPosition(axis))
      last_accepted_[axis] = std::max(last_accepted_[axis], fix.t);
  ++report_.accepted;
}

}  // namespace tether_monitor::monitor
