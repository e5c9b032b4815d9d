#include "tether_monitor/core/assembly/contact_detection.h"

#include <algorithm>

namespace tether_monitor::core
{
namespace
{
constexpr double STEP_DAMPING = 0.5;  // least damping over stiffness and time step [-], (M22)
constexpr double REACH_MARGIN = 1.5;  // of an element's length, for the slope of the floor
}  // namespace

TetherPoint tetherPoint(const ContactScene& scene, int i, int g, const ElementCoords& q, const ElementCoords& v)
{
  const ElementParameters& p = scene.elements[i];
  const QuadraturePoint& quadrature = QUADRATURE[g];
  TetherPoint point;
  point.index = CONTACT_POINTS * i + g;
  point.weight = quadrature.weight * p.length;
  point.shape = shapeFunctions(quadrature.xi, p.length);
  point.r = interpolate(point.shape, q);
  point.v = interpolate(point.shape, v);
  if (p.transport.active)
  {
    const Vector3 slope = interpolate(shapeSlopes(quadrature.xi, p.length), q);
    const double c = p.transport.at(quadrature.xi);
    point.v +=
        p.transport.growth * (point.shape[1] * q.segment<3>(3) + point.shape[3] * q.segment<3>(9)) + c * slope;
    point.drift = c * (scene.state.time - scene.state.contact.time) * slope;
  }
  return point;
}

Proximity proximity(const ContactScene& scene, int i)
{
  const Vector3 a = scene.state.q[i].head<3>(), b = scene.state.q[i + 1].head<3>();
  const Vector3 middle = 0.5 * (a + b);
  const double reach = std::max(scene.elements[i].length, (b - a).norm()) + scene.elements[i].contact_diameter;
  Proximity near{false, false};
  if (scene.environment.hasSeabed())
  {
    const Seabed::Place floor = scene.environment.floorAt(middle);
    near.floor = (middle.z() - floor.z) * floor.normal.z() < REACH_MARGIN * reach;
  }
  const std::vector<Obstacle>& obstacles = scene.environment.obstacles();
  for (std::size_t k = 0; k < obstacles.size() && !near.obstacle; ++k)
  {
    const double range = enclosingRadius(obstacles[k]) + reach;
    near.obstacle = (middle - scene.state.obstacles[k].position).squaredNorm() < range * range;
  }
  return near;
}

ContactPoint seabedContactPoint(const ContactScene& scene, const TetherPoint& at, double diameter)
{
  const Seabed& bed = *scene.environment.seabed();
  const FrictionState& memory = scene.state.contact;
  const Seabed::Place floor = scene.environment.floorAt(at.r);
  ContactPoint surface;
  surface.stiffness = bed.normal_stiffness * diameter;
  surface.damping = std::max(bed.damping, STEP_DAMPING * memory.step * bed.normal_stiffness) * diameter;
  surface.friction = bed.friction;
  surface.penetration = 0.5 * diameter - (at.r.z() - floor.z) * floor.normal.z();
  surface.normal = floor.normal;
  surface.velocity = at.v;
  surface.friction_mode = memory.friction;
  if (!memory.seabed.empty())
    surface.stretch = at.r + at.drift - memory.seabed[at.index];
  return surface;
}

int deepestObstacle(const ContactScene& scene, const TetherPoint& at, double diameter, ContactPoint& surface)
{
  int deepest = -1;
  surface.penetration = 0.0;
  const FrictionState& memory = scene.state.contact;
  const std::vector<Obstacle>& obstacles = scene.environment.obstacles();
  for (std::size_t k = 0; k < obstacles.size(); ++k)
  {
    const ObstacleMotion& motion = scene.state.obstacles[k];
    const Vector3 offset = at.r - motion.position;
    const double reach = enclosingRadius(obstacles[k]) + diameter;
    if (offset.squaredNorm() > reach * reach)
      continue;
    const SignedDistance gap = signedDistance(obstacles[k], offset);
    const double penetration = 0.5 * diameter - gap.distance;
    if (!(penetration > surface.penetration))
      continue;
    deepest = static_cast<int>(k);
    surface.stiffness = obstacles[k].stiffness * diameter;
    surface.damping = std::max(OBSTACLE_DAMPING, STEP_DAMPING * memory.step) * surface.stiffness;
    surface.friction = obstacles[k].friction;
    surface.penetration = penetration;
    surface.normal = gap.normal;
    surface.curvature = gap.curvature;
    surface.velocity = at.v - motion.velocity;
    surface.friction_mode = memory.friction;
    if (!memory.obstacle.empty())
      surface.stretch =
          at.r + at.drift - memory.obstacle[at.index] - (motion.position - memory.obstacle_position[k]);
  }
  return deepest;
}

}  // namespace tether_monitor::core
