#include "tether_monitor/replay/recorded_motion.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "tether_monitor/core/cable/end_trajectory.h"
#include "tether_monitor/files/cubic_spline.h"

namespace tether_monitor::replay
{
namespace
{
/// Accepts columns out of a table by name and knows in the end which are left over.
class Columns
{
 public:
  explicit Columns(const files::CsvTable& table) : table_(table) {}

  std::vector<double> scalar(const std::string& name)
  {
    const auto index = table_.find(name);
    if (!index)
      throw std::runtime_error(atHeader() + "column " + name + " is missing");
    wanted_.insert(name);
    std::vector<double> column;
    for (const auto& row : table_.rows)
      column.push_back(row[*index]);
    return column;
  }

  // All of prefix + suffix for the suffixes, or none of them.
  bool has(const std::string& prefix, const std::vector<std::string>& suffixes)
  {
    const auto present = [&](const std::string& suffix) { return table_.find(prefix + suffix).has_value(); };
    if (std::none_of(suffixes.begin(), suffixes.end(), present))
      return false;
    for (const std::string& suffix : suffixes)
      if (!present(suffix))
        throw std::runtime_error(atHeader().append("column ").append(prefix).append(suffix).append(
            " is missing beside its companions"));
    return true;
  }

  std::vector<core::Vector3> vector(const std::string& prefix)
  {
    const std::vector<double> x = scalar(prefix + "x"), y = scalar(prefix + "y"), z = scalar(prefix + "z");
    std::vector<core::Vector3> column;
    for (std::size_t i = 0; i < x.size(); ++i)
      column.emplace_back(x[i], y[i], z[i]);
    return column;
  }

  // Columns with these beginnings are not ours.
  void leaveToOthers(const std::vector<std::string>& beginnings)
  {
    for (const std::string& column : table_.columns)
      for (const std::string& beginning : beginnings)
        if (column.rfind(beginning, 0) == 0)
          wanted_.insert(column);
  }

  void finish() const
  {
    for (const std::string& column : table_.columns)
      if (wanted_.count(column) == 0)
        throw std::runtime_error(atHeader() + "column " + column + " is not known");
  }

 private:
  std::string atHeader() const { return table_.path + ", line " + std::to_string(table_.header_line) + ": "; }

  const files::CsvTable& table_;
  std::set<std::string> wanted_;
};

const std::vector<std::string> XYZ{"x", "y", "z"};

BodyMotion readBody(const files::CsvTable& table, const std::string& name, const std::vector<double>& t,
                    Columns& in)
{
  BodyMotion body;
  body.position = in.vector(name + "_");
  body.velocity = in.has(name + "_v", XYZ) ? in.vector(name + "_v") : files::splineVelocities(t, body.position);
  if (in.has(name + "_q", {"x", "y", "z", "w"}))
  {
    const std::vector<core::Vector3> axis = in.vector(name + "_q");
    const std::vector<double> w = in.scalar(name + "_qw");
    for (std::size_t i = 0; i < w.size(); ++i)
    {
      const Eigen::Quaterniond q(w[i], axis[i].x(), axis[i].y(), axis[i].z());
      if (std::abs(q.norm() - 1.0) > 0.01)
        throw std::runtime_error(table.path + ", line " + std::to_string(table.lines[i]) + ": " + name +
                                 "_q is not a unit quaternion");
      body.orientation.push_back(q.normalized());
    }
  }
  return body;
}
void refuseVehicle(const files::CsvTable& table)
{
  for (const std::string& column : table.columns)
    if (column.rfind("vehicle_", 0) == 0)
      throw std::runtime_error(table.path + ", line " + std::to_string(table.header_line) + ": column " + column +
                               " is not for a free vehicle: it finds its own way");
}
}  // namespace

Motion::Motion(const files::CsvTable& table, monitor::VehicleMode mode)
{
  Columns in(table);
  t_ = in.scalar("t");
  if (t_.empty())
    throw std::runtime_error(table.path + " has a header but no rows");
  for (std::size_t i = 1; i < t_.size(); ++i)
    if (!(t_[i] > t_[i - 1]))
      throw std::runtime_error(table.path + ", line " + std::to_string(table.lines[i]) +
                               ": t does not increase from the row before");
  if (mode == monitor::VehicleMode::OBSERVED)
    in.leaveToOthers({"vessel_", "vehicle_", "tension", "direction_"});
  else
    vessel_ = readBody(table, "vessel", t_, in);
  if (mode == monitor::VehicleMode::TRACKED)
    vehicle_ = readBody(table, "vehicle", t_, in);
  if (mode == monitor::VehicleMode::FREE)
    refuseVehicle(table);
  if (in.has("payout", {""}))
    for (const double length : in.scalar("payout"))
    {
      payout_.position.emplace_back(length, 0.0, 0.0);
      if (!(length > 0.0))
        throw std::runtime_error(table.path + ", line " +
                                 std::to_string(table.lines[payout_.position.size() - 1]) +
                                 ": payout must be > 0 m");
    }
  if (hasPayout())
    payout_.velocity = files::splineVelocities(t_, payout_.position);
  if (mode != monitor::VehicleMode::TRACKED && in.has("thrust_", XYZ))
    thrust_ = in.vector("thrust_");
  if (in.has("current_", XYZ))
    current_ = in.vector("current_");
  in.finish();
}

std::size_t Motion::interval(double t) const
{
  const auto after = std::upper_bound(t_.begin(), t_.end(), t);
  const std::size_t hi = std::clamp<std::size_t>(after - t_.begin(), 1, t_.size() - 1);
  return hi - 1;
}

double Motion::share(std::size_t i, double t) const
{
  return std::clamp((t - t_[i]) / (t_[i + 1] - t_[i]), 0.0, 1.0);
}

monitor::BodyState Motion::at(const BodyMotion& body, double t) const
{
  monitor::BodyState state;
  if (t_.size() == 1)
  {
    state.position = body.position[0];
    state.velocity = body.velocity[0];
    if (!body.orientation.empty())
      state.orientation = body.orientation[0];
    return state;
  }
  const std::size_t i = interval(t);
  const core::EndTrajectory path = core::EndTrajectory::between(
      t_[i], {body.position[i], body.velocity[i]}, t_[i + 1], {body.position[i + 1], body.velocity[i + 1]});
  state.position = path.position(t);
  state.velocity = path.velocity(t);
  if (!body.orientation.empty())
  {
    const Eigen::Quaterniond& from = body.orientation[i];
    const Eigen::AngleAxisd turn(
        Eigen::Quaterniond::Identity().slerp(1.0, body.orientation[i + 1] * from.conjugate()));
    state.orientation = from.slerp(share(i, t), body.orientation[i + 1]);
    const double angle = turn.angle() > M_PI ? turn.angle() - 2.0 * M_PI : turn.angle();
    state.angular_velocity = turn.axis() * (angle / (t_[i + 1] - t_[i]));
  }
  return state;
}

core::PayoutState Motion::payout(double t) const
{
  const monitor::BodyState now = at(payout_, t);
  return {now.position.x(), now.velocity.x(), 0.0};
}

core::Vector3 Motion::linear(const std::vector<core::Vector3>& column, double t) const
{
  if (t_.size() == 1)
    return column[0];
  const std::size_t i = interval(t);
  return column[i] + share(i, t) * (column[i + 1] - column[i]);
}

core::Vector3 Motion::current(double t) const
{
  return linear(current_, t);
}

core::Vector3 Motion::thrust(double t) const
{
  return linear(thrust_, t);
}

}  // namespace tether_monitor::replay
