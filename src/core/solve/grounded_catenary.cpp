#include "tether_monitor/core/solve/grounded_catenary.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "tether_monitor/core/solve/initial_guess.h"

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

// A surface that a tether comes to from one side: its height under or over a point, and where it lies on it.
template <typename Level>
NodeField catenaryOnLevel(const CableModel& model, const Vector3& vessel, const Vector3& vehicle, double side,
                          const Vector3& drift, const Level& levelAt)
{
  const double L = model.length(), l = L / model.elements();
  const auto heightOver = [&](const Vector3& p) { return std::max(side * (p.z() - levelAt(p)), 0.0); };
  Leg first{heightOver(vessel), 1.0}, last{heightOver(vehicle), 1.0};
  Vector3 way = vehicle - vessel;
  way.z() = 0.0;
  const double span = way.norm();
  const Vector3 ahead = span > 1e-9 ? Vector3(way / span) : Vector3::UnitX();
  const Vector3 aside = Vector3::UnitZ().cross(ahead);
  if (span >= L)
    return {};

  // Both legs have the same horizontal force: one parameter a, found from what the legs are longer than their
  // spans.
  const auto slack = [&](double a)
  {
    first.a = last.a = a;
    return first.length() - first.span() + last.length() - last.span();
  };
  const double least = LEAST_RADIUS * l;
  double low = least, high = 1e3 * L;
  if (slack(low) > L - span)
  {
    for (int i = 0; i < 100; ++i)
    {
      const double a = std::sqrt(low * high);
      (slack(a) > L - span ? low : high) = a;
    }
    slack(std::sqrt(low * high));
  }
  else
  {
    slack(least);
  }
  const double lying = L - first.length() - last.length();
  if (lying < 0.0)
    return {};
  const double chord = span - first.span() - last.span();
  const Arc arc(lying, std::abs(chord));
  const double direction = chord < 0.0 ? -1.0 : 1.0;
  // In a flow it trails: a catenary in plan.
  const bool trails = drift.norm() > 0.0;
  const Vector3 foot = first.span() * ahead;
  const Catenary trail(foot, foot + chord * ahead, std::max(lying, 1e-9), trails ? drift : aside, least);

  NodeField shape(model.nodes());
  for (int i = 0; i < model.nodes(); ++i)
  {
    const double s = model.arcLength(i);
    double x, y = 0.0, up = 0.0, heading = 0.0, slope = 0.0;
    if (s < first.length())
    {
      const double from_floor = first.length() - s;
      x = first.span() - first.along(from_floor);
      up = first.up(from_floor);
      slope = -first.slope(from_floor);
    }
    else if (s <= first.length() + lying && trails)
    {
      const Vector3 place = trail.position(s - first.length()), t = trail.tangent(s - first.length());
      x = place.dot(ahead);
      y = place.dot(aside);
      heading = std::atan2(t.dot(aside), t.dot(ahead));
    }
    else if (s <= first.length() + lying)
    {
      arc.at(s - first.length(), x, y, heading);
      x = first.span() + direction * x;
      if (direction < 0.0)
        heading = M_PI - heading;
    }
    else
    {
      const double from_floor = s - first.length() - lying;
      x = first.span() + chord + last.along(from_floor);
      up = last.up(from_floor);
      slope = last.slope(from_floor);
    }
    Vector3 r = vessel + x * ahead + y * aside;
    r.z() = levelAt(r) + side * up;
    const Vector3 t =
        (std::cos(heading) * ahead + std::sin(heading) * aside + side * slope * Vector3::UnitZ()).normalized();
    shape[i] << r, t;
  }
  shape.front().head<3>() = vessel;
  shape.back().head<3>() = vehicle;
  return shape;
}
}  // namespace

NodeField groundedCatenary(const CableModel& model, const Vector3& vessel, const Vector3& vehicle)
{
  const double radius = 0.5 * model.element(0).diameter;
  return catenaryOnLevel(model, vessel, vehicle, 1.0, Vector3::Zero(),
                         [&](const Vector3& p) { return model.sea().floorAt(p).z + radius; });
}

NodeField floatingCatenary(const CableModel& model, const Vector3& vessel, const Vector3& vehicle,
                           const Vector3& drift)
{
  const double level = floatingHeight(model).value_or(0.0);
  return catenaryOnLevel(model, vessel, vehicle, -1.0, drift, [&](const Vector3&) { return level; });
}

std::optional<double> floatingHeight(const CableModel& model)
{
  const ElementParameters& e = model.element(0);
  const double displaced = model.sea().density() * e.area;
  if (!(e.mass < displaced))
    return std::nullopt;
  return e.diameter * (0.5 - e.mass / displaced);
}

}  // namespace tether_monitor::core
