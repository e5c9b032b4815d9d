#pragma once

#include "tether_monitor/monitor/estimator/tracked_body.h"
#include "tether_monitor/monitor/estimator/vehicle_end.h"

namespace tether_monitor::monitor
{
/// The vehicle's end held on the measured motion.
class TrackedVehicleEnd final : public VehicleEnd
{
 public:
  explicit TrackedVehicleEnd(const Config& config) : body_(config.vehicle, config.pose_timeout) {}
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
  const MotionBuffer& track() const override { return body_.track(); }
  bool isValid(const core::CableModel& /*model*/) const override { return track().isValid(); }
  void write(core::BinaryWriter& archive) const override { archive(body_); }
  void read(core::BinaryReader& archive) override { archive(body_); }

 private:
  TrackedBody body_;
};

}  // namespace tether_monitor::monitor
