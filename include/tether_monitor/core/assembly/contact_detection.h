#pragma once

#include <vector>

#include "tether_monitor/core/cable/cable_state.h"
#include "tether_monitor/core/contact/contact_law.h"
#include "tether_monitor/core/element/element_coordinates.h"
#include "tether_monitor/core/element/hermite_shape_functions.h"
#include "tether_monitor/core/element/quadrature.h"
#include "tether_monitor/core/environment/environment_model.h"

namespace tether_monitor::core
{
/// Integration points of an element that are watched for contact.
constexpr int CONTACT_POINTS = static_cast<int>(QUADRATURE.size());

/// What contact needs to know of a tether: its elements at the deployment of the state.
struct ContactScene
{
  const std::vector<ElementParameters>& elements;
  const EnvironmentModel& environment;
  const CableState& state;
};

/// An integration point of an element: where it is and how it moves as a piece of the tether.
struct TetherPoint
{
  int index = 0;        ///< into the anchor points of FrictionState.
  double weight = 0.0;  ///< length that it stands for [m].
  ShapeValues shape{};
  Vector3 r = Vector3::Zero(), v = Vector3::Zero();  ///< [m, m/s]
  Vector3 drift =
      Vector3::Zero();  ///< way of the material through the point since the anchor points were set [m].
};

/// Integration point g of element i. @param q, v  coordinates and rates of the element.
TetherPoint tetherPoint(const ContactScene& scene, int i, int g, const ElementCoords& q, const ElementCoords& v);

/// Whether any point of an element may touch the floor, or an obstacle.
struct Proximity
{
  bool floor, obstacle;
};
Proximity proximity(const ContactScene& scene, int i);

/// The seabed under a point; hasSeabed() must hold.
ContactPoint seabedContactPoint(const ContactScene& scene, const TetherPoint& at, double diameter);

/// The obstacle that a point is deepest in, or -1. @param surface  out: its surface there.
int deepestObstacle(const ContactScene& scene, const TetherPoint& at, double diameter, ContactPoint& surface);

/// Calls visit(point, response, obstacle) for every contact of element i; obstacle -1 is the seabed.
template <typename Visit>
void forContacts(const ContactScene& scene, int i, const TangentWeights& w, const Visit& visit)
{
  const Proximity near = proximity(scene, i);
  if ((!near.floor && !near.obstacle) || scene.elements[i].parted)
    return;
  const double diameter = scene.elements[i].contact_diameter;
  const ElementParameters& p = scene.elements[i];
  const ElementCoords q = elementCoords(p, scene.state.q, i), v = elementRates(p, scene.state.q, scene.state.v, i);
  for (int g = 0; g < CONTACT_POINTS; ++g)
  {
    const TetherPoint at = tetherPoint(scene, i, g, q, v);
    if (near.floor)
    {
      const ContactResponse contact = contactForce(seabedContactPoint(scene, at, diameter), diameter, w);
      if (contact.normal_force > 0.0)
        visit(at, contact, -1);
    }
    ContactPoint surface;
    const int obstacle = near.obstacle ? deepestObstacle(scene, at, diameter, surface) : -1;
    if (obstacle >= 0)
    {
      const ContactResponse contact = contactForce(surface, diameter, w);
      if (contact.normal_force > 0.0)
        visit(at, contact, obstacle);
    }
  }
}

}  // namespace tether_monitor::core
