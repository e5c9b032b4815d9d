#include "tether_monitor/replay/recorded_measurements.h"

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace tether_monitor::replay
{
namespace
{
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

  /// @param may_lack_axes  every empty field is an axis that was not measured; else only a height alone is
  /// allowed.
  std::optional<monitor::PoseMeasurement> pose(std::size_t row, double t, bool may_lack_axes) const
  {
    const core::Vector3 place(at(row, "x"), at(row, "y"), at(row, "z"));
    if (place.array().isNaN().all())
      return std::nullopt;
    const bool is_height_alone = std::isnan(place.x()) && std::isnan(place.y()) && !std::isnan(place.z());
    if (place.hasNaN() && !is_height_alone && !may_lack_axes)
      fail(row, body_ + "x, y and z must all be there, or x and y be empty, or all");
    monitor::PoseMeasurement pose;
    pose.t = t;
    const double stddev = at(row, "stddev");
    if (stddev <= 0.0)
      fail(row, body_ + "stddev must be > 0 m");
    const core::Vector3 known = place.array().isNaN().select(0.0, place);
    if (std::isnan(stddev))
      pose.position = known;
    else
      pose.position = monitor::MeasuredVector::withStddev(known, core::Vector3::Constant(stddev));
    for (int axis = 0; axis < 3; ++axis)
      if (std::isnan(place[axis]))
        pose.position.setNotMeasured(axis);
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

// Load cell and direction of the tether at the vessel end.
class SensorColumns
{
 public:
  explicit SensorColumns(const files::CsvTable& table) : table_(table), tension_(table.find("tension"))
  {
    const char* const names[] = {"direction_x", "direction_y", "direction_z"};
    for (int axis = 0; axis < 3; ++axis)
      direction_[axis] = table.find(names[axis]);
    for (int axis = 0; axis < 3; ++axis)
      if (!direction_[axis] && (direction_[0] || direction_[1] || direction_[2]))
        throw std::runtime_error(table.path + ", line " + std::to_string(table.header_line) + ": column " +
                                 names[axis] + " is missing beside its companions");
  }

  std::optional<double> tension(std::size_t row) const
  {
    const double x = tension_ ? table_.rows[row][*tension_] : std::numeric_limits<double>::quiet_NaN();
    return std::isnan(x) ? std::nullopt : std::optional<double>(x);
  }

  std::optional<core::Vector3> direction(std::size_t row) const
  {
    if (!direction_[0])
      return std::nullopt;
    core::Vector3 v;
    for (int axis = 0; axis < 3; ++axis)
      v[axis] = table_.rows[row][*direction_[axis]];
    if (v.array().isNaN().all())
      return std::nullopt;
    if (!(v.norm() > 0.0))
      throw std::runtime_error(table_.path + ", line " + std::to_string(table_.lines[row]) +
                               ": direction_x, _y and _z must all be empty or a vector that is not zero");
    return v;
  }

 private:
  const files::CsvTable& table_;
  std::optional<std::size_t> tension_;
  std::array<std::optional<std::size_t>, 3> direction_;
};
}  // namespace

bool mayBeEmpty(const std::string& column)
{
  return column.rfind("vessel_", 0) == 0 || column.rfind("vehicle_", 0) == 0 || column == "tension" ||
         column.rfind("direction_", 0) == 0;
}

RecordedMeasurements::RecordedMeasurements(const files::CsvTable& table)
{
  const auto time = table.find("t");
  if (!time)
    throw std::runtime_error(table.path + ", line " + std::to_string(table.header_line) + ": column t is missing");
  if (table.rows.empty())
    throw std::runtime_error(table.path + " has a header but no rows");
  const BodyColumns vessel(table, "vessel_"), vehicle(table, "vehicle_");
  const SensorColumns sensors(table);
  for (std::size_t i = 0; i < table.rows.size(); ++i)
  {
    MeasurementRow row;
    row.t = table.rows[i][*time];
    if (i > 0 && !(row.t > rows_.back().t))
      throw std::runtime_error(table.path + ", line " + std::to_string(table.lines[i]) +
                               ": t does not increase from the row before");
    row.vessel = vessel.pose(i, row.t, false);
    row.vessel_rates = vessel.rates(i, row.t);
    row.vehicle = vehicle.pose(i, row.t, true);
    row.vehicle_rates = vehicle.rates(i, row.t);
    row.tension = sensors.tension(i);
    row.direction = sensors.direction(i);
    rows_.push_back(row);
  }
  const std::optional<monitor::PoseMeasurement>& first = rows_.front().vessel;
  if (!first || !first->position.isComplete())
    throw std::runtime_error(table.path + ", line " + std::to_string(table.lines.front()) +
                             ": the first row must have the vessel's position");
}

std::optional<monitor::BodyState> RecordedMeasurements::vesselAtFirstRow() const
{
  if (!rows_.front().vessel_rates)
    return std::nullopt;
  monitor::BodyState state;
  state.position = rows_.front().vessel->position.value();
  state.orientation = rows_.front().vessel->orientation.value_or(Eigen::Quaterniond::Identity());
  state.velocity = rows_.front().vessel_rates->velocity.value();
  return state;
}

}  // namespace tether_monitor::replay
