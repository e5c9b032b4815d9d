#pragma once

#include <sensor_msgs/FluidPressure.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/NavSatFix.h>
#include <std_msgs/Float64.h>
#include <tether_monitor/AcousticFix.h>

#include <optional>

#include "tether_monitor/ros/body_input.h"
#include "tether_monitor/ros/geodetic_datum.h"

namespace tether_monitor
{
/// Gives what single sensors measure of vessel and vehicle to an estimator. take() returns nothing if the message
/// was accepted, else why it was not.
class SensorInputAdapter : public BodyInput
{
 public:
  SensorInputAdapter(monitor::TetherEstimator& estimator, const HeaderCheck& headers, const SensorMounts& mounts,
                     const TimeOrigin& time, RecentFixes& fixes);

  /// Of the antenna; needs `datum`. Its height counts if that has an altitude.
  Result take(Body body, const sensor_msgs::NavSatFix& message, const ros::Time& now, const Source& source);
  /// Attitude against east, north and up (north, east and down for a body with axes frd), and angular velocity;
  /// accelerations are not used.
  Result take(Body body, const sensor_msgs::Imu& message, const ros::Time& now, const Source& source);
  /// Depth of the reference point, > 0 below the surface [m].
  Result take(Body body, const std_msgs::Float64& message, const ros::Time& now, const Source& source);
  /// Absolute pressure at the sensor [Pa].
  Result take(Body body, const sensor_msgs::FluidPressure& message, const ros::Time& now, const Source& source);
  /// Range, bearing and elevation in the frame of a transducer.
  Result take(Body body, const AcousticFix& message, const ros::Time& now, const Source& source);

 private:
  Result giveHeight(Body body, double t, double height, std::optional<double> stddev, const Source& source);

  std::optional<GeodeticDatum> datum_;
};

}  // namespace tether_monitor
