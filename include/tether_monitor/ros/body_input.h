#pragma once

#include <std_msgs/Header.h>

#include <optional>
#include <string>

#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/ros/header_check.h"
#include "tether_monitor/ros/recent_fixes.h"
#include "tether_monitor/ros/sensor_mounts.h"
#include "tether_monitor/ros/time_conversion.h"

namespace tether_monitor
{
/// Which body a message is about.
enum class Body
{
  VESSEL,
  VEHICLE
};

/**
 * What all messages about the motion of vessel and vehicle share on their way to an estimator. Functions that
 * return an error return nothing if all is well.
 *
 * What is measured at a sensor is taken to the body's reference point: by the sensor's mount and the attitude at
 * the time of the measurement.
 */
class BodyInput
{
 public:
  /// All must outlive this object. @param fixes  gets the positions of the vehicle that are taken.
  BodyInput(monitor::TetherEstimator& estimator, const HeaderCheck& headers, const SensorMounts& mounts,
            const TimeOrigin& time, RecentFixes& fixes);

  using Result = std::optional<InputError>;
  using Source = monitor::SourceConfig;

 protected:
  const monitor::MotionBuffer& track(Body body) const;
  const monitor::BodyConfig& config(Body body) const;
  const monitor::Config& config() const { return estimator_.config(); }
  const HeaderCheck& headers() const { return headers_; }
  const SensorMounts& mounts() const { return mounts_; }
  /// When something was true [s]: the stamp, or the time at which it came, less the latency of the source.
  double timeOf(const ros::Time& stamp, const Source& source) const;
  /// The frame of the sensor that a message is from.
  static const std::string& sensorFrame(const std_msgs::Header& header, const Source& source)
  {
    return source.frame.empty() ? header.frame_id : source.frame;
  }
  /// From the reference point of a body to a sensor on it, world axes [m].
  Result lever(Body body, const std::string& frame, double t, core::Vector3& from_reference) const;
  Result give(Body body, const monitor::PoseMeasurement& pose, const Source& source);
  Result give(Body body, const monitor::TwistMeasurement& rates, const Source& source);
  Result give(Body body, const monitor::PoseMeasurement& pose, const monitor::TwistMeasurement& rates,
              const Source& source);

 private:
  void note(Body body, const monitor::PoseMeasurement& pose, const Result& error);

  monitor::TetherEstimator& estimator_;
  const HeaderCheck& headers_;
  const SensorMounts& mounts_;
  const TimeOrigin& time_;
  RecentFixes& fixes_;
};

}  // namespace tether_monitor
