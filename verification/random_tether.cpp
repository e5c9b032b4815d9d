#include "verification/random_tether.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tether_monitor::fuzz
{
namespace
{
using core::Vector3;

constexpr double WATER = 1025.0, GRAVITY = 9.81;

double density(RandomSource& dice)
{
  const double kind = dice.uniform(0.0, 1.0);
  if (kind < 0.15)
    return dice.uniform(300.0, WATER);
  if (kind < 0.35)
    return WATER * dice.uniform(0.98, 1.02);
  if (kind < 0.7)
    return dice.uniform(WATER, 2000.0);
  return dice.uniform(2000.0, 8000.0);
}

Vector3 horizontal(RandomSource& dice, double largest)
{
  const double angle = dice.uniform(-M_PI, M_PI), speed = dice.uniform(0.0, largest);
  return {speed * std::cos(angle), speed * std::sin(angle), 0.0};
}

core::RigidBody body(RandomSource& dice, double tether_mass)
{
  core::RigidBody b;
  b.mass = tether_mass * dice.scale(0.1, 10.0) + 1.0;
  b.volume = b.mass / WATER * (dice.chance(0.5) ? dice.uniform(0.2, 0.9) : dice.uniform(0.98, 1.01));
  const double size = std::cbrt(b.volume);
  b.inertia = Vector3::Constant(0.1 * b.mass * size * size + 1e-3);
  b.added_mass = Vector3::Constant(0.5 * WATER * b.volume);
  b.drag_area = Vector3::Constant(size * size);
  return b;
}

void place(RandomSource& dice, double length, double largest_ratio, RandomTether& t)
{
  const double kind = dice.uniform(0.0, 1.0);
  double ratio = dice.uniform(0.02, 0.98);
  if (kind < 0.1)
    ratio = dice.chance(0.5) ? 0.0 : dice.uniform(0.0, 0.02);
  else if (kind < 0.3)
    ratio = dice.uniform(0.98, 1.0);
  else if (kind < 0.4)
    ratio = dice.uniform(1.0, largest_ratio);
  Vector3 direction = dice.direction();
  direction.z() = -std::abs(direction.z());
  if (dice.chance(0.1))
    direction = {0.0, 0.0, -1.0};
  t.ends.vessel = {0.0, 0.0, dice.uniform(-10.0, 0.0)};
  t.ends.vehicle = t.ends.vessel + ratio * length * direction;
  if (dice.chance(0.05))
    std::swap(t.ends.vessel, t.ends.vehicle);
}

core::CableProperties coefficients(RandomSource& dice)
{
  core::CableProperties p;
  p.drag_normal = dice.uniform(1.0, 2.0);
  p.drag_tangential = dice.uniform(0.0, 0.1);
  p.added_mass_normal = 1.0;
  p.working_load = 1e4;
  p.breaking_load = 2e4;
  return p;
}
}  // namespace

std::uint32_t RandomSource::draw()
{
  if (left_ < 4)
    return static_cast<std::uint32_t>(bits_());
  std::uint32_t x = 0;
  std::memcpy(&x, bytes_, sizeof x);
  bytes_ += sizeof x;
  left_ -= sizeof x;
  return x;
}

double RandomSource::scale(double from, double to)
{
  return std::exp(uniform(std::log(from), std::log(to)));
}

Vector3 RandomSource::direction()
{
  const double z = uniform(-1.0, 1.0), angle = uniform(-M_PI, M_PI), r = std::sqrt(1.0 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

RandomTether plausibleTether(RandomSource& dice)
{
  RandomTether t;
  core::CableProperties& p = t.tether;
  p = coefficients(dice);
  p.length = dice.scale(1.0, 1e4);
  p.diameter = std::min(dice.scale(0.002, 0.3), p.length / 50.0);
  const double area = p.displacedArea();
  p.mass_per_length = density(dice) * area;
  if (dice.chance(0.5))
    t.ends.velocity = horizontal(dice, 3.0);
  if (dice.chance(0.3))
    t.sea.current = core::CurrentProfile(horizontal(dice, 1.5));
  const double flow = (t.ends.velocity - t.sea.current.at(0.0)).norm();
  const double load = (std::abs(p.mass_per_length - WATER * area) * GRAVITY +
                       0.5 * WATER * p.diameter * p.drag_normal * flow * flow) *
                      p.length;
  p.axial_stiffness = std::clamp(std::max(dice.scale(1e8, 1e11) * area, 20.0 * load), 1e3, 1e9);
  p.axial_damping = dice.chance(0.5) ? 0.0 : dice.scale(1e-5, 1e-3);
  if (dice.chance(0.5))
    p.bending_stiffness = p.axial_stiffness * p.diameter * p.diameter / 16.0 * dice.scale(1e-3, 0.5);
  place(dice, p.length, 1.01, t);
  if (dice.chance(0.25))
    t.bodies.vehicle = body(dice, p.mass_per_length * p.length);
  return t;
}

RandomTether arbitraryTether(RandomSource& dice)
{
  RandomTether t;
  core::CableProperties& p = t.tether;
  p = coefficients(dice);
  p.length = dice.scale(1.0, 1e4);
  p.diameter = dice.scale(0.002, 0.3);
  p.mass_per_length = density(dice) * p.displacedArea();
  p.axial_stiffness = dice.scale(1e3, 1e9);
  p.axial_damping = dice.chance(0.5) ? 0.0 : dice.scale(1e-6, 1e-1);
  if (dice.chance(0.5))
    p.bending_stiffness = dice.scale(1e-4, 1e5);
  t.ends.velocity = dice.chance(0.5) ? horizontal(dice, 5.0) : Vector3(Vector3::Zero());
  if (dice.chance(0.3))
    t.sea.current = core::CurrentProfile(horizontal(dice, 3.0));
  place(dice, p.length, 1.2, t);
  if (dice.chance(0.25))
    t.bodies.vehicle = body(dice, p.mass_per_length * p.length);
  return t;
}

RandomTether tetherOnSeabed(RandomSource& dice)
{
  RandomTether t;
  core::CableProperties& p = t.tether;
  p = coefficients(dice);
  p.length = dice.scale(20.0, 2000.0);
  p.diameter = std::min(dice.scale(0.005, 0.3), p.length / 100.0);
  const double area = p.displacedArea(), density = WATER * dice.scale(1.05, 7.0);
  p.mass_per_length = density * area;
  const double load = (density - WATER) * area * GRAVITY * p.length;
  p.axial_stiffness = std::clamp(std::max(dice.scale(1e9, 1e11) * area, 50.0 * load), 1e4, 1e10);
  p.axial_damping = dice.chance(0.3) ? 0.0 : dice.scale(1e-4, 1e-2);
  if (dice.chance(0.3))
    p.bending_stiffness = p.axial_stiffness * p.diameter * p.diameter / 16.0 * dice.scale(1e-3, 0.1);
  if (dice.chance(0.3))
    t.sea.current = core::CurrentProfile(horizontal(dice, 0.5));

  core::Seabed floor;
  const double ratio = dice.uniform(0.5, 0.995), steepness = dice.uniform(0.05, 0.9);
  floor.depth = 5.0 + ratio * steepness * p.length;
  floor.friction = dice.chance(0.2) ? 0.0 : dice.uniform(0.0, 1.0);
  if (dice.chance(0.5))
    floor.slope = (0.2 * horizontal(dice, 1.0)).head<2>();
  p.working_load = 100.0 * load;
  p.breaking_load = 200.0 * load;
  t.sea.seabed = floor;
  const Vector3 way =
      p.length * ratio * std::sqrt(1.0 - steepness * steepness) * horizontal(dice, 1.0).normalized();
  t.ends.vessel = {0.0, 0.0, -5.0 * dice.uniform(0.0, 1.0)};
  t.ends.vehicle = way;
  const double height = dice.chance(0.5) ? 0.0 : dice.uniform(0.0, 0.2) * floor.depth;
  t.ends.vehicle.z() = floor.at(way.x(), way.y()).z + 0.5 * p.diameter + height;
  return t;
}
}  // namespace tether_monitor::fuzz
