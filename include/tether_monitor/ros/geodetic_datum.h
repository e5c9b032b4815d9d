#pragma once

#include <GeographicLib/LocalCartesian.hpp>

#include "tether_monitor/core/base/types.h"
#include "tether_monitor/monitor/config/inputs_config.h"

namespace tether_monitor
{
/// Takes places on the globe into the world frame: its x-y plane touches the ellipsoid at the datum.
class GeodeticDatum
{
 public:
  explicit GeodeticDatum(const monitor::DatumConfig& datum);

  /// x and y of a place [m], z = 0. @param latitude,longitude  WGS 84 [deg].
  core::Vector3 horizontal(double latitude, double longitude) const;
  /// From east, north and up to the axes of the world frame.
  const core::Matrix3& eastNorthUpToWorld() const { return to_world_; }

 private:
  GeographicLib::LocalCartesian local_;
  core::Matrix3 to_world_;
};

}  // namespace tether_monitor
