#pragma once

#include <string>
#include <vector>

#include "tether_monitor/core/analysis/natural_modes.h"
#include "tether_monitor/files/csv_writer.h"
#include "tether_monitor/monitor/estimator/tether_estimator.h"

namespace tether_monitor::replay
{
/// What ends.csv says of the vehicle.
enum class VehicleColumns
{
  NONE,
  RELATIVE,  ///< vehicle_x..z: vehicle end relative to the vessel end.
  POSE,      ///< vehicle_x..z, vehicle_qx..qw: world pose of a simulated vehicle.
  OBSERVED   ///< the same, estimated, and standard deviations and quantiles of tensions, stddev of the position.
};

/// ends.csv: end forces and extremes, a row an estimate.
class EndsFile
{
 public:
  explicit EndsFile(const std::string& folder, VehicleColumns vehicle = VehicleColumns::NONE);
  void write(const monitor::TetherEstimate& estimate);
  void close() { csv_.close(); }

 private:
  VehicleColumns vehicle_;
  files::CsvWriter csv_;
};

/// parameters.csv: what is believed of tether, water and vehicle, a row a parameter and time.
class ParametersFile
{
 public:
  explicit ParametersFile(const std::string& folder);
  void write(double t, const std::vector<monitor::ParameterEstimate>& parameters);
  void close() { csv_.close(); }

 private:
  files::CsvWriter csv_;
};

/// contacts.csv: forces of the tether on obstacles, a row an obstacle that it touches.
class ContactsFile
{
 public:
  explicit ContactsFile(const std::string& folder);
  void write(const monitor::TetherEstimate& estimate, const std::vector<core::Obstacle>& obstacles);
  void close() { csv_.close(); }

 private:
  files::CsvWriter csv_;
};

/// shape.csv: the stations of an estimate, a row a station. INVALID estimates have none.
class ShapeFile
{
 public:
  explicit ShapeFile(const std::string& folder);
  void write(const monitor::TetherEstimate& estimate);
  void close() { csv_.close(); }

 private:
  files::CsvWriter csv_;
};

/// modes.csv (mode, kind, frequency) and mode_shapes.csv (displacement of every node in every mode).
/// @param node_s  unstretched arc lengths of the nodes [m].
void writeModes(const std::string& folder, const std::vector<core::Mode>& modes,
                const std::vector<double>& node_s);

/// alarms.csv: a row for each alarm whose state has changed since the last call.
class AlarmsFile
{
 public:
  explicit AlarmsFile(const std::string& folder);
  void write(double t, const monitor::AlarmSet& alarms);
  void close() { csv_.close(); }

 private:
  files::CsvWriter csv_;
  std::vector<monitor::AlarmState> last_;
};

/// The word of the message constant: "WARNING".
const char* describe(monitor::Severity severity);

}  // namespace tether_monitor::replay
