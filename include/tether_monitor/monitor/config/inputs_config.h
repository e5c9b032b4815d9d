#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tether_monitor::monitor
{
/// How the messages of one topic are to be read, where they do not say it themselves.
struct SourceConfig
{
  std::string topic;             ///< relative; with a number, vehicle/pose2, one more source of that kind.
  std::string from;              ///< topic on which it is published; empty: the same.
  std::string frame;             ///< of the sensor; empty: that of the header.
  double latency = 0.0;          ///< how much older a measurement is than its stamp [s], 0..30.
  std::optional<double> stddev;  ///< without covariance in the message [m or m/s], > 0; none: that of the body.
  double scale = 1.0;            ///< of a plain number or a pressure, not 0: -1 for a height, 1000 for kPa.
};

/// Where the world frame is on the globe.
struct DatumConfig
{
  double latitude = 0.0, longitude = 0.0;  ///< of its origin, WGS 84 [deg], -90..90 and -180..180.
  double yaw = 0.0;                        ///< from east to its x axis, counter-clockwise [rad], -2 pi..2 pi.
  std::optional<double> altitude;  ///< of the still water over the ellipsoid [m]; none: heights of fixes are not
                                   ///< used.
};

/// A joint of a winch whose angle or travel tells the deployed length.
struct WinchJointConfig
{
  std::string name;     ///< in the JointState.
  double ratio = 1.0;   ///< deployed length over its position [m/rad or m/m], not 0.
  double offset = 0.0;  ///< deployed length at its zero [m].
};

/// What the shell has to know of what comes in.
struct InputsConfig
{
  std::vector<SourceConfig> sources;
  std::optional<DatumConfig> datum;
  std::optional<WinchJointConfig> winch_joint;
  double air_pressure = 101325.0;  ///< at the surface [Pa], 8e4..1.2e5; 0: sensors tell the pressure over it.

  /// That of a topic; the defaults if it has none.
  SourceConfig source(const std::string& topic) const;
};

/// Every bound that is violated, one sentence each.
std::vector<std::string> validate(const InputsConfig& config);

}  // namespace tether_monitor::monitor
