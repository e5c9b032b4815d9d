#include "tether_monitor/core/solve/grounded_catenary.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "tether_monitor/core/solve/catenary.h"

namespace tether_monitor::core
{
namespace
{
constexpr double LEAST_RADIUS = 0.5;  // of a bend at the floor, in elements

// A catenary that leaves the floor tangentially and rises to a height; parameter a [m].
struct Leg
{
  double height, a;

  double length() const { return std::sqrt(height * (height + 2.0 * a)); }
  double span() const { return a * std::asinh(length() / a); }
  // At arc length s from the floor: along the floor, up, and the slope of the tangent.
  double along(double s) const { return a * std::asinh(s / a); }
  double up(double s) const { return std::hypot(a, s) - a; }
  double slope(double s) const { return s / a; }
};

// What rests on the level: in plan an arc of a given length over a given chord, straight if they are equal.
struct Arc
{
  Arc(double arc_length, double arc_chord) : length(arc_length)
  {
    const double ratio = std::clamp(arc_chord / std::max(arc_length, 1e-12), 0.0, 1.0);
    // sin(x) / x = ratio for half the opening angle x, up to nearly a full circle.
    double low = 0.0, high = 0.95 * M_PI;
    for (int i = 0; i < 60; ++i)
    {
      const double x = 0.5 * (low + high);
      (std::sin(x) / x > ratio ? low : high) = x;
    }
    half_angle = 0.5 * (low + high);
    if (ratio > 1.0 - 1e-9)
      half_angle = 0.0;
  }

  // Place along and across the chord at arc length s, and the direction there.
  void at(double s, double& x, double& y, double& heading) const
  {
    heading = half_angle * (1.0 - 2.0 * s / std::max(length, 1e-12));
    if (half_angle < 1e-6)
    {
      x = s;
      y = 0.0;
      return;
    }
    const double radius = 0.5 * length / half_angle;
    x = radius * (std::sin(half_angle) - std::sin(heading));
    y = radius * (std::cos(heading) - std::cos(half_angle));
  }

