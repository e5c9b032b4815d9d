#pragma once

#include "tether_monitor/monitor/ensemble/tether_ensemble.h"
#include "tether_monitor/monitor/estimator/vehicle_end.h"
#include "tether_monitor/monitor/measurements/thrust_buffer.h"

namespace tether_monitor::monitor
{
/// Simulated vehicles on an ensemble of tethers, which measurements correct: TetherEnsemble.
class ObservedVehicleEnd final : public VehicleEnd
{
 public:
  explicit ObservedVehicleEnd(const Config& config);
  std::unique_ptr<VehicleEnd> clone() const override { return std::make_unique<ObservedVehicleEnd>(*this); }

  Rejection add(const PoseMeasurement* pose, const TwistMeasurement* twist) override;
  Rejection addTension(double t, double tension) override;
  Rejection addDirection(double t, const core::Vector3& direction) override;
  void setThrust(double t, const core::Wrench& thrust) override;
  bool takesThrust() const override { return true; }
  std::optional<core::Wrench> reportedThrust(double t) const override { return thrust_.reportedAt(t); }
  bool acceptsLateMeasurements() const override { return true; }
  void clear() override;
  bool isReady(double t) const override { return ensemble_.isReady(t); }
  double age(double t, bool running) const override
  {
    return running ? ensemble_.age(t) : ensemble_.measuredAge(t);
  }
  double overdue(double age) const override;
  bool canCoast() const override { return true; }
  void aim(double t, EndTargets& targets) override { targets.vehicle_age = ensemble_.age(t); }
  void aimAtStart(double t, EndTargets& targets) override;
  core::SolveReport findStart(CableSimulation& simulation, const core::SteadyEnds& ends, const EndTargets& targets,
                              VehicleInitialization& start) const override;
  /// The vehicle stays where it was measured: the force on it changes instead.
  core::SolveReport refineStart(CableSimulation& simulation, const core::SteadyEnds& ends,
                                const EndTargets& targets, VehicleInitialization& start) const override
  {
    return findStart(simulation, ends, targets, start);
  }
  core::CableModel modelAtRest(const core::CableModel& model, const VehicleInitialization& start) const override;
  void begin(const VehicleInitialization& start, const EndTargets& targets, CableSimulation& simulation) override;
  core::SolveReport advance(core::BoundaryConditions& paths, const EndTargets& targets, double t,
                            CableSimulation& simulation) override;
  bool completeStart(CableSimulation& simulation, const core::SteadyEnds& ends, const EndTargets& targets,
                     VehicleInitialization& start) const override;
  void moveObstacle(std::size_t k, const CableSimulation& simulation) override;
  void forgetPast(const CableSimulation& simulation) override { ensemble_.takeObstacles(simulation); }
  void describe(CableSimulation& simulation, TetherEstimate& estimate) const override;
  Reason invalidReason(const TetherEstimate& estimate, const EndTargets& targets) const override;
  Reason degradedReason(const TetherEstimate& estimate) const override;
  void reportImprobable(const std::function<void(Subject, Implausibility)>& note) const override
  {
    ensemble_.reportImprobable(note);
  }
  void forgetWhatIsToldAnew(const Config& before, const Config& now) override
  {
    ensemble_.forgetWhatIsToldAnew(before, now);
  }
  void prepareForecast(ForecastStart& start) const override;
  const MotionBuffer& track() const override { return track_; }
  const TetherEnsemble* ensemble() const override { return &ensemble_; }
  bool isValid(const core::CableModel& model) const override;
  void write(core::BinaryWriter& archive) const override { archive(track_, ensemble_, thrust_); }
  void read(core::BinaryReader& archive) override { archive(track_, ensemble_, thrust_); }
  void prepare(const core::CableModel& model) override { ensemble_.prepare(model); }

 private:
  VehicleMeasurement positionFix(const PoseMeasurement& pose) const;
  VehicleMeasurement velocityFix(const TwistMeasurement& twist) const;
  Rejection check(const PoseMeasurement* pose, const TwistMeasurement* twist) const;
  core::Matrix3 positionCovariance(const EndTargets& targets) const;
  core::Vector3 thrustInWorld() const { return track_.lastOrientation() * thrust_.latest().force; }

  core::Vector3 attachment_;
  double least_stddev_;  // of positions [m]
  NavigationConfig navigation_;
  UncertaintyConfig uncertainty_;
  double pose_timeout_, invalid_timeout_;  // [s]
  double working_load_;                    // [N]
  MotionBuffer track_;
  TetherEnsemble ensemble_;
  ThrustBuffer thrust_;
};

}  // namespace tether_monitor::monitor
