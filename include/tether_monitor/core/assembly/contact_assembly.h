#pragma once

#include <vector>

#include "tether_monitor/core/assembly/element_equations.h"
#include "tether_monitor/core/cable/cable_state.h"
#include "tether_monitor/core/environment/environment_model.h"
#include "tether_monitor/core/linalg/block_tridiagonal.h"
#include "tether_monitor/core/linalg/bordered_block_tridiagonal.h"

namespace tether_monitor::core
{
class CableModel;

/// A border for the obstacles of `model` that have a mass, and which they are.
BorderedSystem borderedSystemFor(const CableModel& model, std::vector<int>& movable);

/**
 * Adds the contact of a tether with the seabed and with obstacles to its residual, (M22) and (M23) of
 * doc/model.md.
 *
 * Normal force: a spring that begins softly and a damper, never in pull. Friction: a spring tied to the surface
 * that slips at mu N, so that a tether at rest stays where it is.
 *
 * @param tangent  out unless null: weighted iteration matrix.
 * @param border   out unless null: forces on, and couplings to, the obstacles.
 */
void addContact(const CableModel& model, const CableState& state, const TangentWeights& weights,
                NodeField& residual, BlockTridiagonal* tangent, BorderedSystem* border);

/// Contact force on the nodes of element `i` alone, to be added to its residual.
ElementCoords elementContact(const CableModel& model, int i, const CableState& state);

/// Gives a state room for the memory of friction, tied to where it lies, and its obstacles their places. Call it
/// once for every state that is to be stepped.
void initializeContact(const CableModel& model, CableState& state);

/// Ties the springs of friction anew after an accepted step.
void commitFriction(const CableModel& model, CableState& state);

/// What a tether touches.
struct ContactSummary
{
  /// Contact with one obstacle.
  struct ObstacleContact
  {
    Vector3 force = Vector3::Zero();  ///< of the tether on the obstacle [N].
    Vector3 place = Vector3::Zero();  ///< mean of the points of contact, weighted by their force [m].
    double s = 0.0;                   ///< the same along the tether [m].
    double total = 0.0;               ///< sum of the sizes of the normal forces [N]; 0: no contact.
    double largest = 0.0;             ///< largest normal force per metre [N/m].

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
void summarizeContact(const CableModel& model, const CableState& state, ContactSummary& summary);

}  // namespace tether_monitor::core
