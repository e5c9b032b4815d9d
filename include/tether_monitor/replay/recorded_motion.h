#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "tether_monitor/core/cable/payout_trajectory.h"
#include "tether_monitor/files/csv_table.h"
#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/measurements/motion_buffer.h"

namespace tether_monitor::replay
{
/// Known motion of one body through a series of rows.
struct BodyMotion
{
  std::vector<core::Vector3> position;
  std::vector<core::Vector3> velocity;          ///< measured, or of the spline through the positions.
  std::vector<Eigen::Quaterniond> orientation;  ///< empty: level throughout.
};

/// A recorded or written motion of vessel and vehicle, with the inputs that go with it.
class Motion
{
 public:
  /**
   * @param table  columns as INTERFACES names them: t, vessel_x..z, vehicle_x..z, and the optional ones.
   * @param mode   FREE: columns of the vehicle's motion are an error, thrust_x..z are known. OBSERVED: those of
   * both bodies are RecordedMeasurements and not looked at here.
   * @throws std::runtime_error naming file and line or column: unknown or missing column, t that does not
   * increase, no row, a quaternion that is not of unit length.
   */
  explicit Motion(const files::CsvTable& table, monitor::VehicleMode mode = monitor::VehicleMode::TRACKED);

  const std::vector<double>& times() const { return t_; }
  double begin() const { return t_.front(); }
  double end() const { return t_.back(); }

  /// State of a body at time t [s], begin() <= t <= end(): cubic Hermite in position, slerp in orientation.
  monitor::BodyState vessel(double t) const { return at(vessel_, t); }
  monitor::BodyState vehicle(double t) const { return at(vehicle_, t); }

  bool hasPayout() const { return !payout_.position.empty(); }
  /// Deployed length and its rates at time t: a smooth curve through the rows.
  core::PayoutState payout(double t) const;
  bool hasThrust() const { return !thrust_.empty(); }
  /// Thrust on a simulated vehicle [N], body axes, linear between rows.
  core::Vector3 thrust(double t) const;
  bool hasCurrent() const { return !current_.empty(); }
  /// WaterKinematics velocity [m/s] at time t, the same at all depths, linear between rows.
  core::Vector3 current(double t) const;

 private:
  std::size_t interval(double t) const;
  double share(std::size_t i, double t) const;
  monitor::BodyState at(const BodyMotion& body, double t) const;

  std::vector<double> t_;
  BodyMotion vessel_, vehicle_;
  core::Vector3 linear(const std::vector<core::Vector3>& column, double t) const;
  BodyMotion payout_;  // x of its position is the length
  std::vector<core::Vector3> thrust_;
  std::vector<core::Vector3> current_;
};

}  // namespace tether_monitor::replay