  double length, half_angle;
};

// A tether that comes from one side to a level on which a part of it lies.
struct LyingTether
{
  Leg first, last;  // from each end to the level
  double lying;     // length on the level
  double chord;     // between the touchdown points; < 0: they overlap
};

// Both legs have the same horizontal force: one parameter a, found from what the legs are longer than their spans.
// Nothing if a tether of this length does not reach the level.
std::optional<LyingTether> findLegs(double height_first, double height_last, double length, double span,
                                    double least)
{
  LyingTether t{{height_first, 1.0}, {height_last, 1.0}, 0.0, 0.0};
  const auto slack = [&](double a)
  {
    t.first.a = t.last.a = a;
    return t.first.length() - t.first.span() + t.last.length() - t.last.span();
  };
  double low = least, high = 1e3 * length;
  if (slack(low) > length - span)
  {
    for (int i = 0; i < 100; ++i)
    {
      const double a = std::sqrt(low * high);
      (slack(a) > length - span ? low : high) = a;
    }
    slack(std::sqrt(low * high));
  }
  else
  {
    slack(least);
  }
  t.lying = length - t.first.length() - t.last.length();
  t.chord = span - t.first.span() - t.last.span();
  return t.lying < 0.0 ? std::nullopt : std::optional<LyingTether>(t);
}

// A point of it: along and across the line between the ends, above the level; heading in plan, slope of the
// tangent.
struct PlanPoint
{
  double x = 0.0, y = 0.0, up = 0.0, heading = 0.0, slope = 0.0;
};

// Arc length s from the first end. What lies is an arc, or a catenary in plan where a flow carries it.
PlanPoint pointAt(const LyingTether& t, const Arc& arc, const Catenary* trail, const Vector3& ahead,
                  const Vector3& aside, double s)
{
  PlanPoint p;
  if (s < t.first.length())
  {
    const double from_floor = t.first.length() - s;
    p.x = t.first.span() - t.first.along(from_floor);
    p.up = t.first.up(from_floor);
    p.slope = -t.first.slope(from_floor);
  }
  else if (s <= t.first.length() + t.lying && trail)
  {
    const Vector3 place = trail->position(s - t.first.length()), direction = trail->tangent(s - t.first.length());
    p.x = place.dot(ahead);
    p.y = place.dot(aside);
    p.heading = std::atan2(direction.dot(aside), direction.dot(ahead));
  }
  else if (s <= t.first.length() + t.lying)
  {
    const bool overlaps = t.chord < 0.0;
    arc.at(s - t.first.length(), p.x, p.y, p.heading);
    p.x = t.first.span() + (overlaps ? -p.x : p.x);
    if (overlaps)
      p.heading = M_PI - p.heading;
  }
  else
  {
    const double from_floor = s - t.first.length() - t.lying;
    p.x = t.first.span() + t.chord + t.last.along(from_floor);
    p.up = t.last.up(from_floor);
    p.slope = t.last.slope(from_floor);
  }
  return p;
}

// The nodes of a tether that comes to a level from one side: +1 from above, -1 from below.
template <typename Level>
NodeField catenaryOnLevel(const DeployedCable& cable, const Vector3& vessel, const Vector3& vehicle, double side,
                          const Vector3& drift, const Level& levelAt)
{
  const double L = cable.length(), least = LEAST_RADIUS * L / cable.elements();
  const auto heightOver = [&](const Vector3& p) { return std::max(side * (p.z() - levelAt(p)), 0.0); };
  Vector3 way = vehicle - vessel;
  way.z() = 0.0;
  const double span = way.norm();
  const Vector3 ahead = span > 1e-9 ? Vector3(way / span) : Vector3::UnitX();
  const Vector3 aside = Vector3::UnitZ().cross(ahead);
  if (span >= L)
    return {};
  const std::optional<LyingTether> t = findLegs(heightOver(vessel), heightOver(vehicle), L, span, least);
  if (!t)
    return {};
  const Arc arc(t->lying, std::abs(t->chord));
  const bool trails = drift.norm() > 0.0;
  const Vector3 touchdown = t->first.span() * ahead;
  const Catenary trail(touchdown, touchdown + t->chord * ahead, std::max(t->lying, 1e-9), trails ? drift : aside,
                       least);

  NodeField shape(cable.nodes());
  for (int i = 0; i < cable.nodes(); ++i)
  {
    const PlanPoint p = pointAt(*t, arc, trails ? &trail : nullptr, ahead, aside, cable.arcLength(i));
    Vector3 r = vessel + p.x * ahead + p.y * aside;
    r.z() = levelAt(r) + side * p.up;
    const Vector3 direction =
        std::cos(p.heading) * ahead + std::sin(p.heading) * aside + side * p.slope * Vector3::UnitZ();
    shape[i] << r, direction.normalized();
  }
  shape.front().head<3>() = vessel;
  shape.back().head<3>() = vehicle;
  return shape;
}
}  // namespace

NodeField groundedCatenary(const DeployedCable& cable, const Vector3& vessel, const Vector3& vehicle)
{
  const double radius = 0.5 * cable.element(0).contact_diameter;
  return catenaryOnLevel(cable, vessel, vehicle, 1.0, Vector3::Zero(),
                         [&](const Vector3& p) { return cable.environment().floorAt(p).z + radius; });
}

NodeField floatingCatenary(const DeployedCable& cable, const Vector3& vessel, const Vector3& vehicle,
                           const Vector3& drift)
{
  const double level = floatingHeight(cable).value_or(0.0);
  return catenaryOnLevel(cable, vessel, vehicle, -1.0, drift, [&](const Vector3&) { return level; });
}

std::optional<double> floatingHeight(const DeployedCable& cable)
{
  const ElementParameters& e = cable.element(0);
  const double displaced = cable.environment().density() * e.area;
  if (!(e.mass < displaced))
    return std::nullopt;
  return e.diameter * (0.5 - e.mass / displaced);
}

}  // namespace tether_monitor::core
