#include "tether_monitor/core/bodies/seabed_landing.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::core
{
namespace
{
constexpr double FRICTION_REGULARISATION_SPEED = 0.01;  // [m/s] at which half of the friction acts
constexpr double DAMPER_START = 0.1;                    // penetration over radius at which the damper acts fully
}  // namespace

SeabedReaction seabedReaction(const RigidBody& body, const EnvironmentModel& environment, const Vector3& centre,
                              const Vector3& velocity, const TangentWeights& w)
{
  SeabedReaction out;
  if (!environment.hasSeabed() || body.hull)
    return out;
  const double radius = 0.5 * std::cbrt(body.volume);
  const Seabed::Place floor = environment.floorAt(centre);
  const double penetration = radius - (centre.z() - floor.z) * floor.normal.z();
  if (penetration <= 0.0)
    return out;
  const Seabed& bed = *environment.seabed();
  const double area = M_PI * radius * radius;
  const double share = std::min(penetration / (DAMPER_START * radius), 1.0);
  const double N = area * (bed.normal_stiffness * penetration - share * bed.damping * floor.normal.dot(velocity));
  if (N <= 0.0)
    return out;
  const Matrix3 P = Matrix3::Identity() - floor.normal * floor.normal.transpose();
  const Vector3 slide = P * velocity;
  const double slow = slide.norm() + FRICTION_REGULARISATION_SPEED;
  out.force = N * floor.normal - bed.friction * N / slow * slide;
  out.stiffness = area * (w.stiffness * bed.normal_stiffness + w.damping * share * bed.damping) * floor.normal *
                      floor.normal.transpose() +
                  w.damping * bed.friction * N / slow * P;
  return out;
}

}  // namespace tether_monitor::core
