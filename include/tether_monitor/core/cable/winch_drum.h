#pragma once

#include <string>
#include <vector>

namespace tether_monitor::core
{
/// Sizes of a winch drum, as a user gives them.
struct WinchProperties
{
  double core_diameter = 0.0;  ///< [m], > 0.
  double width = 0.0;          ///< between the flanges [m], at least one tether wide.
  int layers = 0;              ///< that the flanges hold, >= 1.
};

/**
 * A drum with a tether wound in layers, one on top of the other: turns to length and back.
 *
 * Model: (M28) of doc/model.md, section 6 of the paper. Every turn of layer k (from 0) is a circle of diameter
 * core + (2 k + 1) d; a layer has width / d whole turns. The drum is full when nothing is paid out.
 */
class WinchDrum
{
 public:
  /// @throws std::invalid_argument listing violated bounds.
  WinchDrum(const WinchProperties& drum, double tether_diameter);

  /// Longest tether that the drum holds [m], and its turns.
  double capacity() const { return capacity_; }
  double turns() const { return turns_; }
  /// Length that is paid out after so many turns from the full drum [m]; 0 <= turns_out <= turns().
  double paidOut(double turns_out) const;
  /// Turns from the full drum for a length paid out [m]; 0 <= length <= capacity().
  double turnsFor(double length) const;
  /// Length paid out per turn at that point [m].
  double lengthPerTurn(double turns_out) const;
  /// Smallest bend radius of the tether's axis on the drum [m]: that of the first layer.
  double bendRadius() const { return 0.5 * (core_diameter_ + diameter_); }

 private:
  double wound(double turns_on) const;  // length of the innermost turns

  double core_diameter_, diameter_, turns_per_layer_;
  int layers_;
  double turns_, capacity_;
};

/// Every bound of a drum for a tether of this diameter [m] and deployed length [m], one sentence each.
/// @param min_bend_radius  of the tether [m]; 0: none.
std::vector<std::string> validate(const WinchProperties& drum, double tether_diameter, double length,
                                  double min_bend_radius);

}  // namespace tether_monitor::core
