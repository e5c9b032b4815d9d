#include "tether_monitor/monitor/measurements/measurement_history.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tether_monitor::monitor
{
namespace
{
constexpr double SAME_TIME = 1e-6;   // [s]
constexpr double SAME_PLACE = 1e-3;  // [m]: what came twice may be seen with another attitude of the moment
constexpr double COARSE = 0.005;     // [m]: noise that never gives the same number thrice
constexpr int FROZEN = 3;            // equal positions in a row that cannot be measurements
constexpr double UNMEASURED_VARIANCE = 1e12;

// A position whose axes that were not measured are always equal.
core::Vector3 comparable(const VehicleMeasurement& fix)
{
  core::Vector3 value = fix.value.value();
  for (int axis = 0; axis < 3; ++axis)
    if (!fix.measuresPosition(axis))
      value[axis] = std::numeric_limits<double>::infinity();
  return value;
}

// Two sources may measure at one moment; what came twice says the same of the same axes.
bool isSame(const VehicleMeasurement& a, const VehicleMeasurement& b)
{
  bool same = std::abs(a.t - b.t) < SAME_TIME && a.kind == b.kind;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool is_measured = a.value.isMeasured(axis);
    same = same && is_measured == b.value.isMeasured(axis);
    same = same && (!is_measured || std::abs(a.value.value()[axis] - b.value.value()[axis]) <= SAME_PLACE);
  }
  return same;
}

// A depth alone may well repeat: sensors tell centimetres.
bool isPlace(const VehicleMeasurement& fix)
{
  return fix.measuresPosition(0) || fix.measuresPosition(1);
}
}  // namespace

core::Vector3 VehicleMeasurement::stddev() const
{
  core::Vector3 stddev;
  for (int axis = 0; axis < 3; ++axis)
    stddev[axis] = value.isMeasured(axis) ? value.stddev(axis) : std::numeric_limits<double>::infinity();
  return stddev;
}

core::Matrix3 VehicleMeasurement::noise() const
{
  core::Matrix3 covariance = value.covariance();
  for (int axis = 0; axis < 3; ++axis)
    if (!value.isMeasured(axis))
      covariance(axis, axis) = UNMEASURED_VARIANCE;
  return covariance;
}

int MeasurementHistory::repeatsOf(const VehicleMeasurement& fix) const
{
  return comparable(fix) == last_value_ ? repeats_ + 1 : 1;
}

// Positions that scatter do not repeat to the last digit: the source has stopped and its driver goes on.
bool MeasurementHistory::isFrozen(const VehicleMeasurement& fix) const
{
  return isPlace(fix) && repeatsOf(fix) >= FROZEN && fix.stddev().minCoeff() > COARSE;
}

Rejection MeasurementHistory::check(const VehicleMeasurement& fix, double earliest) const
{
  if (!std::isfinite(fix.t) || !fix.value.isValid())
    return Rejection::NOT_FINITE;
  if (std::any_of(fixes_.begin(), fixes_.end(),
                  [&](const VehicleMeasurement& other) { return isSame(other, fix); }))
    return Rejection::REPEATED;
  if (fix.t <= earliest)
    return Rejection::TOO_LATE;
  return isFrozen(fix) ? Rejection::FROZEN : Rejection::NONE;
}

Rejection MeasurementHistory::add(const VehicleMeasurement& fix, double earliest)
{
  const Rejection rejection = check(fix, earliest);
  if (rejection != Rejection::NONE)
    return rejection;
  if (isPlace(fix))
  {
    repeats_ = repeatsOf(fix);
    last_value_ = comparable(fix);
  }
  if (fixes_.size() == CAPACITY)
  {
    dropped_until_ = fixes_[CAPACITY / 2 - 1].t;
    fixes_.erase(fixes_.begin(), fixes_.begin() + CAPACITY / 2);
  }
  const auto place = std::upper_bound(fixes_.begin(), fixes_.end(), fix.t,
                                      [](double t, const VehicleMeasurement& other) { return t < other.t; });
  fixes_.insert(place, fix);
  earliest_unprocessed_ = std::min(earliest_unprocessed_, fix.t);
  return Rejection::NONE;
}

void MeasurementHistory::clear()
{
  fixes_.clear();
  markProcessed();
  dropped_until_ = -std::numeric_limits<double>::infinity();
  repeats_ = 0;
}

void MeasurementHistory::discardBefore(double t)
{
  const auto first = std::lower_bound(fixes_.begin(), fixes_.end(), t,
                                      [](const VehicleMeasurement& fix, double x) { return fix.t < x; });
  fixes_.erase(fixes_.begin(), first);
}

void MeasurementHistory::markProcessed()
{
  earliest_unprocessed_ = std::numeric_limits<double>::infinity();
}

bool MeasurementHistory::isValid() const
{
  bool sound = fixes_.size() <= CAPACITY && !std::isnan(earliest_unprocessed_);
  for (std::size_t i = 0; i < fixes_.size(); ++i)
    sound = sound && std::isfinite(fixes_[i].t) && fixes_[i].value.isValid() &&
            fixes_[i].stddev().minCoeff() > 0.0 && (i == 0 || fixes_[i].t >= fixes_[i - 1].t);
  return sound;
}

}  // namespace tether_monitor::monitor
