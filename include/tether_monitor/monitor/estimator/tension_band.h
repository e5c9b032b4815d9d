#pragma once

#include <limits>

#include "tether_monitor/core/analysis/dynamic_stiffness.h"
#include "tether_monitor/monitor/model/cable_simulation.h"

namespace tether_monitor::monitor
{
/// How far the scatter of the positions of two held ends shakes the tensions there: the dynamic stiffness of the
/// tether times the scatter, renewed once a second.
class TensionBand
{
 public:
  explicit TensionBand(const core::CableModel& model) : nodes_(model.nodes()), solver_(model.nodes()) {}

  /// Scatter of the positions, standard deviations of every axis [m], and how often they come.
  struct Scatter
  {
    double vessel = 0.0, vehicle = 0.0;  ///< [m]
    double interval = 0.05;              ///< between the vehicle's [s], > 0.
  };

  /// Forgets what it knows; takes memory for another model.
  void begin(const core::CableModel& model);
  /// To be called after every step; does nothing for a second after it has.
  void update(CableSimulation& simulation, const Scatter& scatter);

  /// Standard deviations of the sizes of the end forces [N]; NaN while they are not known.
  double vessel() const { return vessel_; }
  double vehicle() const { return vehicle_; }

  /// What it knows; begin() must have seen the model.
  template <class Archive>
  void serialize(Archive& a)
  {
    a(updated_at_, vessel_, vehicle_);
  }

 private:
  static constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

  int nodes_;
  core::EndDynamicStiffnessSolver solver_;
  core::EndDynamicStiffness stiffness_;
  double updated_at_ = -std::numeric_limits<double>::infinity();
  double vessel_ = NONE, vehicle_ = NONE;
};

}  // namespace tether_monitor::monitor
