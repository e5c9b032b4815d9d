#pragma once

#include <Eigen/Geometry>
#include <optional>

namespace tether_monitor::monitor
{
/// Turns that the vehicle has put into its tether: its heading less the vessel's, followed through full turns.
/// Counter-clockwise from above counts up. Less than half a turn may pass between two updates.
class TurnCounter
{
 public:
  /// @param vessel,vehicle  body to world; one whose forward axis stands upright says nothing.
  void update(const Eigen::Quaterniond& vessel, const Eigen::Quaterniond& vehicle);
  /// Somebody else has counted; headings go on from there. @return false, and nothing changes, unless finite.
  bool set(double turns);
  /// [-]; NaN before the first update or set().
  double turns() const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(turns_, heading_, is_known_);
  }

 private:
  double turns_ = 0.0;
  std::optional<double> heading_;  // relative, of the last update [rad]
  bool is_known_ = false;
};

}  // namespace tether_monitor::monitor
