#include "tether_monitor/replay/recorded_measurements.h"

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace tether_monitor::replay
{
namespace
{
constexpr double FIRST_SECONDS = 10.0;  // [s] of rows that tell the vessel's velocity at the first

// The columns of one body in one row.
class BodyColumns
{
 public:
  BodyColumns(const files::CsvTable& table, const std::string& body) : table_(table), body_(body)
  {
    const std::set<std::string> known{"x", "y", "z", "vx", "vy", "vz", "qx", "qy", "qz", "qw", "stddev"};
    for (const std::string& column : table.columns)
      if (column.rfind(body, 0) == 0 && known.count(column.substr(body.size())) == 0)
        throw std::runtime_error(atHeader() + "column " + column + " is not known");
    for (const char* name : {"x", "y", "z"})
      if (!table.find(body + name))
        throw std::runtime_error(atHeader() + "column " + body + name + " is missing");
    requireAllOrNone({"vx", "vy", "vz"});
    requireAllOrNone({"qx", "qy", "qz", "qw"});
  }

  /// @param may_be_height_alone  a row without x and y is a measured height, not an error.
  std::optional<monitor::PoseMeasurement> pose(std::size_t row, double t, bool may_be_height_alone) const
  {
    const core::Vector3 place(at(row, "x"), at(row, "y"), at(row, "z"));
    if (place.array().isNaN().all())
      return std::nullopt;
    const bool is_height_alone =
        may_be_height_alone && std::isnan(place.x()) && std::isnan(place.y()) && !std::isnan(place.z());
    if (place.hasNaN() && !is_height_alone)
      fail(row, body_ + "x, y and z must all be there or all be empty");
    monitor::PoseMeasurement pose;
    pose.t = t;
    const double stddev = at(row, "stddev");
    if (stddev <= 0.0)
      fail(row, body_ + "stddev must be > 0 m");
    if (std::isnan(stddev))
      pose.position = place;
    else
      pose.position = monitor::MeasuredVector::withStddev(place, core::Vector3::Constant(stddev));
    if (is_height_alone)
    {
      pose.position.setNotMeasured(0);
      pose.position.setNotMeasured(1);
    }
    pose.orientation = orientation(row);
    return pose;
  }

  std::optional<monitor::TwistMeasurement> rates(std::size_t row, double t) const
  {
    const core::Vector3 velocity(at(row, "vx"), at(row, "vy"), at(row, "vz"));
    if (velocity.array().isNaN().all())
      return std::nullopt;
    if (velocity.hasNaN())
      fail(row, body_ + "vx, vy and vz must all be there or all be empty");
    return monitor::TwistMeasurement{t, velocity, core::Vector3::Zero()};
  }

 private:
  std::string atHeader() const { return table_.path + ", line " + std::to_string(table_.header_line) + ": "; }
  [[noreturn]] void fail(std::size_t row, const std::string& what) const
  {
    throw std::runtime_error(table_.path + ", line " + std::to_string(table_.lines[row]) + ": " + what);
  }
  std::optional<Eigen::Quaterniond> orientation(std::size_t row) const
  {
    const Eigen::Quaterniond q(at(row, "qw"), at(row, "qx"), at(row, "qy"), at(row, "qz"));
    if (std::isnan(q.norm()))
      return std::nullopt;
    if (std::abs(q.norm() - 1.0) > 0.01)
      fail(row, body_ + "q is not a unit quaternion");
    return q.normalized();
  }
  void requireAllOrNone(const std::vector<std::string>& names) const
  {
    std::size_t there = 0;
    for (const std::string& name : names)
      there += table_.find(body_ + name) ? 1 : 0;
    if (there != 0 && there != names.size())
      for (const std::string& name : names)
        if (!table_.find(body_ + name))
          throw std::runtime_error(atHeader() + "column " + body_ + name + " is missing beside its companions");
  }
  double at(std::size_t row, const std::string& name) const
  {
    const auto column = table_.find(body_ + name);
    return column ? table_.rows[row][*column] : std::numeric_limits<double>::quiet_NaN();
  }

  const files::CsvTable& table_;
  std::string body_;
};
}  // namespace

bool mayBeEmpty(const std::string& column)
{
  return column.rfind("vessel_", 0) == 0 || column.rfind("vehicle_", 0) == 0;
}

RecordedMeasurements::RecordedMeasurements(const files::CsvTable& table)
{
  const auto time = table.find("t");
  if (!time)
    throw std::runtime_error(table.path + ", line " + std::to_string(table.header_line) + ": column t is missing");
  if (table.rows.empty())
    throw std::runtime_error(table.path + " has a header but no rows");
  const BodyColumns vessel(table, "vessel_"), vehicle(table, "vehicle_");
  for (std::size_t i = 0; i < table.rows.size(); ++i)
  {
    MeasurementRow row;
    row.t = table.rows[i][*time];
    if (i > 0 && !(row.t > rows_.back().t))
      throw std::runtime_error(table.path + ", line " + std::to_string(table.lines[i]) +
                               ": t does not increase from the row before");
    row.vessel = vessel.pose(i, row.t, true);
    row.vessel_rates = vessel.rates(i, row.t);
    row.vehicle = vehicle.pose(i, row.t, false);
    row.vehicle_rates = vehicle.rates(i, row.t);
    rows_.push_back(row);
  }
  const std::optional<monitor::PoseMeasurement>& first = rows_.front().vessel;
  if (!first || !first->position.isComplete())
    throw std::runtime_error(table.path + ", line " + std::to_string(table.lines.front()) +
                             ": the first row must have the vessel's position");
}

monitor::BodyState RecordedMeasurements::vesselAtFirstRow() const
{
  monitor::BodyState state;
  state.position = rows_.front().vessel->position.value();
  state.orientation = rows_.front().vessel->orientation.value_or(Eigen::Quaterniond::Identity());
  if (rows_.front().vessel_rates)
  {
    state.velocity = rows_.front().vessel_rates->velocity.value();
    return state;
  }
  double n = 0.0, mean_t = 0.0, square = 0.0;
  core::Vector3 mean = core::Vector3::Zero(), product = core::Vector3::Zero();
  for (const MeasurementRow& row : rows_)
  {
    if (row.t > rows_.front().t + FIRST_SECONDS)
      break;
    if (!row.vessel || !row.vessel->position.isComplete())
      continue;
    n += 1.0;
    const double dt = row.t - mean_t;
    mean_t += dt / n;
    mean += (row.vessel->position.value() - mean) / n;
    square += dt * (row.t - mean_t);
    product += dt * (row.vessel->position.value() - mean);
  }
  if (square > 0.0)
    state.velocity = product / square;
  state.velocity.z() = 0.0;  // no vessel rises for long
  return state;
}

}  // namespace tether_monitor::replay
