#include "tether_monitor/monitor/ensemble/representative_member.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double FADING_TIME = 3.0;       // [s]
constexpr double MOST_OF_THE_MEAN = 0.5;  // of the members' mean squared distance: too far to be kept

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
  offset_ = Offset();
  offset_.position.assign(2 * elements + 1, core::Vector3::Zero());
}

void RepresentativeMember::choose(const Eigen::RowVectorXd& square,
                                  const std::vector<core::StationProfile>& profiles, double t)
{
  const double left = std::exp(-std::max(t - t_, 0.0) / FADING_TIME);
  t_ = t;
  for (core::Vector3& offset : offset_.position)
    offset *= left;
  for (core::Vector3* offset : {&offset_.vessel, &offset_.vehicle, &offset_.vessel_force, &offset_.vehicle_force})
    *offset *= left;
  if (index_ != NONE && square[index_] < MOST_OF_THE_MEAN * square.mean())
    return;
  int nearest = 0;
  square.minCoeff(&nearest);
  if (index_ != NONE && nearest != index_)
  {
    const core::StationProfile &before = profiles[index_], &now = profiles[nearest];
    for (std::size_t k = 0; k < offset_.position.size(); ++k)
      offset_.position[k] += before.position[k] - now.position[k];
    offset_.vessel += before.vessel_direction - now.vessel_direction;
    offset_.vehicle += before.vehicle_direction - now.vehicle_direction;
    offset_.vessel_force += directionOf(before.ends.vessel) - directionOf(now.ends.vessel);
    offset_.vehicle_force += directionOf(before.ends.vehicle) - directionOf(now.ends.vehicle);
  }
  index_ = nearest;
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

bool RepresentativeMember::isValid(int members, int elements) const
{
  const auto isFinite = [](const core::Vector3& v) { return v.allFinite(); };
  return index_ >= 0 && index_ < members && std::isfinite(t_) &&
         offset_.position.size() == 2 * static_cast<std::size_t>(elements) + 1 &&
         std::all_of(offset_.position.begin(), offset_.position.end(), isFinite) &&
         (offset_.vessel + offset_.vehicle + offset_.vessel_force + offset_.vehicle_force).allFinite();
}

}  // namespace tether_monitor::monitor
