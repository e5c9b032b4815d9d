#include "tether_monitor/monitor/ensemble/innovation_gate.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double CHI2_3DOF_0999 = 16.3;  // squared distance that a good position exceeds once in a thousand
constexpr int REACQUISITION_COUNT = 5;   // refused positions that agree, after a gap or at the beginning
constexpr int RESET_COUNT = 30;          // the same against positions that were accepted just before
constexpr double GAP = 5.0;  // [s] without a measurement after which the prediction is none to insist on
constexpr double REACQUISITION_WINDOW =
    20.0;  // [s] after the start or a gap in which positions need not be defended
constexpr double INCONSISTENCY_HOLD = 600.0;  // [s] for which a change against better knowledge stays in question
constexpr double DRIFT = 0.5;                 // speed at which offsets that agree may change [m/s]
constexpr double FASTEST_VEHICLE = 3.0;       // the same of positions [m/s]: a lost model drifts anywhere
constexpr double SQUARE_SHARE = 0.03;         // of the running mean of the squares
constexpr double MEAN_SHARE = 0.1;            // of the running mean of the innovations
constexpr double MAX_NOISE_VARIANCE_SCALE = 25.0;  // of the variance
constexpr double BIAS_CHI2_FAULT = 20.0;  // squared normalized_innovation_mean that chance does not explain
constexpr int OTHER_RESET_COUNT = 60;     // refused readings of tension, direction or velocity in a row

// 1 for every axis that a position measures.
core::Vector3 axesOf(const VehicleMeasurement& fix)
{
  core::Vector3 axes = core::Vector3::Zero();
  for (int axis = 0; axis < 3; ++axis)
    axes[axis] = fix.measuresPosition(axis) ? 1.0 : 0.0;
  return axes;
}
}  // namespace

void InnovationGate::start(double t, double measured)
{
  const double inconsistent_until = inconsistent_until_;
  const InnovationStatistics report = report_;
  *this = InnovationGate();
  inconsistent_until_ = inconsistent_until;
  last_accepted_.setConstant(measured);
  last_seen_.setConstant(t);
  reacquisition_until_ = t + REACQUISITION_WINDOW;
  report_.accepted = report.accepted;
  report_.refused = report.refused;
  report_.reacquired = report.reacquired;
}

double InnovationGate::noiseVarianceScale() const
{
  return std::clamp(square_, 1.0, MAX_NOISE_VARIANCE_SCALE);
}

bool InnovationGate::isInconsistent(double t) const
{
  return t < inconsistent_until_ ||
         report_.normalized_innovation_mean * report_.normalized_innovation_mean > BIAS_CHI2_FAULT ||
         consecutive_rejections_ >= 3 || other_refusals_ >= 3;
}

InnovationGate::Verdict InnovationGate::reacquire(const VehicleMeasurement& fix, const core::Vector3& offset)
{
  const double dt = fix.t - last_refused_;
  // A depth says nothing of a place: what both have measured is compared.
  const core::Vector3 axes = axesOf(fix);
  const core::Vector3 both = axes.cwiseProduct(refused_axes_);
  const double scatter = 5.0 * fix.stddev().cwiseMin(10.0).norm();
  const double apart = both.cwiseProduct(offset - last_offset_).norm();
  const double moved = both.cwiseProduct(fix.value.value() - last_position_).norm();
  const bool agrees = !both.isZero() && (apart <= scatter + DRIFT * dt || moved <= scatter + FASTEST_VEHICLE * dt);
  consecutive_rejections_ = consecutive_rejections_ > 0 && agrees ? consecutive_rejections_ + 1 : 1;
  last_offset_ = offset;
  last_position_ = fix.value.value();
  refused_axes_ = axes;
  last_refused_ = fix.t;
  const bool is_open = fix.t < reacquisition_until_;
  if (consecutive_rejections_ < (is_open ? REACQUISITION_COUNT : RESET_COUNT))
    return Verdict::REJECT;
  if (!is_open)
    inconsistent_until_ = fix.t + INCONSISTENCY_HOLD;
  consecutive_rejections_ = 0;
  ++report_.reacquired;
  return is_open ? Verdict::REACQUIRE : Verdict::RESET;
}

// What lasts does not average out: of a share c of the variance, c is left of the mean's.
void InnovationGate::updateStatistics(const VehicleMeasurement& fix, const core::Vector3& scaled,
                                      const core::Vector3& lasting, double square)
{
  ++samples_;
  const double share = std::max(SQUARE_SHARE, 1.0 / (samples_ + 10.0));
  int axes = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (fix.measuresPosition(axis))
    {
      mean_[axis] += MEAN_SHARE * (scaled[axis] - mean_[axis]);
      lasting_[axis] += MEAN_SHARE * (lasting[axis] - lasting_[axis]);
      ++axes;
    }
  square_ += share * (square / axes - square_);
  report_.noise_scale = std::sqrt(square_);
  const double left = MEAN_SHARE / (2.0 - MEAN_SHARE);
  report_.normalized_innovation_mean =
      mean_.cwiseQuotient((left + (1.0 - left) * lasting_.array()).sqrt().matrix()).norm();
}

// A depth that comes on is no place: every axis has its own gaps.
void InnovationGate::noteSeen(const VehicleMeasurement& fix)
{
  for (int axis = 0; axis < 3; ++axis)
    if (fix.measuresPosition(axis))
    {
      if (fix.t - last_seen_[axis] > GAP)
        reacquisition_until_ = fix.t + REACQUISITION_WINDOW;
      last_seen_[axis] = std::max(last_seen_[axis], fix.t);
    }
}

InnovationGate::Verdict InnovationGate::evaluateOther(double square)
{
  if (square < CHI2_3DOF_0999)
  {
    other_refusals_ = 0;
    ++report_.accepted;
    return Verdict::ACCEPT;
  }
  ++report_.refused;
  if (++other_refusals_ < OTHER_RESET_COUNT)
    return Verdict::REJECT;
  other_refusals_ = 0;
  return Verdict::RESET;
}

InnovationGate::Verdict InnovationGate::evaluate(const VehicleMeasurement& fix, const core::Vector3& innovation,
                                                 const core::Matrix3& covariance, const core::Matrix3& lasting)
{
  const double square = innovation.dot(covariance.ldlt().solve(innovation));
  if (fix.kind != VehicleMeasurement::Kind::POSITION)
    return evaluateOther(square);
  noteSeen(fix);
  const core::Vector3 expected = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  report_.last = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    report_.last = std::hypot(report_.last, fix.measuresPosition(axis) ? innovation[axis] : 0.0);
  Verdict verdict = Verdict::ACCEPT;
  if (square < CHI2_3DOF_0999 * noiseVarianceScale())
  {
    if (!axesOf(fix).cwiseProduct(refused_axes_).isZero())
      consecutive_rejections_ = 0;
    const core::Vector3 share =
        lasting.diagonal().cwiseQuotient(covariance.diagonal()).cwiseMax(0.0).cwiseMin(1.0);
    updateStatistics(fix, innovation.cwiseQuotient(expected), share, square);
  }
  else
  {
    ++report_.refused;
    verdict = reacquire(fix, innovation);
    if (verdict == Verdict::REJECT)
      return verdict;
  }
  for (int axis = 0; axis < 3; ++axis)
    if (fix.measuresPosition(axis))
      last_accepted_[axis] = std::max(last_accepted_[axis], fix.t);
  ++report_.accepted;
  return verdict;
}

}  // namespace tether_monitor::monitor
