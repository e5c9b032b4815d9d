#pragma once

#include <memory>
#include <optional>

#include "tether_monitor/core/base/binary_archive.h"
#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/estimator/end_targets.h"
#include "tether_monitor/monitor/measurements/measurements.h"
#include "tether_monitor/monitor/measurements/motion_buffer.h"
#include "tether_monitor/monitor/measurements/motion_plausibility.h"
#include "tether_monitor/monitor/measurements/rejection.h"

namespace tether_monitor::monitor
{
/// The vessel's end of the tether: its measurements, and the motion that they make of it.
class VesselEnd
{
 public:
  virtual ~VesselEnd() = default;
  virtual std::unique_ptr<VesselEnd> clone() const = 0;

  /// Accepts what one message measured, all of it or nothing. @param pose,twist  null: none.
  virtual Rejection add(const PoseMeasurement* pose, const TwistMeasurement* twist) = 0;
  /// How the end moves before anything has measured its velocity.
  virtual void setInitialMotion(double /*t*/, const BodyState& /*vessel*/) {}
  virtual void clear() = 0;

  /// True if there are measurements enough to begin at time t [s].
  virtual bool isReady(double t) const = 0;
  /// Age at time t [s] of the last position; infinite without one.
  virtual double age(double t) const = 0;
  /// The motion at time t [s] for a tether in motion. Calls in order of t.
  virtual void aim(double t, EndTargets& targets) = 0;
  /// The motion at time t [s] to begin with.
  virtual void aimAtStart(double t, EndTargets& targets) = 0;
  /// Where the vessel itself is at time t [s], for sensors on it; none before its position is known.
  virtual std::optional<BodyState> bodyAt(double t) const = 0;
  /// Standard deviations of its position at time t [m]; zero: not known.
  virtual core::Vector3 positionStddev(double /*t*/) const { return core::Vector3::Zero(); }
  /// The poses and rates that came, in order.
  virtual const MotionBuffer& track() const = 0;

  /// What makes its measurements unbelievable; null: nothing looks.
  virtual const MotionPlausibility* plausibility() const { return nullptr; }
  /// True once after the vessel was found elsewhere.
  virtual bool takeLeap() { return false; }

  /// Measurements that were too far off to be accepted.
  virtual long outliers() const { return 0; }

  /// See MotionBuffer::isValid().
  virtual bool isValid() const = 0;
  virtual void write(core::BinaryWriter& archive) const = 0;
  virtual void read(core::BinaryReader& archive) = 0;
};

/// That of a mode.
std::unique_ptr<VesselEnd> makeVesselEnd(const Config& config);

}  // namespace tether_monitor::monitor
