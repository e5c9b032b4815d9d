#include "tether_monitor/ros/geodetic_datum.h"

#include <Eigen/Geometry>

namespace tether_monitor
{
GeodeticDatum::GeodeticDatum(const monitor::DatumConfig& datum)
  : local_(datum.latitude, datum.longitude, 0.0),
    to_world_(Eigen::AngleAxisd(-datum.yaw, core::Vector3::UnitZ()).toRotationMatrix())
{
}

core::Vector3 GeodeticDatum::horizontal(double latitude, double longitude) const
{
  core::Vector3 place;
  local_.Forward(latitude, longitude, 0.0, place.x(), place.y(), place.z());
  place.z() = 0.0;  // the ellipsoid falls away from the plane
  return to_world_ * place;
}

}  // namespace tether_monitor
