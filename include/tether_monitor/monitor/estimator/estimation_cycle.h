#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"
#include "tether_monitor/monitor/estimator/cloned_pointer.h"
#include "tether_monitor/monitor/estimator/input_findings.h"
#include "tether_monitor/monitor/estimator/input_watchdog.h"
#include "tether_monitor/monitor/estimator/obstacle_tracker.h"
#include "tether_monitor/monitor/estimator/payout_follower.h"
#include "tether_monitor/monitor/estimator/start_worker.h"
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
 * The cycle of an estimator: looks at the ages of its inputs, finds a start, steps the tether, fills the estimate.
 *
 * A jump of the clock leads to WAITING; a stale input, a failed step or a leap of the deployed length to STARTING.
 * Every function that returns an estimate has filled it. See TetherEstimator for the meaning of its functions.
 */
class EstimationCycle
{
 public:
  /// @param config  valid.
  explicit EstimationCycle(const Config& config);

  VesselEnd& vessel() { return *vessel_; }
  const VesselEnd& vessel() const { return *vessel_; }
  VehicleEnd& vehicle() { return *vehicle_; }
  const VehicleEnd& vehicle() const { return *vehicle_; }
  InputWatchdog& watchdog() { return watchdog_; }
  void setEnvironment(const core::EnvironmentModel& environment);
  bool setDepth(double depth);
  std::vector<std::string> setObstacles(double t, const std::vector<core::Obstacle>& obstacles);
  bool addPayout(double t, double length, double rate);
  bool part(double s);

  bool canBegin(double t) const { return vessel_->isReady(t) && vehicle_->isReady(t); }
  const TetherEstimate& tick(double t);
  const TetherEstimate& beginFromTracks(double t) { return begin(t, targetsAt(t)); }
  const TetherEstimate& begin(double t, const EndTargets& ends);
  const TetherEstimate& advance(double t, const EndTargets& ends);
  void reset();
  /// Whether tick() looks for a start in a thread of its own, and is SETTLING meanwhile.
  void setBackgroundStart(bool background) { starts_in_background_ = background; }

  const TetherEstimate& estimate() const { return estimate_; }
  Phase phase() const { return phase_; }
  bool isRunning() const { return phase_ == Phase::RUNNING; }
  const CableSimulation& simulation() const { return simulation_; }
  CableSimulation& simulation() { return simulation_; }
  const InputFindings& findings() const { return findings_; }
  InputFindings& findings() { return findings_; }
  bool startsInBackground() const { return starts_in_background_; }
  /// How long what an input has done stays in the tether [s].
  double memory() const;
  const core::VortexShedding& vortexShedding() const { return vortex_shedding_.last(); }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(phase_, retry_start_at_, settles_until_, simulation_.state, simulation_.count, simulation_.last_solve,
      vessel_, vehicle_, payout_, obstacles_, watchdog_, findings_, stowed_at_, vortex_shedding_, estimate_);
  }

 private:
  friend class EstimatorSnapshot;
  EndTargets targetsAt(double t);
  EndTargets targetsInMotion(double t);
  void updateAges(double t);
  void setAges(const EndTargets& ends);
  void announceStart(double t);
  bool start(double t, const EndTargets& ends);
  const TetherEstimate& startInBackground(double t);
  bool adopt(SteadyStart found, double t, const EndTargets& ends, double now);
  bool adoptFound(double now);
  void forgetStart();
  core::SolveReport step(double t, const EndTargets& ends);
  const TetherEstimate& publish(const EndTargets& ends);
  const TetherEstimate& refuse(double t, Reason reason);
  ReasonSet degradedReasons() const;
  const TetherEstimate& stowed(double t);

  Config config_;
  CableSimulation simulation_;
  ClonedPointer<VesselEnd> vessel_;
  ClonedPointer<VehicleEnd> vehicle_;
  PayoutFollower payout_;
  ObstacleTracker obstacles_;
  InputWatchdog watchdog_;
  VortexSheddingMonitor vortex_shedding_;
  Phase phase_ = Phase::IDLE;
  StartWorker start_worker_;
  bool starts_in_background_ = false;
  bool catches_up_ = false;      // a start has been found for a time that has passed
  double retry_start_at_ = 0.0;  // [s]
  double settles_until_ = 0.0;   // [s]; the tether was not at rest where it started
  InputFindings findings_;
  std::optional<double> stowed_at_;  // [s] of the last report that nothing is out
  TetherEstimate estimate_;
};

}  // namespace tether_monitor::monitor
