#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tether_monitor/monitor/alarms/alarm_set.h"
#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"
#include "tether_monitor/monitor/estimator/cloned_pointer.h"
#include "tether_monitor/monitor/estimator/input_watchdog.h"
#include "tether_monitor/monitor/estimator/obstacle_tracker.h"
#include "tether_monitor/monitor/estimator/payout_follower.h"
#include "tether_monitor/monitor/estimator/vehicle_end.h"
#include "tether_monitor/monitor/estimator/vessel_end.h"
#include "tether_monitor/monitor/estimator/vortex_shedding_monitor.h"
#include "tether_monitor/monitor/model/cable_simulation.h"

namespace tether_monitor::monitor
{
/// What an estimator is doing.
enum class Phase
{
  IDLE,      ///< nothing has happened yet.
  WAITING,   ///< for measurements enough to begin.
  STARTING,  ///< a start has been announced (SETTLING) and is looked for.
  RUNNING    ///< the tether is in motion.
};

/**
 * The monitor of one tether: measurements in, estimate and alarms out. The only class that a shell needs.
 *
 * Live use: feed the measurements, call tick() at the monitor's rate. Use with known motion: begin() once, then
 * advance(). No clock, no log, no global state; copy an estimator to save it. Nothing here throws after
 * construction; after the first estimate advance() allocates nothing.
 */
class TetherEstimator
{
 public:
  /// @throws std::invalid_argument listing every problem of `config`.
  explicit TetherEstimator(const Config& config);

  /// What one message measured of the vessel or of the vehicle; accepted as a whole, or nothing changes. In mode
  /// observed they may come late and out of order.
  Rejection addVessel(const PoseMeasurement& pose) { return vessel_->add(&pose, nullptr); }
  Rejection addVessel(const TwistMeasurement& rates) { return vessel_->add(nullptr, &rates); }
  Rejection addVessel(const PoseMeasurement& pose, const TwistMeasurement& rates)
  {
    return vessel_->add(&pose, &rates);
  }
  Rejection addVehicle(const PoseMeasurement& pose) { return vehicle_->add(&pose, nullptr); }
  Rejection addVehicle(const TwistMeasurement& rates) { return vehicle_->add(nullptr, &rates); }
  Rejection addVehicle(const PoseMeasurement& pose, const TwistMeasurement& rates)
  {
    return vehicle_->add(&pose, &rates);
  }
  /// How the vessel moves before anything has measured its velocity; for mode observed.
  void setInitialVesselMotion(double t, const BodyState& vessel) { vessel_->setInitialMotion(t, vessel); }
  /// A measurement had to be refused at time t [s]: the status is DEGRADED for a pose_timeout.
  void noteRejectedInput(double t) { watchdog_.noteRejectedInput(t); }
  /// Replaces the current profile, from the next step on.
  void setCurrent(const core::CurrentProfile& current);
  /// Replaces the depth of the sea [m], from the next step on. @return false, and nothing changes, if there is no
  /// seabed in the configuration or the depth cannot be.
  bool setDepth(double depth);
  /// See ObstacleTracker::set().
  std::vector<std::string> setObstacles(double t, const std::vector<core::Obstacle>& obstacles);
  /// Thrust on a simulated vehicle at time t [s], body axes; in mode free it ages like a pose from the first on.
  void setThrust(double t, const core::Wrench& thrust) { vehicle_->setThrust(t, thrust); }
  /// Epoch of the clock that all times count from [s]: waves are those of the clock.
  void setEpoch(double epoch);
  /**
   * Report of the winch at time t [s]: deployed length [m] and its rate [m/s] (NaN: not reported). The tether is
   * paid out accordingly; a leap that no winch makes lets it settle anew, with one estimate that says so.
   * @return false, and nothing changes, unless the length can be meshed, the rate is no infinity, and t is later
   * than that of the last report.
   */
  bool addPayout(double t, double length, double rate = TetherEstimate::NONE);

  /// Estimate at time t [s] from the measurements, which it interpolates or extrapolates to t.
  const TetherEstimate& tick(double t);

  /// True if everything that beginFromTracks() needs has been measured.
  bool canBegin(double t) const { return vessel_->isReady(t) && vehicle_->isReady(t); }
  /// Starts at time t [s] from the steady state between the ends that the measurements give; canBegin() must hold.
  const TetherEstimate& beginFromTracks(double t) { return begin(t, targetsAt(t)); }
  /// Starts from the steady state between known ends, both moving at the vessel end's velocity, at time t [s].
  const TetherEstimate& begin(double t, const EndTargets& ends);
  /// Steps to time t [s] towards `ends`; begin() must have succeeded, else as begin().
  const TetherEstimate& advance(double t, const EndTargets& ends);

  /// Forgets motion, measurements and settles anew. Alarms stay as they are.
  void reset();
  /// Acknowledges all alarms at the time of the last estimate. @return how many changed.
  int acknowledge() { return alarms_.acknowledge(estimate_.time); }

  const Config& config() const { return config_; }
  const TetherEstimate& estimate() const { return estimate_; }
  const AlarmSet& alarms() const { return alarms_; }
  /// True if any alarm changed its state in the last estimate.
  bool alarmsChanged() const { return alarms_changed_; }
  /// What a control loop must see: true while INVALID or while the over-tension limit alarm is active or latched.
  bool overTension() const { return estimate_.status == Status::INVALID || alarms_.overTension(); }
  Phase phase() const { return phase_; }
  bool isRunning() const { return phase_ == Phase::RUNNING; }
  /// The tether that is stepped: model, state, mesh, cost.
  const CableSimulation& simulation() const { return simulation_; }
  const VesselEnd& vessel() const { return *vessel_; }
  const VehicleEnd& vehicle() const { return *vehicle_; }
  const core::VortexShedding& vortexShedding() const { return vortex_shedding_.last(); }

  /// Everything that changes while it works, as bytes: see binary_archive.h. Inputs and estimate included.
  std::vector<std::uint8_t> save() const;
  /// Goes on from where save() was called in an estimator of the same configuration, bit for bit. @return false,
  /// and nothing changes, if the bytes are not such a state.
  bool restore(const std::vector<std::uint8_t>& bytes);

 private:
  friend class EstimatorSnapshot;
  friend class core::BinaryWriter;
  friend class core::BinaryReader;
  template <class Archive>
  void serialize(Archive& a)
  {
    a(phase_, retry_start_at_, alarms_changed_, simulation_.state, simulation_.count, simulation_.last_solve,
      vessel_, vehicle_, payout_, obstacles_, watchdog_, vortex_shedding_, alarms_, estimate_);
  }

  EndTargets targetsAt(double t);
  void updateAges(double t);
  void setAges(const EndTargets& ends);
  void announceStart(double t);
  bool start(double t, const EndTargets& ends);
  core::SolveReport step(double t, const EndTargets& ends);
  const TetherEstimate& publish(const EndTargets& ends);
  const TetherEstimate& refuse(double t, Reason reason);
  const TetherEstimate& withhold(Reason reason);
  Reason degradedReason() const;

  Config config_;
  CableSimulation simulation_;
  ClonedPointer<VesselEnd> vessel_;
  ClonedPointer<VehicleEnd> vehicle_;
  PayoutFollower payout_;
  ObstacleTracker obstacles_;
  InputWatchdog watchdog_;
  VortexSheddingMonitor vortex_shedding_;
  AlarmSet alarms_;
  Phase phase_ = Phase::IDLE;
  double retry_start_at_ = 0.0;  // [s]
  bool alarms_changed_ = false;
  TetherEstimate estimate_;
};

}  // namespace tether_monitor::monitor
