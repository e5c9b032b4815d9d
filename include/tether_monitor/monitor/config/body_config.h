#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::monitor
{
/// In which axes the twist of a body comes in an Odometry, or in a message in the body's frame.
enum class TwistFrame
{
  CHILD,  ///< those of the body, as ROS has it.
  WORLD   ///< those of the pose's frame.
};

/// Axes of a body in its messages.
enum class BodyAxes
{
  FLU,  ///< x forward, y left, z up.
  FRD   ///< x forward, y right, z down.
};

/// A vector in the other axes of the two: half a turn about x.
inline core::Vector3 turnedAboutX(const core::Vector3& v)
{
  return {v.x(), -v.y(), -v.z()};
}

/// The same turn of a body.
inline Eigen::Quaterniond halfTurnAboutX()
{
  return {0.0, 1.0, 0.0, 0.0};
}

/// How one end of the tether is fastened to its body, and what its messages mean.
struct BodyConfig
{
  core::Vector3 attachment = core::Vector3::Zero();  ///< from the reference point, body axes [m].
  std::optional<core::Vector3> clamped;   ///< direction in which the tether leaves it, body axes; none: hinged.
  std::string frame = "base_link";        ///< frame_id by which a twist in body axes is known.
  std::optional<double> position_stddev;  ///< of the vessel in mode observed, without covariance in the message
                                          ///< [m]; none: estimated from the data. Of a tracked vehicle: for bands.
  std::optional<double> velocity_stddev;  ///< the same of its velocity [m/s].
  double least_stddev = 0.005;            ///< no source of positions is believed to be better [m], > 0.
  std::optional<double> height;  ///< of the reference point of a body that floats, over the still water, for
                                 ///< satellite positions without one [m]; none: not assumed.
  std::string tf_frame;          ///< whose transform is looked up for the pose in every cycle; empty: none.
  TwistFrame twist_frame = TwistFrame::CHILD;
  BodyAxes body_axes = BodyAxes::FLU;  ///< in which its messages are; everything here is in FLU.
};

/// Direction in which the tether leaves a body of this orientation, world axes; zero: it is hinged.
inline core::Vector3 clampDirection(const BodyConfig& body, const Eigen::Quaterniond& orientation)
{
  return body.clamped ? core::Vector3(orientation * body.clamped->normalized())
                      : core::Vector3(core::Vector3::Zero());
}

/// What drives the vehicle end.
enum class VehicleMode
{
  TRACKED,  ///< held on the measured motion.
  FREE,     ///< a simulated body.
  OBSERVED  ///< a simulated body that measurements correct.
};

}  // namespace tether_monitor::monitor
