#include "tether_monitor/monitor/ensemble/improbability.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double IMPROBABLE = 4.0;      // standard deviations that chance does not explain
constexpr double LEAST_LEARNT = 0.4;    // share of a variance that is taken to have gone, at least
constexpr double NORMAL_P999 = 3.0902;  // standard normal quantile of 0.999

double squareOf(const LearntQuantity& q)
{
  return q.prior_stddev > 0.0 ? std::pow(q.mean / q.prior_stddev, 2) : 0.0;
}

struct Finding
{
  Subject subject;
  Implausibility what;
};

Finding findingOf(Parameter parameter)
{
  switch (parameter)
  {
    case DRAG_NORMAL:
    case DRAG_TANGENTIAL:
      return {Subject::TETHER, Implausibility::IMPROBABLE_DRAG};
    case MASS_PER_LENGTH:
      return {Subject::TETHER, Implausibility::IMPROBABLE_MASS};
    case LENGTH:
      return {Subject::TETHER, Implausibility::IMPROBABLE_LENGTH};
    case AXIAL_STIFFNESS:
      return {Subject::TETHER, Implausibility::IMPROBABLE_STIFFNESS};
    case CURRENT_X:
    case CURRENT_Y:
    case SHEAR_X:
    case SHEAR_Y:
      return {Subject::WATER, Implausibility::IMPROBABLE_CURRENT};
    case VEHICLE_DRAG:
      return {Subject::VEHICLE, Implausibility::IMPROBABLE_VEHICLE_DRAG};
    case TENSION_BIAS:
      return {Subject::SENSOR, Implausibility::IMPROBABLE_TENSION};
    case DIRECTION_AZIMUTH:
    case DIRECTION_ELEVATION:
    case PARAMETERS:
      break;
  }
  return {Subject::SENSOR, Implausibility::IMPROBABLE_DIRECTION};
}
}  // namespace

void JointImprobability::add(const LearntQuantity& quantity)
{
  if (!(quantity.prior_stddev > 0.0))
    return;
  squared_distance_ += squareOf(quantity);
  learnt_ += std::clamp(1.0 - quantity.variance / std::pow(quantity.prior_stddev, 2), 0.0, 1.0);
}

// The means are normal, and independent in some axes, with variances between 0 and 1 that sum up to what is
// learnt: chi-square of that many degrees of freedom, by Wilson and Hilferty (1931), has the same mean and no
// thinner tail.
double JointImprobability::bound() const
{
  const double dof = std::max(learnt_, 1.0), spread = 2.0 / (9.0 * dof);
  return dof * std::pow(1.0 - spread + NORMAL_P999 * std::sqrt(spread), 3);
}

// What is known of a quantity moves its mean by as much as its variance has lost.
bool isImprobable(const LearntQuantity& quantity)
{
  if (!(quantity.prior_stddev > 0.0))
    return false;
  const double learnt = 1.0 - quantity.variance / std::pow(quantity.prior_stddev, 2);
  return squareOf(quantity) > IMPROBABLE * IMPROBABLE * std::clamp(learnt, LEAST_LEARNT, 1.0);
}

void findImprobable(const EnsembleFilter& filter, const std::function<void(Subject, Implausibility)>& note)
{
  JointImprobability joint;
  double farthest = 0.0;
  Finding explains{};
  bool is_noted = false;
  const auto look = [&](const LearntQuantity& quantity, double certain_variance, const Finding& finding)
  {
    joint.add(quantity);
    if (isImprobable({quantity.mean, certain_variance, quantity.prior_stddev}))
    {
      note(finding.subject, finding.what);
      is_noted = true;
    }
    if (squareOf(quantity) <= farthest)
      return;
    farthest = squareOf(quantity);
    explains = finding;
  };
  for (int k = 0; k < PARAMETERS; ++k)
  {
    const auto row = filter.parameters().row(k);
    const double variance = varianceOf(row);
    look({row.mean(), variance, filter.prior().stddev[k]}, variance, findingOf(static_cast<Parameter>(k)));
  }
  const auto force = filter.motionError().means().middleRows<3>(MotionErrorFilter::SLOW);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int state = MotionErrorFilter::SLOW + axis;
    look({force.row(axis).mean(), varianceOf(force.row(axis)) + filter.motionError().covariance()(state, state),
          filter.unknownForce().slow_stddev},
         0.0, {Subject::VEHICLE, Implausibility::IMPROBABLE_FORCE});
  }
  if (!is_noted && joint.isImprobable())
    note(explains.subject, explains.what);
}

}  // namespace tether_monitor::monitor
