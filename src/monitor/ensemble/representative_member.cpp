#include "tether_monitor/monitor/ensemble/representative_member.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double FADING_TIME = 3.0;       // [s]
constexpr double MOST_OF_THE_MEAN = 0.5;  // of the members' mean squared distance: too far to be kept
constexpr double MUCH_NEARER = 0.5;       // of a squared distance

core::Vector3 directionOf(const core::Vector3& v)
{
  const double size = v.norm();
  return size > 0.0 ? core::Vector3(v / size) : core::Vector3(core::Vector3::Zero());
}

// Turned by an offset of its direction, as long as before.
void turn(core::Vector3& v, const core::Vector3& offset)
{
  const core::Vector3 direction = directionOf(directionOf(v) + offset);
  if (direction.squaredNorm() > 0.0)
    v = v.norm() * direction;
}
}  // namespace

void RepresentativeMember::prepare(int elements)
{
  index_ = NONE;
  is_shown_ = false;
  offset_ = Shape();
  offset_.position.assign(2 * elements + 1, core::Vector3::Zero());
  shown_ = offset_;
}

bool RepresentativeMember::choose(const Eigen::RowVectorXd& square)
{
  int nearest = 0;
  square.minCoeff(&nearest);
  if (index_ != NONE &&
      (square[index_] < MOST_OF_THE_MEAN * square.mean() || square[nearest] > MUCH_NEARER * square[index_]))
    return false;
  const bool is_another = nearest != index_;
  index_ = nearest;
  return is_another;
}

void RepresentativeMember::differ(const core::StationProfile& profile, const Eigen::Quaterniond& attitude)
{
  for (std::size_t k = 0; k < offset_.position.size(); ++k)
    offset_.position[k] = shown_.position[k] - profile.position[k];
  offset_.vessel = shown_.vessel - profile.vessel_direction;
  offset_.vehicle = shown_.vehicle - profile.vehicle_direction;
  offset_.vessel_force = shown_.vessel_force - directionOf(profile.ends.vessel);
  offset_.vehicle_force = shown_.vehicle_force - directionOf(profile.ends.vehicle);
  offset_.attitude = (shown_.attitude * attitude.conjugate()).normalized();
}

void RepresentativeMember::fade(double share)
{
  for (core::Vector3& offset : offset_.position)
    offset *= share;
  for (core::Vector3* offset : {&offset_.vessel, &offset_.vehicle, &offset_.vessel_force, &offset_.vehicle_force})
    *offset *= share;
  offset_.attitude = Eigen::Quaterniond::Identity().slerp(share, offset_.attitude);
}

void RepresentativeMember::keep(const core::StationProfile& shown, const Eigen::Quaterniond& attitude)
{
  shown_.position = shown.position;
  shown_.vessel = directionOf(shown.vessel_direction);
  shown_.vehicle = directionOf(shown.vehicle_direction);
  shown_.vessel_force = directionOf(shown.ends.vessel);
  shown_.vehicle_force = directionOf(shown.ends.vehicle);
  shown_.attitude = attitude;
}

void RepresentativeMember::show(double t, core::StationProfile& profile, const Eigen::Quaterniond& attitude,
                                bool is_another, bool fades)
{
  if (is_another && is_shown_)
    differ(profile, attitude);
  else
    fade(std::exp(-std::max(t - t_, 0.0) / FADING_TIME));
  if (!fades)
    fade(0.0);
  t_ = t;
  is_shown_ = true;
  blend(profile);
  keep(profile, blended(attitude));
}

void RepresentativeMember::blend(core::StationProfile& profile) const
{
  for (std::size_t k = 0; k < offset_.position.size(); ++k)
    profile.position[k] += offset_.position[k];
  turn(profile.vessel_direction, offset_.vessel);
  turn(profile.vehicle_direction, offset_.vehicle);
  turn(profile.ends.vessel, offset_.vessel_force);
  turn(profile.ends.vehicle, offset_.vehicle_force);
}

bool RepresentativeMember::Shape::isValid(std::size_t stations) const
{
  const auto isFinite = [](const core::Vector3& v) { return v.allFinite(); };
  return position.size() == stations && std::all_of(position.begin(), position.end(), isFinite) &&
         (vessel + vehicle + vessel_force + vehicle_force).allFinite() && std::abs(attitude.norm() - 1.0) < 1e-6;
}

bool RepresentativeMember::isValid(int members, int elements) const
{
  const std::size_t stations = 2 * static_cast<std::size_t>(elements) + 1;
  return index_ >= 0 && index_ < members && std::isfinite(t_) && shown_.isValid(stations) &&
         offset_.isValid(stations);
}

}  // namespace tether_monitor::monitor
