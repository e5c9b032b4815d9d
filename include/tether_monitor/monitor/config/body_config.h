#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::monitor
{
/// How one end of the tether is fastened to its body.
struct BodyConfig
{
  core::Vector3 attachment = core::Vector3::Zero();  ///< from the reference point, body axes [m].
  std::optional<core::Vector3> clamped;   ///< direction in which the tether leaves it, body axes; none: hinged.
  std::string frame = "base_link";        ///< frame_id by which a twist in body axes is known.
  std::optional<double> position_stddev;  ///< of the vessel in mode observed, without covariance in the message
                                          ///< [m]; none: estimated from the data.
  std::optional<double> velocity_stddev;  ///< the same of its velocity [m/s].
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
