#pragma once

#include "tether_monitor/monitor/estimator/tension_band.h"
#include "tether_monitor/monitor/estimator/tracked_body.h"
#include "tether_monitor/monitor/estimator/vehicle_end.h"

namespace tether_monitor::monitor
{
/// The vehicle's end held on the measured motion.
class TrackedVehicleEnd final : public VehicleEnd
{
 public:
  explicit TrackedVehicleEnd(const Config& config);
  std::unique_ptr<VehicleEnd> clone() const override { return std::make_unique<TrackedVehicleEnd>(*this); }

  Rejection add(const PoseMeasurement* pose, const TwistMeasurement* twist) override
  {
    return body_.add(pose, twist);
  }
  void clear() override { body_.clear(); }
  bool isReady(double /*t*/) const override { return track().hasPose(); }
  double age(double t, bool /*running*/) const override { return track().age(t); }
  void aim(double t, EndTargets& targets) override;
  void aimAtStart(double t, EndTargets& targets) override { aim(t, targets); }
  core::SolveReport findStart(CableSimulation& simulation, const core::SteadyEnds& ends, const EndTargets& targets,
                              VehicleInitialization& start) const override;
  core::SolveReport advance(core::BoundaryConditions& paths, const EndTargets& targets, double t,
                            CableSimulation& simulation) override;
  void begin(const VehicleInitialization& start, const EndTargets& targets, CableSimulation& simulation) override;
  /// Writes the standard deviations of the tensions if that of the positions is configured.
  void describe(CableSimulation& simulation, TetherEstimate& estimate) const override;
  /// UNCERTAIN where the positions scatter too much for a tether as taut as this.
  Reason degradedReason(const TetherEstimate& estimate) const override;
  const MotionBuffer& track() const override { return body_.track(); }
  const MotionPlausibility* plausibility() const override { return &body_.plausibility(); }
  bool takeLeap() override { return body_.takeLeap(); }
  bool isValid(const core::CableModel& /*model*/) const override { return body_.isValid(); }
  void write(core::BinaryWriter& archive) const override { archive(body_, band_); }
  void read(core::BinaryReader& archive) override { archive(body_, band_); }
  void prepare(const core::CableModel& model) override { band_.begin(model); }

 private:
  TrackedBody body_;
  std::optional<double> position_stddev_;  // configured [m]
  double working_load_;                    // [N]
  TensionBand band_;
};

}  // namespace tether_monitor::monitor
