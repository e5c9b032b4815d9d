#include "tether_monitor/ros/markers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tether_monitor/monitor/alarms/alarm_quantities.h"
#include "tether_monitor/ros/force_text.h"
#include "tether_monitor/ros/geometry_conversions.h"

namespace tether_monitor
{
namespace
{
using visualization_msgs::Marker;

// Shares of the deployed length.
constexpr double LINE_WIDTH = 0.006;
constexpr double ARROW_LENGTH = 0.25;  // of a force as large as the working load
constexpr double TEXT_HEIGHT = 0.04;
constexpr int TUBE_SIDES = 8;
constexpr double FIX_WIDTH = 0.05;         // [m]
constexpr double OBSTACLE_LIFETIME = 2.0;  // [s]
constexpr int SEABED_CELLS = 16;           // along each side of the patch

std_msgs::ColorRGBA colour(double r, double g, double b, double a = 1.0)
{
  std_msgs::ColorRGBA c;
  c.r = r;
  c.g = g;
  c.b = b;
  c.a = a;
  return c;
}

Marker blank(const std_msgs::Header& header, const char* ns, int id, int type)
{
  Marker m;
  m.header = header;
  m.ns = ns;
  m.id = id;
  m.type = type;
  m.action = Marker::ADD;
  m.pose.orientation.w = 1.0;
  m.color = colour(1.0, 1.0, 1.0);
  return m;
}

Marker tetherLine(const std_msgs::Header& header, const monitor::TetherEstimator& estimator)
{
  const monitor::Config& config = estimator.config();
  const monitor::TetherEstimate& e = estimator.estimate();
  Marker m = blank(header, "tether", 0, Marker::LINE_STRIP);
  if (!e.has_stations)
  {
    m.action = Marker::DELETE;
    return m;
  }
  m.scale.x = std::max(config.tether.diameter, LINE_WIDTH * e.length);
  const double warning = monitor::alarmConfig(config, monitor::alarmQuantities().front()).warning.value_or(0.8);
  for (std::size_t i = 0; i < e.stations.s.size(); ++i)
  {
    m.points.push_back(pointMessage(e.stations.position[i]));
    const int element = std::min(static_cast<int>(i / 2), estimator.simulation().model.elements() - 1);
    m.colors.push_back(utilisationColour(
        e.stations.tension[i] / estimator.simulation().model.elementProperties(element).working_load, warning));
  }
  return m;
}

// How far the tether may be from where it is drawn: two standard deviations across.
Marker uncertaintyTube(const std_msgs::Header& header, const monitor::TetherEstimate& e)
{
  Marker m = blank(header, "uncertainty", 0, Marker::TRIANGLE_LIST);
  const std::size_t n = e.stations.position.size();
  if (!e.has_stations || e.position_stddev.size() != n)
  {
    m.action = Marker::DELETE;
    return m;
  }
  m.scale.x = m.scale.y = m.scale.z = 1.0;
  m.color = colour(0.65, 0.7, 0.75, 0.25);
  const auto corner = [&](std::size_t k, int side)
  {
    const core::Vector3 along =
        (e.stations.position[std::min(k + 1, n - 1)] - e.stations.position[k > 0 ? k - 1 : 0]).normalized();
    const core::Vector3 other = std::abs(along.z()) < 0.9 ? core::Vector3::UnitZ() : core::Vector3::UnitX();
    const core::Vector3 u = along.cross(other).normalized(), v = along.cross(u);
    const double angle = 2.0 * M_PI * side / TUBE_SIDES;
    const core::Vector3 direction = std::cos(angle) * u + std::sin(angle) * v;
    const double stddev = direction.cwiseProduct(e.position_stddev[k]).norm();
    return core::Vector3(e.stations.position[k] + 2.0 * stddev * direction);
  };
  for (std::size_t k = 0; k + 1 < n; ++k)
    for (int side = 0; side < TUBE_SIDES; ++side)
      for (const auto& [dk, ds] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
        m.points.push_back(pointMessage(corner(k + dk, side + ds)));
  return m;
}

Marker forceArrow(const std_msgs::Header& header, int id, const monitor::Config& config,
                  const monitor::TetherEstimate& e, const core::Vector3& force, const core::Vector3& at)
{
  Marker m = blank(header, "force", id, Marker::ARROW);
  const double length = ARROW_LENGTH * e.length * std::min(force.norm() / config.tether.working_load, 2.0);
  if (!e.has_stations || !(length > 1e-3 * e.length))
  {
    m.action = Marker::DELETE;
    return m;
  }
  m.points = {pointMessage(at), pointMessage(at + force.normalized() * length)};
  m.scale.x = 1.2 * LINE_WIDTH * e.length;
  m.scale.y = 3.0 * LINE_WIDTH * e.length;
  m.color = colour(0.85, 0.65, 0.95);
  return m;
}

// What the estimate is worth.
std::string estimateText(const monitor::TetherEstimate& e)
{
  const std::string status = e.status == monitor::Status::OK ? "estimate valid" : describe(e.status);
  return e.reason == monitor::Reason::NONE ? status : status + " " + describe(e.reason);
}

// What the tether is at, on a line of its own.
std::string tensionText(const monitor::TetherEstimate& e)
{
  if (!e.has_stations)
    return "";
  if (!(e.max_tension > 0.0))
    return "\nslack";
  char share[60];
  std::snprintf(share, sizeof(share), ", %.0f %% of working load, at %.3g m", 100.0 * e.working_utilisation,
                e.max_tension_s);
  std::string band;
  if (std::isfinite(e.vessel_tension_stddev))
    band = " +- " + forceText(e.vessel_tension_stddev);
  return "\nlargest tension " + forceText(e.max_tension) + share + "\nvessel " + forceText(e.vessel_tension) +
         band + ", vehicle " + forceText(e.vehicle_tension);
}

Marker statusText(const std_msgs::Header& header, const monitor::Config& config, const monitor::TetherEstimate& e,
                  const monitor::AlarmSet& alarms)
{
  const double L = config.tether.length;
  Marker m = blank(header, "status", 0, Marker::TEXT_VIEW_FACING);
  m.scale.z = TEXT_HEIGHT * L;
  const core::Vector3 at = e.has_stations
                               ? core::Vector3(0.5 * (e.stations.position.front() + e.stations.position.back()))
                               : core::Vector3::Zero();
  const double top =
      e.has_stations ? std::max(e.stations.position.front().z(), e.stations.position.back().z()) : 0.0;
  m.pose.position = pointMessage(core::Vector3(at.x(), at.y(), top + 0.15 * L));
  m.text = estimateText(e) + tensionText(e);
  m.color = e.status == monitor::Status::OK ? colour(0.9, 0.95, 0.9) : colour(1.0, 0.8, 0.2);
  monitor::Severity gravest = monitor::Severity::WARNING;
  for (const monitor::Alarm& alarm : alarms.alarms())
    if (alarm.isAnnunciated())
    {
      gravest = std::max(gravest, alarm.definition().severity);
      m.text += "\n" + alarm.definition().name + ": " + describe(alarm.state());
      m.color = gravest == monitor::Severity::WARNING ? colour(1.0, 0.8, 0.2) : colour(1.0, 0.35, 0.3);
    }
  return m;
}

Marker obstacleBody(const std_msgs::Header& header, int k, const monitor::TetherEstimator& estimator)
{
  const core::Obstacle& obstacle = estimator.simulation().model.environment().obstacles()[k];
  const monitor::CableSimulation& simulation = estimator.simulation();
  const bool is_stepped = estimator.estimate().has_stations;
  Marker m = blank(header, "obstacle", k, Marker::CUBE);
  m.lifetime = ros::Duration(OBSTACLE_LIFETIME);  // one that is gone fades by itself
  m.pose.position =
      pointMessage(is_stepped ? core::Vector3(simulation.state.obstacles[k].position + simulation.origin())
                              : obstacle.position);
  m.pose.orientation = quaternionMessage(obstacle.orientation);
  core::Vector3 size = obstacle.size;
  if (obstacle.shape == core::ObstacleShape::SPHERE)
  {
    m.type = Marker::SPHERE;
    size.setConstant(2.0 * obstacle.size[0]);
  }
  else if (obstacle.shape == core::ObstacleShape::CYLINDER)
  {
    m.type = Marker::CYLINDER;
    size = {2.0 * obstacle.size[0], 2.0 * obstacle.size[0], obstacle.size[1]};
  }
  m.scale = vectorMessage(size);
  const bool touched = is_stepped && estimator.estimate().contact.obstacles[k].total > 0.0;
  m.color = touched ? colour(0.95, 0.5, 0.1, 0.9) : colour(0.6, 0.6, 0.6, 0.7);
  return m;
}

// The sea floor under the tether, as a mesh of triangles.
Marker seabedPatch(const std_msgs::Header& header, const monitor::TetherEstimator& estimator)
{
  Marker m = blank(header, "seabed", 0, Marker::TRIANGLE_LIST);
  const monitor::TetherEstimate& e = estimator.estimate();
  if (!e.has_stations)
  {
    m.action = Marker::DELETE;
    return m;
  }
  const core::Vector3 a = e.stations.position.front(), b = e.stations.position.back();
  const double half = 0.5 * (b - a).head<2>().norm() + 0.25 * e.length, cell = 2.0 * half / SEABED_CELLS;
  // Cells keep their places in the world while the tether moves.
  const double x0 = std::floor((0.5 * (a.x() + b.x()) - half) / cell) * cell;
  const double y0 = std::floor((0.5 * (a.y() + b.y()) - half) / cell) * cell;
  const core::Seabed& seabed = *estimator.simulation().model.environment().seabed();
  const auto corner = [&](int i, int j)
  {
    const double x = x0 + i * cell, y = y0 + j * cell;
    return core::Vector3(x, y, seabed.at(x, y).z);
  };
  m.scale.x = m.scale.y = m.scale.z = 1.0;
  m.color = colour(0.55, 0.45, 0.3, 0.6);
  for (int i = 0; i < SEABED_CELLS; ++i)
    for (int j = 0; j < SEABED_CELLS; ++j)
      for (const auto& [di, dj] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
        m.points.push_back(pointMessage(corner(i + di, j + dj)));
  return m;
}

// A height that was not measured is that of the vehicle now.
Marker fixCrosses(const std_msgs::Header& header, const monitor::TetherEstimator& estimator,
                  const RecentFixes& fixes)
{
  Marker m = blank(header, "fixes", 0, Marker::LINE_LIST);
  const monitor::TetherEstimate& e = estimator.estimate();
  if (e.has_stations && estimator.config().vehicle_mode == monitor::VehicleMode::OBSERVED)
    fixes.forEach(
        e.time,
        [&](const RecentFixes::Fix& fix)
        {
          core::Vector3 place = fix.place;
          if (std::isnan(place.z()))
            place.z() = e.vehicle.position.z();
          for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0})
              m.points.push_back(pointMessage(place + side * fix.stddev[axis] * core::Vector3::Unit(axis)));
        });
  if (m.points.empty())
    m.action = Marker::DELETE;
  m.scale.x = FIX_WIDTH;
  m.color = colour(0.3, 0.9, 0.6);
  return m;
}
}  // namespace

// Told apart by those who cannot tell red from green, too.
std_msgs::ColorRGBA utilisationColour(double utilisation, double warning)
{
  const core::Vector3 rest(0.34, 0.71, 0.91), warned(0.94, 0.89, 0.26), limit(0.9, 0.15, 0.05);
  const auto between = [](const core::Vector3& from, const core::Vector3& to, double share)
  {
    const core::Vector3 c = from + std::clamp(share, 0.0, 1.0) * (to - from);
    return colour(c.x(), c.y(), c.z());
  };
  const double u = std::isfinite(utilisation) ? utilisation : 1.0;
  return u < warning ? between(rest, warned, u / warning)
                     : between(warned, limit, (u - warning) / std::max(1.0 - warning, 1e-6));
}

visualization_msgs::MarkerArray markers(const std_msgs::Header& header, const monitor::TetherEstimator& estimator,
                                        const RecentFixes& fixes)
{
  const monitor::Config& config = estimator.config();
  const monitor::TetherEstimate& e = estimator.estimate();
  visualization_msgs::MarkerArray array;
  array.markers.push_back(tetherLine(header, estimator));
  array.markers.push_back(uncertaintyTube(header, e));
  const core::EndForces& ends = e.stations.ends;
  array.markers.push_back(forceArrow(header, 0, config, e, ends.vessel, e.stations.position.front()));
  array.markers.push_back(forceArrow(header, 1, config, e, ends.vehicle, e.stations.position.back()));
  array.markers.push_back(statusText(header, config, e, estimator.alarms()));
  array.markers.push_back(fixCrosses(header, estimator, fixes));
  const std::vector<core::Obstacle>& obstacles = estimator.simulation().model.environment().obstacles();
  for (std::size_t k = 0; k < obstacles.size(); ++k)
    array.markers.push_back(obstacleBody(header, static_cast<int>(k), estimator));
  if (estimator.simulation().model.environment().hasSeabed())
    array.markers.push_back(seabedPatch(header, estimator));
  return array;
}

Marker forecastLine(const std_msgs::Header& header, const std::vector<core::Vector3>& stations)
{
  Marker m = blank(header, "forecast", 0, Marker::LINE_STRIP);
  double length = 0.0;
  for (std::size_t k = 0; k < stations.size(); ++k)
  {
    m.points.push_back(pointMessage(stations[k]));
    length += k > 0 ? (stations[k] - stations[k - 1]).norm() : 0.0;
  }
  m.scale.x = LINE_WIDTH * length;
  m.color = colour(0.9, 0.9, 1.0, 0.4);
  if (m.points.size() < 2)
    m.action = Marker::DELETE;
  return m;
}

}  // namespace tether_monitor
