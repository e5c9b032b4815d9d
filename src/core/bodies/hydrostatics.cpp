#include "tether_monitor/core/bodies/hydrostatics.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/element/submergence.h"

namespace tether_monitor::core
{
namespace
{
constexpr int COLUMNS_ALONG = 8, COLUMNS_ACROSS = 4;  // of a hull

// A column of water of height `wet` over an area, its centre at `arm`: pushes up with rho g area wet.
struct Column
{
  double weight;  // rho g, or what stands for it
  double wet;
  bool pierces;
  Vector3 arm;
  double area;
};

void addColumn(const Column& column, Hydrostatics& sum)
{
  const double force = column.weight * column.area * column.wet;
  const Vector3& arm = column.arm;
  const Vector3 moment(arm.y(), -arm.x(), 0.0);  // arm x z
  sum.force += force;
  sum.submerged_volume += column.area * column.wet;
  sum.moment += force * moment;
  const double stiffness = column.pierces ? column.weight * column.area : 0.0;
  sum.heave_stiffness += stiffness;
  // A rotation moves the column by rotation x arm; its height above the old place is moment' of the rotation.
  sum.force_rotation -= stiffness * moment;
  sum.moment_heave -= stiffness * moment;
  sum.moment_rotation -= stiffness * moment * moment.transpose();
  // d(arm x z) / d rotation = (rotation x arm) x z.
  sum.moment_rotation += force * (arm * Vector3::UnitZ().transpose() - arm.z() * Matrix3::Identity());
}

Hydrostatics hullHydrostatics(const Hull& hull, const EnvironmentModel& environment, double t,
                              const Vector3& centre, const Matrix3& R)
{
  Hydrostatics sum;
  const double weight = environment.density() * environment.gravity();
  const double area = hull.size.x() * hull.size.y() / (COLUMNS_ALONG * COLUMNS_ACROSS);
  const Vector3& origin = environment.origin();
  for (int i = 0; i < COLUMNS_ALONG; ++i)
    for (int j = 0; j < COLUMNS_ACROSS; ++j)
    {
      const Vector3 foot = hull.keel + Vector3(((i + 0.5) / COLUMNS_ALONG - 0.5) * hull.size.x(),
                                               ((j + 0.5) / COLUMNS_ACROSS - 0.5) * hull.size.y(), 0.0);
      const Vector3 below = R * foot;
      const double surface = environment.waves().elevation(centre.x() + below.x() + origin.x(),
                                                           centre.y() + below.y() + origin.y(), t);
      const double depth = surface - (centre.z() + below.z());
      const double wet = std::clamp(depth, 0.0, hull.size.z());
      if (wet > 0.0)
        addColumn({weight, wet, wet < hull.size.z(), R * (foot + 0.5 * wet * Vector3::UnitZ()), area}, sum);
    }
  sum.submerged_fraction = std::clamp(sum.submerged_volume / (hull.size.prod() * 0.5), 0.0, 1.0);
  return sum;
}

Hydrostatics volumeHydrostatics(const RigidBody& body, const EnvironmentModel& environment, double surface,
                                const Vector3& centre, const Matrix3& R)
{
  Hydrostatics sum;
  const double extent = std::cbrt(body.volume) + 1e-6;
  const Submergence<double> wet = submergence(centre.z() - surface, extent);
  const double whole = environment.density() * environment.gravity() * body.volume;
  addColumn({whole, wet.fraction, false, R * body.center_of_buoyancy, 1.0}, sum);
  sum.submerged_volume = body.volume * wet.fraction;
  sum.submerged_fraction = wet.fraction;
  sum.heave_stiffness = whole * wet.slope;
  if (wet.fraction > 0.0)
    sum.moment_heave = -sum.moment * (wet.slope / wet.fraction);
  return sum;
}
}  // namespace

Hydrostatics hydrostatics(const RigidBody& body, const EnvironmentModel& environment, double t,
                          const WaterKinematics& water, const Vector3& centre, const Matrix3& R)
{
  return body.hull ? hullHydrostatics(*body.hull, environment, t, centre, R)
                   : volumeHydrostatics(body, environment, water.surface, centre, R);
}

}  // namespace tether_monitor::core
