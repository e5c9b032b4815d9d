#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "tether_monitor/core/assembly/station_profile.h"

namespace tether_monitor::monitor
{
/**
 * The member whose shape, angles and contacts an ensemble shows: a possible tether, which a mean of shapes is not.
 * It is kept while its squared distance from the middle of the members is less than half of their mean, or the
 * nearest one is hardly nearer. When another takes its place, the difference of positions, of tangents and forces'
 * directions at the ends and of the vehicle's attitude fades within some seconds; what else is shown, contacts and
 * bends, is that of the new one at once. (E17) of doc/theory/estimation.md. Allocates nothing after prepare().
 */
class RepresentativeMember
{
 public:
  static constexpr int NONE = -1;

  /// Forgets the member, and takes memory for tethers of so many elements.
  void prepare(int elements);

  /// @param square  squared distances of the members from their middle. @return true if it is another one now.
  bool choose(const Eigen::RowVectorXd& square);
  int index() const { return index_; }  ///< NONE before the first choice.

  /**
   * Turns the profile of the member into what is shown at time t [s], as blend() does.
   *
   * @param profile  in and out: of the member that was chosen. @param attitude  of its vehicle.
   * @param is_another  it, or its state, was another's before: the difference begins to fade.
   * @param fades       false: there is no difference, it is shown as it is.
   */
  void show(double t, core::StationProfile& profile, const Eigen::Quaterniond& attitude, bool is_another,
            bool fades);
  /// The same for another profile of that member at that time: forces keep their sizes.
  void blend(core::StationProfile& profile) const;
  Eigen::Quaterniond blended(const Eigen::Quaterniond& attitude) const { return offset_.attitude * attitude; }
  /// What a station that is shown is off from that of the member [m].
  const core::Vector3& offset(std::size_t station) const { return offset_.position[station]; }
  bool isValid(int members, int elements) const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(index_, is_shown_, t_);
    for (Shape* shape : {&shown_, &offset_})
      a(shape->position, shape->vessel, shape->vehicle, shape->vessel_force, shape->vehicle_force,
        shape->attitude);
  }

 private:
  /// Positions [m], tangents at the ends, directions of the forces, attitude of the vehicle; or differences of
  /// them.
  struct Shape
  {
    std::vector<core::Vector3> position;
    core::Vector3 vessel = core::Vector3::Zero(), vehicle = core::Vector3::Zero();
    core::Vector3 vessel_force = core::Vector3::Zero(), vehicle_force = core::Vector3::Zero();
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();

    bool isValid(std::size_t stations) const;
  };

  void differ(const core::StationProfile& profile, const Eigen::Quaterniond& attitude);
  void fade(double share);
  void keep(const core::StationProfile& shown, const Eigen::Quaterniond& attitude);

  int index_ = NONE;
  bool is_shown_ = false;
  double t_ = 0.0;  // [s] of what was shown last.
  Shape shown_, offset_;
};

}  // namespace tether_monitor::monitor
