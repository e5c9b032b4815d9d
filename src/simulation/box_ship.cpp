#include "tether_monitor/simulation/box_ship.h"

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::simulation
{
namespace
{
constexpr double CENTRE_HEIGHT = 0.9;  // of the centre of mass above the keel, over the draft
}

std::vector<std::string> validate(const ShipProperties& ship)
{
  core::BoundsCheck check("simulation.vessel.");
  check.positive("length", ship.length, "m");
  check.positive("beam", ship.beam, "m");
  check.positive("draft", ship.draft, "m");
  check.check(ship.height > ship.draft, "height", ship.height, "> draft, in m");
  const double metacentre = 0.5 * ship.draft + ship.beam * ship.beam / (12.0 * ship.draft);
  check.check(!(metacentre < 1.02 * CENTRE_HEIGHT * ship.draft), "beam", ship.beam, "wide enough not to capsize");
  return check.problems();
}

double equilibriumHeight(const ShipProperties& ship)
{
  return (CENTRE_HEIGHT - 1.0) * ship.draft;
}

core::RigidBody makeBoxShip(const ShipProperties& ship, double water_density)
{
  const double L = ship.length, B = ship.beam, T = ship.draft;
  core::RigidBody body;
  body.mass = water_density * L * B * T;
  body.inertia = body.mass * core::Vector3(0.12 * B * B, 0.0625 * L * L, 0.0625 * L * L);
  body.added_mass = body.mass * core::Vector3(0.05, 0.6, 1.0);
  body.added_inertia = body.inertia.cwiseProduct(core::Vector3(0.2, 0.8, 0.5));
  body.drag_area = core::Vector3(0.3 * B * T, 1.0 * L * T, 1.5 * L * B);
  const double half = 0.5 * water_density;
  body.rotational_drag = half * core::Vector3(0.5 * L * B * B * B * B / 16.0, 0.5 * B * L * L * L * L / 32.0,
                                              0.5 * T * L * L * L * L / 32.0);
  const double freeboard = ship.height - T;
  body.wind_area = core::Vector3(1.0 * B * freeboard * 1.5, 1.0 * L * freeboard, 0.0);
  body.hull = core::Hull{{L, B, ship.height}, {0.0, 0.0, -CENTRE_HEIGHT * T}};
  return body;
}

}  // namespace tether_monitor::simulation
