#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "tether_monitor/core/base/binary_archive.h"
#include "tether_monitor/core/cable/boundary_conditions.h"
#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/ensemble/tether_ensemble.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"
#include "tether_monitor/monitor/estimator/end_targets.h"
#include "tether_monitor/monitor/forecast/forecast_start.h"
#include "tether_monitor/monitor/measurements/measurements.h"
#include "tether_monitor/monitor/measurements/motion_buffer.h"
#include "tether_monitor/monitor/measurements/motion_plausibility.h"
#include "tether_monitor/monitor/model/cable_simulation.h"

namespace tether_monitor::monitor
{
/**
 * The vehicle's end of the tether, and with it the estimation: inputs up to a time in, motion with its uncertainty
 * out. Copyable by clone(), restorable by write() and read().
 */
class VehicleEnd
{
 public:
  virtual ~VehicleEnd() = default;
  virtual std::unique_ptr<VehicleEnd> clone() const = 0;

  /// Accepts what one message measured, all of it or nothing. @param pose,twist  null: none.
  virtual Rejection add(const PoseMeasurement* pose, const TwistMeasurement* twist) = 0;
  /// Thrust on a simulated vehicle at time t [s], body axes.
  virtual void setThrust(double /*t*/, const core::Wrench& /*thrust*/) {}
  virtual bool takesThrust() const { return false; }
  /// The thrust that was reported for time t [s], body axes; nothing: none was.
  virtual std::optional<core::Wrench> reportedThrust(double /*t*/) const { return std::nullopt; }
  /// True if it cannot do without measured poses.
  virtual bool needsPoses() const { return true; }
  /// True if measurements may come late and out of order.
  virtual bool acceptsLateMeasurements() const { return false; }
  /// Accepts a reading of the load cell at the vessel end [N].
  virtual Rejection addTension(double /*t*/, double /*tension*/) { return Rejection::NONE; }
  /// Accepts the direction in which the tether leaves the vessel, any length, world axes.
  virtual Rejection addDirection(double /*t*/, const core::Vector3& /*direction*/) { return Rejection::NONE; }
  virtual void clear() = 0;

  /// True if there are measurements enough to begin at time t [s].
  virtual bool isReady(double t) const = 0;
  /// Age at time t [s] of the last input; infinite while it is missed. @param running  a tether is in motion.
  virtual double age(double t, bool running) const = 0;
  /// How long an input has been due when the last is `age` old [s].
  virtual double overdue(double age) const { return age; }
  /// True if the vehicle can be simulated on for a while without inputs.
  virtual bool canCoast() const { return false; }
  /// The motion at time t [s] for a tether in motion; the vessel's is in `targets`. Calls in order of t.
  virtual void aim(double t, EndTargets& targets) = 0;
  /// The motion at time t [s] to begin with; the vessel's is in `targets`.
  virtual void aimAtStart(double t, EndTargets& targets) = 0;

  /// Steady state to begin with. @param start  out: its shape and, where they are estimated, its forces.
  virtual core::SolveReport findStart(CableSimulation& simulation, const core::SteadyEnds& ends,
                                      const EndTargets& targets, VehicleInitialization& start) const = 0;
  /// The same near a shape that was found, for other drag: `start` in and out.
  virtual core::SolveReport refineStart(CableSimulation& simulation, const core::SteadyEnds& ends,
                                        const EndTargets& targets, VehicleInitialization& start) const;
  /// What else there is to find of a start whose shape is final. @return false if it cannot be found.
  virtual bool completeStart(CableSimulation& /*simulation*/, const core::SteadyEnds& /*ends*/,
                             const EndTargets& /*targets*/, VehicleInitialization& /*start*/) const
  {
    return true;
  }
  /// The model with all the forces of a start.
  virtual core::CableModel modelAtRest(const core::CableModel& model, const VehicleInitialization& /*start*/) const
  {
    return model;
  }
  /// Begins at the simulation's state.
  virtual void begin(const VehicleInitialization& /*start*/, const EndTargets& /*targets*/,
                     CableSimulation& /*simulation*/)
  {
  }

  /// Steps to time t [s] towards the targets. @param paths  of the vessel and of the deployed length.
  virtual core::SolveReport advance(core::BoundaryConditions& paths, const EndTargets& targets, double t,
                                    CableSimulation& simulation) = 0;
  /// Obstacle `k` is elsewhere than the simulation had it.
  virtual void moveObstacle(std::size_t /*k*/, const CableSimulation& /*simulation*/) {}
  /// The simulation's model has changed.
  virtual void forgetPast(const CableSimulation& /*simulation*/) {}

  /// Writes the vehicle, and what is uncertain, into an estimate whose tensions are known.
  virtual void describe(CableSimulation& /*simulation*/, TetherEstimate& /*estimate*/) const {}
  /// What makes the numbers of such an estimate worthless at its time; NONE if nothing does. Its status and
  /// reasons are still those of the last estimate.
  virtual Reason invalidReason(const TetherEstimate& /*estimate*/, const EndTargets& /*targets*/) const
  {
    return Reason::NONE;
  }
  /// What makes them doubtful; likewise.
  virtual Reason degradedReason(const TetherEstimate& /*estimate*/) const { return Reason::NONE; }

  /// What makes its measurements unbelievable; null: nothing looks.
  virtual const MotionPlausibility* plausibility() const { return nullptr; }
  /// What only something far beyond its told size explains, as it is now: the argument is called for each.
  virtual void reportImprobable(const std::function<void(Subject, Implausibility)>& /*note*/) const {}
  /// The configuration is another than when it began: what was learnt of what has changed is forgotten.
  virtual void forgetWhatIsToldAnew(const Config& /*before*/, const Config& /*now*/) {}
  /// Fills in what a forecast begins with: members (none: that of the simulation), thrust, unknown force.
  virtual void prepareForecast(ForecastStart& /*start*/) const {}
  /// True once after the vehicle was found elsewhere, and the tether is held there.
  virtual bool takeLeap() { return false; }
  /// The poses and rates that came, in order.
  virtual const MotionBuffer& track() const = 0;
  /// Null in all modes but observed.
  virtual const TetherEnsemble* ensemble() const { return nullptr; }
  /// See MotionBuffer::isValid().
  virtual bool isValid(const core::CableModel& model) const = 0;
  virtual void write(core::BinaryWriter& archive) const = 0;
  virtual void read(core::BinaryReader& archive) = 0;
  /// Before read(): takes memory for the model that goes with what is read.
  virtual void prepare(const core::CableModel& /*model*/) {}
};

/// That of a mode.
std::unique_ptr<VehicleEnd> makeVehicleEnd(const Config& config);

}  // namespace tether_monitor::monitor
