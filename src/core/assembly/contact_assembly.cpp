#include "tether_monitor/core/assembly/contact_assembly.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/assembly/cable_model.h"
#include "tether_monitor/core/contact/contact_law.h"
#include "tether_monitor/core/element/hermite_shape_functions.h"
#include "tether_monitor/core/element/quadrature.h"

namespace tether_monitor::core
{
namespace
{
constexpr double STEP_DAMPING = 0.5;  // least damping over stiffness and time step [-], (M22)
constexpr int POINTS = static_cast<int>(QUADRATURE.size());

// An integration point of an element: where it is and how it moves as a piece of the tether.
struct Point
{
  int index;  // into the memory of friction
  double weight;
  ShapeValues shape;
  Vector3 r, v;
  Vector3 drift;  // way of the material through the point since the memory was written
};

Point pointAt(const CableModel& model, int i, int g, const CableState& state, const ElementCoords& q,
              const ElementCoords& v)
{
  const ElementParameters& p = model.element(i);
  const QuadraturePoint& gauss = QUADRATURE[g];
  Point point{POINTS * i + g,  gauss.weight * p.length, shapeFunctions(gauss.xi, p.length),
              Vector3::Zero(), Vector3::Zero(),         Vector3::Zero()};
  point.r = interpolate(point.shape, q);
  point.v = interpolate(point.shape, v);
  if (p.flow.active)
  {
    const Vector3 slope = interpolate(shapeSlopes(gauss.xi, p.length), q);
    const double c = p.flow.at(gauss.xi);
    point.v += p.flow.growth * (point.shape[1] * q.segment<3>(3) + point.shape[3] * q.segment<3>(9)) + c * slope;
    point.drift = c * (state.time - state.contact.time) * slope;
  }
  return point;
}

ContactPoint floorUnder(const CableModel& model, const CableState& state, const Point& at, double diameter)
{
  const Seabed& bed = *model.sea().environment().seabed;
  const Seabed::Place floor = model.sea().floorAt(at.r);
  const double damping = std::max(bed.damping, STEP_DAMPING * state.contact.step * bed.normal_stiffness);
  ContactPoint surface{bed.normal_stiffness * diameter,
                       damping * diameter,
                       bed.friction,
                       0.5 * diameter - (at.r.z() - floor.z) * floor.normal.z(),
                       floor.normal,
                       Matrix3::Zero(),
                       at.v,
                       Vector3::Zero(),
                       state.contact.friction};
  if (!state.contact.seabed.empty())
    surface.stretch = at.r + at.drift - state.contact.seabed[at.index];
  return surface;
}

// The obstacle that a point is deepest in, or -1.
int deepestObstacle(const CableModel& model, const CableState& state, const Point& at, double diameter,
                    ContactPoint& surface)
{
  int deepest = -1;
  surface.penetration = 0.0;
  const std::vector<Obstacle>& obstacles = model.sea().environment().obstacles;
  for (std::size_t k = 0; k < obstacles.size(); ++k)
  {
    const Vector3 offset = at.r - state.obstacles[k].position;
    const double reach = enclosingRadius(obstacles[k]) + diameter;
    if (offset.squaredNorm() > reach * reach)
      continue;
    const SignedDistance gap = signedDistance(obstacles[k], offset);
    const double penetration = 0.5 * diameter - gap.distance;
    if (!(penetration > surface.penetration))
      continue;
    deepest = static_cast<int>(k);
    const double k_d = obstacles[k].stiffness * diameter;
    const double damping = std::max(OBSTACLE_DAMPING, STEP_DAMPING * state.contact.step) * k_d;
    surface = {k_d,
               damping,
               obstacles[k].friction,
               penetration,
               gap.normal,
               gap.curvature,
               at.v - state.obstacles[k].velocity,
               Vector3::Zero(),
               state.contact.friction};
    if (!state.contact.obstacle.empty())
      surface.stretch = at.r + at.drift - state.contact.obstacle[at.index] -
                        (state.obstacles[k].position - state.contact.obstacle_position[k]);
  }
  return deepest;
}

// Whether any point of an element may touch the floor, or an obstacle.
struct Nearness
{
  bool floor, obstacle;
};

Nearness nearness(const CableModel& model, const CableState& state, int i)
{
  const Vector3 a = state.q[i].head<3>(), b = state.q[i + 1].head<3>();
  const Vector3 middle = 0.5 * (a + b);
  const double reach = std::max(model.element(i).length, (b - a).norm()) + model.element(i).diameter;
  Nearness near{false, false};
  if (model.sea().hasSeabed())
  {
    const Seabed::Place floor = model.sea().floorAt(middle);
    near.floor = (middle.z() - floor.z) * floor.normal.z() < 1.5 * reach;
  }
  const std::vector<Obstacle>& obstacles = model.sea().environment().obstacles;
  for (std::size_t k = 0; k < obstacles.size() && !near.obstacle; ++k)
  {
    const double range = enclosingRadius(obstacles[k]) + reach;
    near.obstacle = (middle - state.obstacles[k].position).squaredNorm() < range * range;
  }
  return near;
}

// Calls visit(point, touch, obstacle) for every contact of element i; obstacle -1 is the seabed.
template <typename Visit>
void forContacts(const CableModel& model, const CableState& state, int i, const TangentWeights& w,
                 const Visit& visit)
{
  const Nearness near = nearness(model, state, i);
  if (!near.floor && !near.obstacle)
    return;
  const double diameter = model.element(i).diameter;
  const ElementCoords q = elementCoords(state.q, i), v = elementCoords(state.v, i);
  for (int g = 0; g < POINTS; ++g)
  {
    const Point at = pointAt(model, i, g, state, q, v);
    if (near.floor)
    {
      const ContactResponse contact = contactForce(floorUnder(model, state, at, diameter), diameter, w);
      if (contact.normal_force > 0.0)
        visit(at, contact, -1);
    }
    ContactPoint surface;
    const int obstacle = near.obstacle ? deepestObstacle(model, state, at, diameter, surface) : -1;
    if (obstacle >= 0)
    {
      const ContactResponse contact = contactForce(surface, diameter, w);
      if (contact.normal_force > 0.0)
        visit(at, contact, obstacle);
    }
  }
}
}  // namespace

BorderedSystem borderedSystemFor(const CableModel& model, std::vector<int>& movable)
{
  std::vector<bool> has_mass;
  movable.clear();
  for (const Obstacle& obstacle : model.environment().obstacles)
  {
    has_mass.push_back(obstacle.mass > 0.0);
    if (has_mass.back())
      movable.push_back(static_cast<int>(has_mass.size()) - 1);
  }
  return movable.empty() ? BorderedSystem() : BorderedSystem(has_mass, model.nodes());
}

void addContact(const CableModel& model, const CableState& state, const TangentWeights& weights,
                NodeField& residual, BlockTridiagonal* tangent, BorderedSystem* border)
{
  ElementMatrix J;
  for (int i = 0; i < model.elements(); ++i)
  {
    bool any = false;
    forContacts(model, state, i, weights,
                [&](const Point& at, const ContactResponse& contact, int obstacle)
                {
                  if (!any && tangent)
                    J.setZero();
                  any = true;
                  for (int a = 0; a < 4; ++a)
                  {
                    const double share = at.weight * at.shape[a];
                    NodeCoords& row = residual[i + a / 2];
                    row.segment<3>(3 * (a % 2)) -= share * contact.force;
                    if (tangent)
                      for (int b = 0; b < 4; ++b)
                        J.block<3, 3>(3 * a, 3 * b) += share * at.shape[b] * contact.stiffness;
                  }
                  if (!border || obstacle < 0 || !border->has(obstacle))
                    return;
                  border->residual(obstacle) += at.weight * contact.force;
                  border->diagonal(obstacle) += at.weight * contact.stiffness;
                  for (int a = 0; a < 4; ++a)
                  {
                    const double share = at.weight * at.shape[a];
                    const int node = i + a / 2, part = 3 * (a % 2);
                    border->column(obstacle, node).middleRows<3>(part) -= share * contact.stiffness;
                    border->row(obstacle, node).middleRows<3>(part) -= share * contact.stiffness.transpose();
                  }
                });
    if (any && tangent)
      tangent->addElement(i, J);
  }
}

ElementCoords elementContact(const CableModel& model, int i, const CableState& state)
{
  ElementCoords sum = ElementCoords::Zero();
  forContacts(model, state, i, TangentWeights{},
              [&](const Point& at, const ContactResponse& contact, int)
              {
                for (int a = 0; a < 4; ++a)
                  sum.segment<3>(3 * a) -= at.weight * at.shape[a] * contact.force;
              });
  return sum;
}

void initializeContact(const CableModel& model, CableState& state)
{
  const std::vector<Obstacle>& obstacles = model.sea().environment().obstacles;
  state.obstacles.assign(obstacles.size(), ObstacleMotion());
  for (std::size_t k = 0; k < obstacles.size(); ++k)
  {
    state.obstacles[k].position = obstacles[k].position - model.sea().origin();
    state.obstacles[k].velocity = obstacles[k].velocity;
  }
  FrictionState& memory = state.contact;
  memory.obstacle_position.assign(obstacles.size(), Vector3::Zero());
  memory.seabed.assign(model.sea().hasSeabed() ? POINTS * model.elements() : 0, Vector3::Zero());
  memory.obstacle.assign(obstacles.empty() ? 0 : POINTS * model.elements(), Vector3::Zero());
  memory.friction = FrictionMode::SLIP;  // no springs to carry over
  commitFriction(model, state);
  memory.friction = FrictionMode::COULOMB;
}

void commitFriction(const CableModel& model, CableState& state)
{
  FrictionState& memory = state.contact;
  if (memory.seabed.empty() && memory.obstacle.empty())
    return;
  for (int i = 0; i < model.elements(); ++i)
  {
    // Where nothing is touched, a spring is tied to where the point is.
    std::array<Vector3, POINTS> bed, other;
    const ElementCoords q = elementCoords(state.q, i), v = elementCoords(state.v, i);
    for (int g = 0; g < POINTS; ++g)
      bed[g] = other[g] = pointAt(model, i, g, state, q, v).r;
    forContacts(model, state, i, TangentWeights{},
                [&](const Point& at, const ContactResponse& contact, int obstacle)
                { (obstacle < 0 ? bed : other)[at.index - POINTS * i] = at.r - contact.stretch; });
    for (int g = 0; g < POINTS; ++g)
    {
      if (!memory.seabed.empty())
        memory.seabed[POINTS * i + g] = bed[g];
      if (!memory.obstacle.empty())
        memory.obstacle[POINTS * i + g] = other[g];
    }
  }
  for (std::size_t k = 0; k < state.obstacles.size(); ++k)
    memory.obstacle_position[k] = state.obstacles[k].position;
  memory.time = state.time;
}

void summarizeContact(const CableModel& model, const CableState& state, ContactSummary& summary)
{
  summary.seabed_length = summary.energy = 0.0;
  summary.touchdown_s = -1.0;
  for (ContactSummary::ObstacleContact& entry : summary.obstacles)
    entry = ContactSummary::ObstacleContact();
  if (!model.hasContact())
    return;
  for (int i = 0; i < model.elements(); ++i)
    forContacts(model, state, i, TangentWeights{},
                [&](const Point& at, const ContactResponse& contact, int obstacle)
                {
                  const double s =
                      model.arcLength(i) + QUADRATURE[at.index - POINTS * i].xi * model.element(i).length;
                  summary.energy += at.weight * contact.energy;
                  if (obstacle < 0)
                  {
                    summary.seabed_length += at.weight;
                    if (summary.touchdown_s < 0.0)
                      summary.touchdown_s = s;
                    return;
                  }
                  ContactSummary::ObstacleContact& entry = summary.obstacles[obstacle];
                  const double load = at.weight * contact.normal_force;
                  entry.force -= at.weight * contact.force;
                  entry.place += load * at.r;
                  entry.s += load * s;
                  entry.largest = std::max(entry.largest, contact.normal_force);
                  entry.total += load;
                });
  for (ContactSummary::ObstacleContact& entry : summary.obstacles)
    if (entry.total > 0.0)
    {
      entry.place /= entry.total;
      entry.s /= entry.total;
    }
}

}  // namespace tether_monitor::core
