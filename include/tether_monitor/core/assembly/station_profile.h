#pragma once

#include "tether_monitor/core/assembly/end_forces.h"

namespace tether_monitor::core
{
/// What is reported along the tether. Vectors have one entry a station, from the vessel end to the vehicle end.
/// Stations: every node and the middle of every element, 2 N + 1 in all.
struct StationProfile
{
  std::vector<double> s;          ///< unstretched arc length [m].
  std::vector<Vector3> position;  ///< [m].
  std::vector<double> tension;    ///< physical effective tension [N], > 0 in pull, (M14).
  std::vector<double> strain;     ///< engineering strain over the natural length, |r'| / lambda_0 - 1, mean of an
                                  ///< element at its middle [-].
  std::vector<double> stress;     ///< tension over the load-bearing section, the larger at a boundary [Pa].
  std::vector<double> bend_radius;  ///< [m]; infinity where straight, (M18).
  EndForces ends;
  Vector3 vessel_direction = Vector3::Zero();   ///< unit tangent at the vessel end, towards the vehicle end.
  Vector3 vehicle_direction = Vector3::Zero();  ///< unit tangent at the vehicle end, away from the vessel end.
  double stretched_length = 0.0;                ///< integral of |r'| [m].
  double max_element_rotation = 0.0;            ///< largest change of direction over one element [rad].

  StationProfile() = default;
  /// Room for the stations of a model with `elements` elements.
  explicit StationProfile(int elements);

  template <class Archive>
  void serialize(Archive& a)
  {
    a(s, position, tension, strain, stress, bend_radius, ends, vessel_direction, vehicle_direction,
      stretched_length, max_element_rotation);
  }
};

/// Fills `profile` (made for this cable's element count) from a state; allocates nothing.
void computeStations(const DeployedCable& cable, const CableState& state, StationProfile& profile);

}  // namespace tether_monitor::core
