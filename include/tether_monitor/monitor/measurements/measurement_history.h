#pragma once

#include <limits>
#include <vector>

#include "tether_monitor/monitor/measurements/measured_vector.h"
#include "tether_monitor/monitor/measurements/rejection.h"

namespace tether_monitor::monitor
{
/// A measurement of the vehicle or of the tether at its own time, world axes.
struct VehicleMeasurement
{
  enum class Kind
  {
    POSITION,  ///< of the vehicle's centre of mass [m].
    VELOCITY,  ///< of that [m/s].
    TENSION,   ///< x only: at the vessel end [N].
    DIRECTION  ///< unit, in which the tether leaves the vessel.
  };
  static constexpr int NONE = -1;

  double t = 0.0;  ///< when it was true [s].
  Kind kind = Kind::POSITION;
  MeasuredVector value;  ///< every measured axis with its accuracy.
  int processed = NONE;  ///< where the ensemble keeps what it has made of it.

  /// True for a position that was measured along an axis.
  bool measuresPosition(int axis) const { return kind == Kind::POSITION && value.isMeasured(axis); }
  /// Of every axis; infinite: not measured.
  core::Vector3 stddev() const;
  /// Covariance for a filter that takes all axes: what was not measured has a variance of 1e12.
  core::Matrix3 noise() const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(t, kind, value, processed);
  }
};

/**
 * The last measurements of the vehicle in order of their own time, however they came in: late, out of order or
 * twice. Allocates only in the constructor.
 */
class MeasurementHistory
{
 public:
  static constexpr std::size_t CAPACITY = 1024;

  MeasurementHistory() { fixes_.reserve(CAPACITY); }

  /// What add() would answer; nothing changes.
  Rejection check(const VehicleMeasurement& fix, double earliest) const;
  /// Accepts a measurement that is later than `earliest` [s]. The oldest goes where there is no room.
  Rejection add(const VehicleMeasurement& fix, double earliest);
  void clear();
  /// Forgets what is before t [s].
  void discardBefore(double t);

  const std::vector<VehicleMeasurement>& fixes() const { return fixes_; }
  VehicleMeasurement& fix(std::size_t k) { return fixes_[k]; }
  /// Time of the earliest fix that came since the last call of markProcessed() [s]; infinite if none did.
  double earliestUnprocessed() const { return earliest_unprocessed_; }
  void markProcessed();
  /// Time of the last fix that had to go for want of room [s]; -infinity if none had to.
  double droppedUntil() const { return dropped_until_; }
  bool isValid() const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(fixes_, earliest_unprocessed_, dropped_until_, last_value_, repeats_);
  }

 private:
  int repeatsOf(const VehicleMeasurement& fix) const;
  bool isFrozen(const VehicleMeasurement& fix) const;

  std::vector<VehicleMeasurement> fixes_;
  double earliest_unprocessed_ = std::numeric_limits<double>::infinity();
  double dropped_until_ = -std::numeric_limits<double>::infinity();
  core::Vector3 last_value_ = core::Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
  int repeats_ = 0;
};

}  // namespace tether_monitor::monitor
