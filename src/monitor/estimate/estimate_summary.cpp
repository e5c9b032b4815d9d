#include "tether_monitor/monitor/estimate/estimate_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tether_monitor::monitor
{
namespace
{
constexpr double LARGEST_STRAIN = 0.1;       // [-]
constexpr double LARGEST_TURN = 1.2;         // [rad] over one element
constexpr double LARGEST_COMPRESSION = 0.5;  // loss of diameter [-]

// Angle of a direction below the horizontal [rad].
double angleBelow(const core::Vector3& direction)
{
  return std::atan2(-direction.z(), std::hypot(direction.x(), direction.y()));
}
// Load at an end: tension, and the shear that a stiff tether carries there. A push is none.
double loadAtEnd(double tension, const core::Vector3& force)
{
  const double shear = std::sqrt(std::max(force.squaredNorm() - tension * tension, 0.0));
  return shear > 0.0 ? std::hypot(std::max(tension, 0.0), shear) : tension;
}

// Load at a station [N]: its tension; at the ends see above.
double loadAt(const core::StationProfile& at, std::size_t station)
{
  if (station == 0)
    return loadAtEnd(at.tension.front(), at.ends.vessel);
  if (station + 1 == at.tension.size())
    return loadAtEnd(at.tension.back(), at.ends.vehicle);
  return at.tension[station];
}
}  // namespace

void summarize(const core::DeployedCable& cable, TetherEstimate& e)
{
  const core::StationProfile& at = e.stations;
  std::size_t most = 0;
  for (std::size_t k = 1; k < at.tension.size(); ++k)
    if (loadAt(at, k) > loadAt(at, most))
      most = k;
  const auto least = std::min_element(at.tension.begin(), at.tension.end()) - at.tension.begin();
  const auto bend = std::min_element(at.bend_radius.begin(), at.bend_radius.end()) - at.bend_radius.begin();
  e.length = at.s.back();
  e.max_tension = loadAt(at, most);
  e.max_tension_s = at.s[most];
  e.min_tension = at.tension[least];
  e.min_tension_s = at.s[least];
  e.min_bend_radius = at.bend_radius[bend];
  e.min_bend_radius_s = at.s[bend];
  e.vessel_tension = at.ends.vessel.norm();
  e.vehicle_tension = at.ends.vehicle.norm();
  e.working_utilisation = e.breaking_utilisation = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < cable.elements(); ++i)
    for (int k = 2 * i; k <= 2 * i + 2; ++k)
    {
      const double load = loadAt(at, k), working = load / cable.model().elementProperties(i).working_load;
      e.breaking_utilisation =
          std::max(e.breaking_utilisation, load / cable.model().elementProperties(i).breaking_load);
      if (working > e.working_utilisation)
      {
        e.working_utilisation = working;
        e.working_utilisation_s = at.s[k];
      }
    }
  const double reference = cable.model().bendLimit().value_or(1.0);
  e.governing_bend_radius = std::numeric_limits<double>::infinity();
  e.governing_bend_radius_s = e.min_bend_radius_s;
  for (int i = 0; i < cable.elements(); ++i)
    for (int k = 2 * i; k <= 2 * i + 2; ++k)
    {
      const double scaled =
          at.bend_radius[k] * reference / cable.model().elementProperties(i).min_bend_radius.value_or(reference);
      if (scaled < e.governing_bend_radius)
      {
        e.governing_bend_radius = scaled;
        e.governing_bend_radius_s = at.s[k];
      }
    }
  e.vessel_end_angle = angleBelow(at.vessel_direction);
  e.vehicle_end_angle = angleBelow(at.vehicle_direction);
}

void describeContact(const core::DeployedCable& cable, const core::CableState& state, TetherEstimate& e)
{
  core::summarizeContact(cable, state, e.contact);
  e.seabed_contact_length = e.contact.seabed_length;
  e.touchdown_s = e.contact.touchdown_s < 0.0 ? TetherEstimate::NONE : e.contact.touchdown_s;
  for (core::ContactSummary::ObstacleContact& touch : e.contact.obstacles)
    touch.place += cable.environment().origin();
}

void describeVehicle(const core::DeployedCable& cable, const core::CableState& state, TetherEstimate& e)
{
  e.has_vehicle = true;
  e.vehicle = BodyState::ofNode(state, state.q.size() - 1, state.vehicle, cable.bodies().vehicle->attachment);
  e.vehicle.position += cable.environment().origin();
}

Reason modelRange(const core::DeployedCable& cable, const TetherEstimate& e)
{
  for (int i = 0; i < cable.elements(); ++i)
    if (-e.stations.position[2 * i + 1].z() * cable.element(i).compression > LARGEST_COMPRESSION)
      return Reason::OUT_OF_RANGE;
  const auto [least, most] = std::minmax_element(e.stations.strain.begin(), e.stations.strain.end());
  if (e.breaking_utilisation > 1.0 || *most > LARGEST_STRAIN)
    return Reason::OUT_OF_RANGE;
  const bool is_crumpled = *least < -LARGEST_STRAIN;  // no tether bears that push: a kink that the mesh rounds off
  return is_crumpled || e.stations.max_element_rotation > LARGEST_TURN ? Reason::MESH_COARSE : Reason::NONE;
}

void invalidate(Reason reason, TetherEstimate& e)
{
  TetherEstimate empty;
  empty.time = e.time;
  empty.reason = reason;
  empty.reasons.add(reason);
  empty.vessel_age = e.vessel_age;
  empty.vehicle_age = e.vehicle_age;
  empty.vehicle_overdue = e.vehicle_overdue;
  empty.payout_age = e.payout_age;
  std::swap(empty.stations, e.stations);
  empty.contact.obstacles.swap(e.contact.obstacles);
  for (core::ContactSummary::ObstacleContact& touch : empty.contact.obstacles)
    touch = core::ContactSummary::ObstacleContact();
  e = std::move(empty);
}

}  // namespace tether_monitor::monitor
