#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/monitor/estimator/vehicle_end.h"
#include "tether_monitor/monitor/forecast/forecast_start.h"

namespace tether_monitor::monitor
{
/// Watches the ends of a tether in motion, and copies what a forecast begins with. Plain data: copy it to save it.
class ForecastInputs
{
 public:
  explicit ForecastInputs(const Config& config) : max_thrust_(config.max_thrust) {}

  /// The simulation has come to a new time; the estimate is of that time, with stations.
  void observe(const TetherEstimate& estimate, const CableSimulation& simulation, const VehicleEnd& vehicle);
  void clear();
  /// Of a tether that has been observed. @param payout_rate  reported [m/s]; NaN: none is. Allocates.
  ForecastStart start(const CableSimulation& simulation, const VehicleEnd& vehicle, double payout_rate) const;
  bool isReady() const { return vessel_.isReady(); }
  bool isValid() const
  {
    return vessel_.isValid() && vehicle_.isValid() && reaction_.isValid() && winch_.isValid() && plan_.isValid();
  }
  /// See VesselPlan::set(). A plan stays until the next one.
  std::string setPlan(const std::vector<VesselPlan::Point>& points) { return plan_.set(points); }
  void setPayoutPlan(const PayoutPlan& plan) { payout_plan_ = plan; }
  void clearPlans();

  template <class Archive>
  void serialize(Archive& a)
  {
    a(vessel_, vehicle_, reaction_, winch_, plan_, payout_plan_);
  }

 private:
  std::optional<double> max_thrust_;  // [N]
  EndMotionPredictor vessel_{true}, vehicle_{false};
  ThrustReaction reaction_;
  WinchReaction winch_;
  VesselPlan plan_;
  std::optional<PayoutPlan> payout_plan_;
};

}  // namespace tether_monitor::monitor
