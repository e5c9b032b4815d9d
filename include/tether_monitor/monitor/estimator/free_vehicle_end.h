#pragma once

#include "tether_monitor/monitor/estimator/tracked_body.h"
#include "tether_monitor/monitor/estimator/vehicle_end.h"
#include "tether_monitor/monitor/measurements/thrust_buffer.h"

namespace tether_monitor::monitor
{
/// A simulated vehicle under a measured thrust; its measured motion is kept, but not used.
class FreeVehicleEnd final : public VehicleEnd
{
 public:
  explicit FreeVehicleEnd(const Config& config) : body_(config.vehicle, config.pose_timeout) {}
  std::unique_ptr<VehicleEnd> clone() const override { return std::make_unique<FreeVehicleEnd>(*this); }

  Rejection add(const PoseMeasurement* pose, const TwistMeasurement* twist) override
  {
    return body_.add(pose, twist);
  }
  void setThrust(double t, const core::Wrench& thrust) override;
  bool takesThrust() const override { return true; }
  std::optional<core::Wrench> reportedThrust(double t) const override { return thrust_.reportedAt(t); }
  bool needsPoses() const override { return false; }
  void clear() override;
  bool isReady(double /*t*/) const override { return true; }
  /// Of the thrust: from the first on it ages as a pose does.
  double age(double t, bool running) const override;
  void aim(double t, EndTargets& targets) override { targets.vehicle_age = age(t, true); }
  void aimAtStart(double t, EndTargets& targets) override { aim(t, targets); }
  core::SolveReport findStart(CableSimulation& simulation, const core::SteadyEnds& ends, const EndTargets& targets,
                              VehicleInitialization& start) const override;
  core::CableModel modelAtRest(const core::CableModel& model, const VehicleInitialization& start) const override;
  core::SolveReport advance(core::BoundaryConditions& paths, const EndTargets& targets, double t,
                            CableSimulation& simulation) override;
  void prepareForecast(ForecastStart& start) const override;
  void describe(CableSimulation& simulation, TetherEstimate& estimate) const override;
  const MotionBuffer& track() const override { return body_.track(); }
  bool isValid(const core::CableModel& /*model*/) const override { return body_.isValid() && thrust_.isValid(); }
  void write(core::BinaryWriter& archive) const override { archive(body_, thrust_); }
  void read(core::BinaryReader& archive) override { archive(body_, thrust_); }

 private:
  TrackedBody body_;
  ThrustBuffer thrust_;
};

}  // namespace tether_monitor::monitor
