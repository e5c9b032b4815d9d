#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "tether_monitor/monitor/tether_estimator.h"

namespace tether_monitor::replay
{
/// A CSV file that is being written. Numbers keep 10 digits; NaN is "nan".
class CsvWriter
{
 public:
  /// @throws std::runtime_error naming the file if it cannot be made.
  CsvWriter(const std::string& path, const std::string& header);

  CsvWriter& number(double value);
  /// A time [s] with 15 digits, so that seconds since 1970 keep their microseconds.
  CsvWriter& time(double t);
  CsvWriter& text(const std::string& value);
  /// Ends the row. @throws std::runtime_error naming the file if writing failed.
  void endRow();
  /// Writes what is buffered. @throws as endRow().
  void close();

 private:
  struct Closer
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void separate();

  std::string path_;
  std::unique_ptr<std::FILE, Closer> file_;
  bool row_has_fields_ = false;
};

/// Makes a folder with its parents. @throws std::runtime_error naming it if that is impossible.
void makeFolder(const std::string& path);

/// ends.csv: end forces and extremes, a row an estimate.
class EndsFile
{
 public:
  /// @param with_vehicle  adds the columns vehicle_x, vehicle_y, vehicle_z.
  explicit EndsFile(const std::string& folder, bool with_vehicle = false);
  void write(const monitor::TetherEstimate& estimate);
  void write(const monitor::TetherEstimate& estimate, const core::Vector3& vehicle);
  void close() { csv_.close(); }

 private:
  void writeColumns(const monitor::TetherEstimate& estimate);
  CsvWriter csv_;
};

/// shape.csv: the stations of an estimate, a row a station. INVALID estimates have none.
class ShapeFile
{
 public:
  explicit ShapeFile(const std::string& folder);
  void write(const monitor::TetherEstimate& estimate);
  void close() { csv_.close(); }

 private:
  CsvWriter csv_;
};

/// alarms.csv: a row for each alarm whose state has changed since the last call.
class AlarmsFile
{
 public:
  explicit AlarmsFile(const std::string& folder);
  void write(double t, const monitor::AlarmSet& alarms);
  void close() { csv_.close(); }

 private:
  CsvWriter csv_;
  std::vector<monitor::AlarmState> last_;
};

/// The word of the message constant: "RETURNED_UNACKNOWLEDGED", "WARNING".
const char* describe(monitor::AlarmState state);
const char* describe(monitor::Severity severity);

}  // namespace tether_monitor::replay
