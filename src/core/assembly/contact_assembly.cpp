#include "tether_monitor/core/assembly/contact_assembly.h"

#include <array>

#include "tether_monitor/core/element/element_coordinates.h"

namespace tether_monitor::core
{
namespace
{
// One contact of element i into the rows and columns of the obstacle that it touches.
void addToObstacle(int i, const TetherPoint& at, const ContactResponse& contact, int obstacle,
                   BorderedSystem& bordered)
{
  bordered.residual(obstacle) += at.weight * contact.force;
  bordered.diagonal(obstacle) += at.weight * contact.stiffness;
  for (int a = 0; a < 4; ++a)
  {
    const double share = at.weight * at.shape[a];
    const int node = i + a / 2, part = 3 * (a % 2);
    bordered.column(obstacle, node).middleRows<3>(part) -= share * contact.stiffness;
    bordered.row(obstacle, node).middleRows<3>(part) -= share * contact.stiffness.transpose();
  }
}
}  // namespace

BorderedSystem borderedSystemFor(const std::vector<Obstacle>& obstacles, int nodes, std::vector<int>& movable)
{
  std::vector<bool> has_mass;
  movable.clear();
  for (const Obstacle& obstacle : obstacles)
  {
    has_mass.push_back(obstacle.mass > 0.0);
    if (has_mass.back())
      movable.push_back(static_cast<int>(has_mass.size()) - 1);
  }
  return movable.empty() ? BorderedSystem() : BorderedSystem(has_mass, nodes);
}

void addContact(const ContactScene& scene, const TangentWeights& weights, NodeField& residual,
                BlockTridiagonal* tangent, BorderedSystem* bordered)
{
  ElementMatrix J;
  ElementCoords force;
  for (int i = 0; i < static_cast<int>(scene.elements.size()); ++i)
  {
    bool any = false;
    forContacts(scene, i, weights,
                [&](const TetherPoint& at, const ContactResponse& contact, int obstacle)
                {
                  if (!any)
                  {
                    force.setZero();
                    if (tangent)
                      J.setZero();
                  }
                  any = true;
                  for (int a = 0; a < 4; ++a)
                  {
                    const double share = at.weight * at.shape[a];
                    force.segment<3>(3 * a) -= share * contact.force;
                    if (tangent)
                      for (int b = 0; b < 4; ++b)
                        J.block<3, 3>(3 * a, 3 * b) += share * at.shape[b] * contact.stiffness;
                  }
                  if (bordered && obstacle >= 0 && bordered->has(obstacle))
                    addToObstacle(i, at, contact, obstacle, *bordered);
                });
    if (!any)
      continue;
    if (tangent)
    {
      pullBack(scene.elements[i], scene.state.q, i, weights.stiffness, force, J);
      tangent->addElement(i, J);
    }
    else
    {
      pullBack(scene.elements[i], scene.state.q, i, force);
    }
    residual[i] += force.head<6>();
    residual[i + 1] += force.tail<6>();
  }
}

ElementCoords elementContact(const ContactScene& scene, int i)
{
  ElementCoords sum = ElementCoords::Zero();
  forContacts(scene, i, TangentWeights{},
              [&](const TetherPoint& at, const ContactResponse& contact, int)
              {
                for (int a = 0; a < 4; ++a)
                  sum.segment<3>(3 * a) -= at.weight * at.shape[a] * contact.force;
              });
  return sum;
}

void initializeContact(const std::vector<ElementParameters>& elements, const EnvironmentModel& environment,
                       CableState& state)
{
  const std::vector<Obstacle>& obstacles = environment.obstacles();
  state.obstacles.assign(obstacles.size(), ObstacleMotion());
  for (std::size_t k = 0; k < obstacles.size(); ++k)
  {
    state.obstacles[k].position = obstacles[k].position - environment.origin();
    state.obstacles[k].velocity = obstacles[k].velocity;
  }
  FrictionState& memory = state.contact;
  const std::size_t points = CONTACT_POINTS * elements.size();
  memory.obstacle_position.assign(obstacles.size(), Vector3::Zero());
  memory.seabed.assign(environment.hasSeabed() ? points : 0, Vector3::Zero());
  memory.obstacle.assign(obstacles.empty() ? 0 : points, Vector3::Zero());
  memory.friction = FrictionMode::SLIP;  // no springs to carry over
  commitFriction(elements, environment, state);
  memory.friction = FrictionMode::COULOMB;
}

void commitFriction(const std::vector<ElementParameters>& elements, const EnvironmentModel& environment,
                    CableState& state)
{
  FrictionState& memory = state.contact;
  if (memory.seabed.empty() && memory.obstacle.empty())
    return;
  const ContactScene scene{elements, environment, state};
  for (int i = 0; i < static_cast<int>(elements.size()); ++i)
  {
    // Where nothing is touched, a spring is tied to where the point is.
    std::array<Vector3, CONTACT_POINTS> bed, other;
    const ElementCoords q = elementCoords(elements[i], state.q, i);
    const ElementCoords v = elementRates(elements[i], state.q, state.v, i);
    for (int g = 0; g < CONTACT_POINTS; ++g)
      bed[g] = other[g] = tetherPoint(scene, i, g, q, v).r;
    forContacts(scene, i, TangentWeights{},
                [&](const TetherPoint& at, const ContactResponse& contact, int obstacle)
                { (obstacle < 0 ? bed : other)[at.index - CONTACT_POINTS * i] = at.r - contact.stretch; });
    for (int g = 0; g < CONTACT_POINTS; ++g)
    {
      if (!memory.seabed.empty())
        memory.seabed[CONTACT_POINTS * i + g] = bed[g];
      if (!memory.obstacle.empty())
        memory.obstacle[CONTACT_POINTS * i + g] = other[g];
    }
  }
  for (std::size_t k = 0; k < state.obstacles.size(); ++k)
    memory.obstacle_position[k] = state.obstacles[k].position;
  memory.time = state.time;
}

}  // namespace tether_monitor::core
