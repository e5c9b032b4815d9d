#include "tether_monitor/replay/recorded_measurements.h"

#include <cmath>
#include <set>
#include <stdexcept>

namespace tether_monitor::replay
{
namespace
{
constexpr double FIRST_SECONDS = 10.0;  // [s] of rows that tell the vessel's velocity at the first
constexpr double NONE = monitor::PoseMeasurement::UNTOLD;

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
    whole({"vx", "vy", "vz"});
    whole({"qx", "qy", "qz", "qw"});
  }

  void read(std::size_t row, double t, bool may_be_height_alone, std::optional<monitor::PoseMeasurement>& pose,
            std::optional<monitor::TwistMeasurement>& rates) const
  {
    const core::Vector3 place(at(row, "x"), at(row, "y"), at(row, "z"));
    const bool height_alone =
        may_be_height_alone && std::isnan(place.x()) && std::isnan(place.y()) && !std::isnan(place.z());
    const Eigen::Quaterniond q(at(row, "qw"), at(row, "qx"), at(row, "qy"), at(row, "qz"));
    if (place.hasNaN() && !place.array().isNaN().all() && !height_alone)
      fail(row, body_ + "x, y and z must all be there or all be empty");
    if (!place.array().isNaN().all())
    {
      pose.emplace();
      pose->t = t;
      pose->position = place;
      const double stddev = at(row, "stddev");
      if (stddev <= 0.0)
        fail(row, body_ + "stddev must be > 0 m");
      pose->position_stddev.setConstant(stddev);
      if (height_alone)
        pose->position.head<2>().setZero(),
            pose->position_stddev.head<2>().setConstant(monitor::VesselMotionFilter::UNMEASURED * 10.0);
      pose->orientation_stddev = std::isnan(q.norm()) ? 10.0 : 0.0;
      if (!std::isnan(q.norm()) && std::abs(q.norm() - 1.0) > 0.01)
        fail(row, body_ + "q is not a unit quaternion");
      if (!std::isnan(q.norm()))
        pose->orientation = q.normalized();
    }
    const core::Vector3 velocity(at(row, "vx"), at(row, "vy"), at(row, "vz"));
    if (velocity.hasNaN() && !velocity.array().isNaN().all())
      fail(row, body_ + "vx, vy and vz must all be there or all be empty");
    if (!velocity.hasNaN())
    {
      rates.emplace();
      rates->t = t;
      rates->velocity = velocity;
    }
  }

 private:
  std::string atHeader() const { return table_.path + ", line " + std::to_string(table_.header_line) + ": "; }
  [[noreturn]] void fail(std::size_t row, const std::string& what) const
  {
    throw std::runtime_error(table_.path + ", line " + std::to_string(table_.lines[row]) + ": " + what);
  }
  void whole(const std::vector<std::string>& names) const
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
    return column ? table_.rows[row][*column] : NONE;
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
    vessel.read(i, row.t, true, row.vessel, row.vessel_rates);
    vehicle.read(i, row.t, false, row.vehicle, row.vehicle_rates);
    rows_.push_back(row);
  }
  const std::optional<monitor::PoseMeasurement>& first = rows_.front().vessel;
  if (!first || first->position_stddev.x() > monitor::VesselMotionFilter::UNMEASURED)
    throw std::runtime_error(table.path + ", line " + std::to_string(table.lines.front()) +
                             ": the first row must have the vessel's position");
}

monitor::BodyState RecordedMeasurements::vesselAtFirstRow() const
{
  monitor::BodyState state;
  state.position = rows_.front().vessel->position;
  state.orientation = rows_.front().vessel->orientation;
  if (rows_.front().vessel_rates)
  {
    state.velocity = rows_.front().vessel_rates->velocity;
    return state;
  }
  double n = 0.0, mean_t = 0.0, square = 0.0;
  core::Vector3 mean = core::Vector3::Zero(), product = core::Vector3::Zero();
  for (const MeasurementRow& row : rows_)
  {
    if (row.t > rows_.front().t + FIRST_SECONDS)
      break;
    if (!row.vessel || row.vessel->position_stddev.x() > monitor::VesselMotionFilter::UNMEASURED)
      continue;
    n += 1.0;
    const double dt = row.t - mean_t;
    mean_t += dt / n;
    mean += (row.vessel->position - mean) / n;
    square += dt * (row.t - mean_t);
    product += dt * (row.vessel->position - mean);
  }
  if (square > 0.0)
    state.velocity = product / square;
  state.velocity.z() = 0.0;  // no vessel rises for long
  return state;
}

}  // namespace tether_monitor::replay
