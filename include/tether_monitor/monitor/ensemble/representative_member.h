#pragma once

#include <Eigen/Core>
#include <vector>

#include "tether_monitor/core/assembly/station_profile.h"

namespace tether_monitor::monitor
{
/**
 * The member whose shape, angles and contacts an ensemble shows: a possible tether, which a mean of shapes is not.
 * It is kept while it is nearer to the middle of the members than half of what they are on average, then it is the
 * nearest; what two of them differ by fades within some seconds, so that nothing leaps, (E17) of
 * doc/theory/estimation.md. Allocates nothing after prepare().
 */
class RepresentativeMember
{
 public:
  /// Forgets the member, and takes memory for tethers of so many elements.
  void prepare(int elements);

  /**
   * @param square    squared distances of the members from their middle.
   * @param profiles  of the members, at time t [s].
   */
  void choose(const Eigen::RowVectorXd& square, const std::vector<core::StationProfile>& profiles, double t);
  int index() const { return index_; }  ///< NONE before the first choice.

  /// Adds what has not faded yet to the profile of the member: its positions, tangents and forces at the ends.
  void blend(core::StationProfile& profile) const;
  /// What a station is off from that of the member [m].
  const core::Vector3& offset(std::size_t station) const { return offset_.position[station]; }
  bool isValid(int members, int elements) const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(index_, t_, offset_.position, offset_.vessel, offset_.vehicle, offset_.vessel_force, offset_.vehicle_force);
  }

  static constexpr int NONE = -1;

 private:
  /// Differences of shapes: positions [m], tangents at the ends, directions of the forces.
  struct Offset
  {
    std::vector<core::Vector3> position;
    core::Vector3 vessel = core::Vector3::Zero(), vehicle = core::Vector3::Zero();
    core::Vector3 vessel_force = core::Vector3::Zero(), vehicle_force = core::Vector3::Zero();
  };

  int index_ = NONE;
  double t_ = 0.0;  // [s] of the last choice.
  Offset offset_;
};

}  // namespace tether_monitor::monitor
