#pragma once

#include <vector>

#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"

namespace tether_monitor::monitor
{
/// Where a tether is held fast; NaN: not known.
struct SnagPlace
{
  double s = TetherEstimate::NONE;         ///< the most likely place [m].
  double nearest = TetherEstimate::NONE;   ///< the places that the load cell allows: from here [m]
  double farthest = TetherEstimate::NONE;  ///< to here [m].

  template <class Archive>
  void serialize(Archive& a)
  {
    a(s, nearest, farthest);
  }
};

/**
 * Finds the place along a tether that is held fast, from what its end pulls: (E22) of doc/theory/estimation.md.
 *
 * A piece of length s from the vessel end to the place r(s) where the tether was when it was caught spans the
 * chord d. As a shallow catenary that carries the tension T it must be
 * d / s - 1 = T / EA - (w s / T)^2 / 24, w its lateral load, of weight and drag. Only one s fits; it is sharp
 * while T is small.
 */
class SnagLocator
{
 public:
  explicit SnagLocator(const Config& config);

  /// Keeps the shape of an estimate in which nothing is held; allocates nothing for a mesh that it knows.
  void remember(const TetherEstimate& estimate);
  void clear() { s_.clear(); }
  bool isValid() const { return s_.size() == position_.size(); }
  /// @param vessel_end,velocity  of it now [m, m/s]. @param tension  measured there [N]. @param stddev  of it [N].
  SnagPlace find(const core::Vector3& vessel_end, const core::Vector3& velocity, double tension,
                 double stddev) const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(s_, position_);
  }

 private:
  double stiffness_;  // EA [N]
  double weight_;     // in water [N/m]
  double drag_;       // at 1 m/s across [N/m]
  std::vector<double> s_;
  std::vector<core::Vector3> position_;
};

}  // namespace tether_monitor::monitor
