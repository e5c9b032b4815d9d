#include "tether_monitor/core/solve/starting_shape.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/bodies/rigid_body_dynamics.h"
#include "tether_monitor/core/solve/grounded_catenary.h"
#include "tether_monitor/core/solve/initial_guess.h"

namespace tether_monitor::core
{
namespace
{
const Vector3 DEEP_WATER(0.0, 0.0, -100.0);  // a place that no wave or surface is near

bool dipsBelowFloor(const DeployedCable& cable, const NodeField& shape)
{
  for (const NodeCoords& node : shape)
    if (node.z() < cable.environment().floorAt(node.head<3>()).z)
      return true;
  return false;
}

bool risesAbove(double height, const NodeField& shape)
{
  return std::any_of(shape.begin() + 1, shape.end() - 1,
                     [&](const NodeCoords& node) { return node.z() > height; });
}

// How much of a tether that is lighter than water a body holds down [m].
double heldDown(const DeployedCable& cable, const SteadyEnds& ends)
{
  const Vector3 pull = steadyForce(*cable.bodies().vehicle, cable.environment(), DEEP_WATER, ends.velocity);
  const ElementParameters& e = cable.element(0);
  const double lift = cable.environment().gravity() * (cable.environment().density() * e.area - e.mass);
  return std::clamp(-pull.z() / lift, 0.0, cable.length());
}

// A tether that floats between its ends, or from the vessel to where its body hangs down.
NodeField floatingStart(const DeployedCable& cable, const SteadyEnds& ends, double level)
{
  constexpr double TIGHT = 0.9;  // share of the floating length that lies between the ends
  Vector3 end = ends.vehicle;
  if (cable.bodies().vehicle)
  {
    const Vector3 pull = steadyForce(*cable.bodies().vehicle, cable.environment(), DEEP_WATER, ends.velocity);
    const double hangs = std::min(heldDown(cable, ends), 0.9 * cable.length());
    const double drift = std::hypot(pull.x(), pull.y());
    const Vector3 away = drift > 0.0 ? Vector3(pull.x() / drift, pull.y() / drift, 0.0) : Vector3::UnitX();
    const double down = std::max(level - ends.vessel.z(), 0.0);
    end = ends.vessel + TIGHT * std::max(cable.length() - hangs - down, 0.0) * away;
    end.z() = level - hangs;
  }
  Vector3 drift =
      netLoad(cable, {ends.vessel.x(), ends.vessel.y(), -1.0}, {end.x(), end.y(), -1.0}, ends.velocity);
  drift.z() = 0.0;
  return floatingCatenary(cable, ends.vessel, end, drift);
}

// The curve that the tether takes without obstacles, more or less.
NodeField freeShape(const DeployedCable& cable, const SteadyEnds& ends)
{
  const bool hangs = cable.bodies().vehicle.has_value();
  NodeField shape = hangs ? hangingBodyGuess(cable, ends.vessel, ends.velocity, *cable.bodies().vehicle)
                          : catenaryGuess(cable, ends.vessel, ends.vehicle, ends.velocity);
  const std::optional<double> afloat = floatingHeight(cable);
  const bool rises = afloat && (hangs ? heldDown(cable, ends) < 0.95 * cable.length()
                                      : risesAbove(*afloat + cable.element(0).diameter, shape));
  if (rises)
  {
    NodeField floating = floatingStart(cable, ends, *afloat);
    return floating.empty() ? shape : floating;
  }
  if (!cable.environment().hasSeabed() || !dipsBelowFloor(cable, shape))
    return shape;
  const NodeField laid =
      groundedCatenary(cable, ends.vessel, hangs ? Vector3(shape.back().head<3>()) : ends.vehicle);
  return laid.empty() ? shape : laid;
}
}  // namespace

void projectOutOfObstacles(const DeployedCable& cable, NodeField& shape)
{
  constexpr int PASSES = 3;  // out of one obstacle may be into another
  for (int pass = 0; pass < PASSES; ++pass)
    for (const Obstacle& obstacle : cable.environment().obstacles())
      for (int i = 1; i < cable.elements(); ++i)
      {
        const SignedDistance gap =
            signedDistance(obstacle, shape[i].head<3>() - (obstacle.position - cable.environment().origin()));
        const double inside = 0.5 * cable.element(i).contact_diameter - gap.distance;
        if (inside > 0.0)
          shape[i].head<3>() += inside * gap.normal;
      }
}

NodeField startingShape(const DeployedCable& cable, const SteadyEnds& ends)
{
  NodeField shape = freeShape(cable, ends);
  projectOutOfObstacles(cable, shape);
  return shape;
}

}  // namespace tether_monitor::core
