#include "tether_monitor/core/assembly/station_profile.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "tether_monitor/core/element/element_coordinates.h"
#include "tether_monitor/core/element/hermite_shape_functions.h"
#include "tether_monitor/core/element/quadrature.h"

namespace tether_monitor::core
{
namespace
{
Vector3 direction(const NodeCoords& node)
{
  const Vector3 slope = node.tail<3>();
  const double norm = slope.norm();
  return norm > 1e-9 ? Vector3(slope / norm) : Vector3::Zero();
}

double radiusOfCurvature(const Vector3& slope, const Vector3& curvature)
{
  const double turn = slope.cross(curvature).norm();
  const double stretch = slope.norm();
  return turn > 0.0 ? stretch * stretch * stretch / turn : std::numeric_limits<double>::infinity();  // (M18)
}

// Between two broken ends: no tether, so nothing that it carries.
void clearParted(int i, StationProfile& profile)
{
  profile.tension[2 * i + 1] = profile.stress[2 * i + 1] = profile.strain[2 * i + 1] = 0.0;
  profile.bend_radius[2 * i + 1] = std::numeric_limits<double>::infinity();
}

// Nodes get the mean of their elements, both ends are extrapolated from the two nearest elements.
void interpolateStrain(std::vector<double>& strain)
{
  const std::size_t last = strain.size() - 1;
  for (std::size_t i = 2; i < last; i += 2)
    strain[i] = 0.5 * (strain[i - 1] + strain[i + 1]);
  strain[0] = last > 2 ? 1.5 * strain[1] - 0.5 * strain[3] : strain[1];
  strain[last] = last > 2 ? 1.5 * strain[last - 1] - 0.5 * strain[last - 3] : strain[1];
}
}  // namespace

StationProfile::StationProfile(int elements)
{
  const std::size_t n = 2 * elements + 1;
  s.assign(n, 0.0);
  position.assign(n, Vector3::Zero());
  tension.assign(n, 0.0);
  strain.assign(n, 0.0);
  bend_radius.assign(n, 0.0);
  stress.assign(n, 0.0);
}

void computeStations(const DeployedCable& cable, const CableState& state, StationProfile& profile)
{
  const int N = cable.elements();
  profile.stretched_length = 0.0;
  profile.max_element_rotation = 0.0;
  Vector3 curvature_before = Vector3::Zero();
  std::array<ElementCoords, kernel::BLOCK> parts;
  for (int i = 0; i < N; ++i)
  {
    const double l = cable.element(i).length;
    const ElementCoords q = elementCoords(cable.element(i), state.q, i);
    if (i % kernel::BLOCK == 0)
      cable.elementResiduals(i, state, parts);
    const ElementCoords& force = parts[i % kernel::BLOCK];
    const Vector3 ta = direction(state.q[i]);
    const Vector3 tb = direction(state.q[i + 1]);

    // The force that an element receives at a node is what the tether carries there, (M14).
    const double tension_a = -force.segment<3>(0).dot(ta);
    const double tension_b = force.segment<3>(6).dot(tb);
    profile.tension[2 * i] = i == 0 ? tension_a : 0.5 * (profile.tension[2 * i] + tension_a);
    profile.tension[2 * i + 1] = 0.5 * (tension_a + tension_b);
    profile.tension[2 * i + 2] = tension_b;
    const double area = cable.model().elementProperties(i).stressArea();
    const double stress_a = profile.tension[2 * i] / area;
    profile.stress[2 * i] = i == 0 ? stress_a : std::max(stress_a, profile.stress[2 * i]);
    profile.stress[2 * i + 1] = profile.tension[2 * i + 1] / area;
    profile.stress[2 * i + 2] = tension_b / area;

    const Vector3 curvature_a = interpolate(shapeCurvatures(0.0, l), q);
    const Vector3 curvature_b = interpolate(shapeCurvatures(1.0, l), q);
    const bool parted = cable.element(i).parted, parted_before = i > 0 && cable.element(i - 1).parted;
    const Vector3 at_a = i == 0 || parted_before ? curvature_a
                         : parted                ? curvature_before
                                                 : Vector3(0.5 * (curvature_before + curvature_a));
    profile.bend_radius[2 * i] = radiusOfCurvature(q.segment<3>(3), at_a);
    profile.bend_radius[2 * i + 1] =
        radiusOfCurvature(interpolate(shapeSlopes(0.5, l), q), interpolate(shapeCurvatures(0.5, l), q));
    profile.bend_radius[2 * i + 2] = radiusOfCurvature(q.segment<3>(9), curvature_b);
    curvature_before = curvature_b;

    for (int half = 0; half < 2; ++half)
    {
      profile.s[2 * i + half] = cable.arcLength(i) + 0.5 * half * l;
      profile.position[2 * i + half] = interpolate(shapeFunctions(0.5 * half, l), q);
    }
    if (i == 0)
      profile.ends.vessel = -force.segment<3>(0);
    if (i == N - 1)
      profile.ends.vehicle = -force.segment<3>(6);
    if (parted)
    {
      clearParted(i, profile);
      continue;
    }
    double stretch = 0.0;
    for (const QuadraturePoint& point : QUADRATURE)
      stretch += point.weight * interpolate(shapeSlopes(point.xi, l), q).norm();
    profile.stretched_length += l * stretch;
    profile.strain[2 * i + 1] = stretch / cable.element(i).natural_stretch - 1.0;
    profile.max_element_rotation =
        std::max(profile.max_element_rotation, std::acos(std::clamp(ta.dot(tb), -1.0, 1.0)));
  }
  setClampMoments(cable, state, profile.ends);
  profile.vessel_direction = direction(state.q.front());
  profile.vehicle_direction = direction(state.q.back());
  profile.s[2 * N] = cable.length();
  profile.position[2 * N] = state.q[N].head<3>();
  interpolateStrain(profile.strain);
}

}  // namespace tether_monitor::core
