#pragma once

#include <vector>

#include "tether_monitor/core/assembly/deployed_cable.h"

namespace tether_monitor::core
{
/// What a tether touches.
struct ContactSummary
{
  /// Contact with one obstacle.
  struct ObstacleContact
  {
    Vector3 force = Vector3::Zero();  ///< of the tether on the obstacle [N].
    Vector3 place = Vector3::Zero();  ///< centroid of the points of contact, weighted by their force [m].
    double s = 0.0;                   ///< the same along the tether [m].
    double total = 0.0;               ///< sum of the sizes of the normal forces [N]; 0: no contact.
    double largest = 0.0;             ///< largest normal line load [N/m].

    template <class Archive>
    void serialize(Archive& a)
    {
      a(force, place, s, total, largest);
    }
  };

  double seabed_length = 0.0;  ///< unstretched length on the seabed [m].
  double touchdown_s = -1.0;   ///< first point on the seabed from the vessel end [m]; < 0: none.
  double energy = 0.0;         ///< stored in the springs of contact and friction [J].
  std::vector<ObstacleContact> obstacles;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(seabed_length, touchdown_s, energy, obstacles);
  }
};

/// Fills `summary`, whose `obstacles` must have one entry for each obstacle; allocates nothing.
void summarizeContact(const DeployedCable& cable, const CableState& state, ContactSummary& summary);

}  // namespace tether_monitor::core
