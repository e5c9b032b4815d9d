#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/monitor/alarms/alarm_set.h"
#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/ensemble/parameter_report.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"
#include "tether_monitor/monitor/estimator/alarm_input_tracker.h"
#include "tether_monitor/monitor/estimator/estimation_cycle.h"
#include "tether_monitor/monitor/estimator/forecast_inputs.h"

namespace tether_monitor::monitor
{
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
  Rejection addVessel(const PoseMeasurement& pose) { return cycle_.vessel().add(&pose, nullptr); }
  Rejection addVessel(const TwistMeasurement& rates) { return cycle_.vessel().add(nullptr, &rates); }
  Rejection addVessel(const PoseMeasurement& pose, const TwistMeasurement& rates)
  {
    return cycle_.vessel().add(&pose, &rates);
  }
  Rejection addVehicle(const PoseMeasurement& pose) { return cycle_.vehicle().add(&pose, nullptr); }
  Rejection addVehicle(const TwistMeasurement& rates) { return cycle_.vehicle().add(nullptr, &rates); }
  Rejection addVehicle(const PoseMeasurement& pose, const TwistMeasurement& rates)
  {
    return cycle_.vehicle().add(&pose, &rates);
  }
  /// How the vessel moves before anything has measured its velocity; for mode observed.
  void setInitialVesselMotion(double t, const BodyState& vessel) { cycle_.vessel().setInitialMotion(t, vessel); }
  /// Something unbelievable that was seen of an input at time t [s], beside what is found here.
  void noteImplausible(Subject subject, Implausibility what, double t)
  {
    cycle_.findings().note(subject, what, t);
  }
  /// A measurement had to be refused at time t [s]: the status is DEGRADED for a pose_timeout.
  void noteRejectedInput(double t) { cycle_.watchdog().noteRejectedInput(t); }
  /// A reading of the load cell at the vessel end [N] at time t [s]: in mode observed it corrects the estimate, in
  /// every mode it is compared with it (alarm `mismatch`).
  Rejection addTension(double t, double tension);
  /// Turns of the tether as somebody has counted them; headings go on from there. @return false, and nothing
  /// changes, unless finite.
  bool setTurns(double turns) { return alarm_inputs_.setTurns(turns); }
  /// Where the vessel is meant to go, for forecasts, until the next plan or reset(). @return why it cannot be;
  /// empty: it was taken. No points: there is no plan. Allocates.
  std::string setPlan(const std::vector<VesselPlan::Point>& points) { return forecast_inputs_.setPlan(points); }
  /// What the winch is meant to do, likewise. @return false, and nothing changes, unless its numbers can be.
  bool setPayoutPlan(const PayoutPlan& plan);
  /// What only the caller knows and alarms watch; until the next report.
  void report(const ShellReport& report) { alarm_inputs_.report(report); }
  /// The direction in which the tether leaves the vessel at time t [s], any length, world axes; for mode observed.
  Rejection addDirection(double t, const core::Vector3& direction)
  {
    return cycle_.vehicle().addDirection(t, direction);
  }
  /// Replaces the current profile, from the next step on.
  void setCurrent(const core::CurrentProfile& current);
  /// Replaces the depth of the sea [m], from the next step on. @return false, and nothing changes, if there is no
  /// seabed in the configuration or the depth cannot be.
  bool setDepth(double depth) { return cycle_.setDepth(depth); }
  /// See ObstacleTracker::set().
  std::vector<std::string> setObstacles(double t, const std::vector<core::Obstacle>& obstacles)
  {
    return cycle_.setObstacles(t, obstacles);
  }
  /// Thrust on a simulated vehicle at time t [s], body axes; in mode free it ages like a pose from the first on.
  void setThrust(double t, const core::Wrench& thrust) { cycle_.vehicle().setThrust(t, thrust); }
  /// Epoch of the clock that all times count from [s]: waves are those of the clock.
  void setEpoch(double epoch);
  /**
   * Report of the winch at time t [s]: deployed length [m] and its rate [m/s] (NaN: not reported). The tether is
   * paid out accordingly; a leap that no winch makes lets it settle anew, with one estimate that says so.
   * @return false, and nothing changes, unless the length can be meshed, the rate is no infinity, and t is later
   * than that of the last report.
   */
  bool addPayout(double t, double length, double rate = TetherEstimate::NONE)
  {
    return cycle_.addPayout(t, length, rate);
  }

  /**
   * The tether parts in the element at arc length s from the vessel end [m], which holds nothing from the next
   * step on; reset() mends it. Both pieces go on, but a parted tether cannot settle anew: then the estimate stays
   * INVALID.
   * @return false, and nothing changes, if the tether is not in motion, or s is not on it.
   */
  bool part(double s) { return cycle_.part(s); }

  /**
   * Goes on with other numbers of liveSettings(). What was learnt of a drag, or of what has another uncertainty
   * now, is forgotten: it begins with what is told. Allocates, and takes as long as a restore().
   *
   * @return every problem of `config`; empty: done, else nothing has changed.
   */
  std::vector<std::string> reconfigure(const Config& config);

  /// Estimate at time t [s] from the measurements, which it interpolates or extrapolates to t.
  const TetherEstimate& tick(double t);

  /// True if everything that beginFromTracks() needs has been measured.
  bool canBegin(double t) const { return cycle_.canBegin(t); }
  /// Starts at time t [s] from the steady state between the ends that the measurements give; canBegin() must hold.
  const TetherEstimate& beginFromTracks(double t) { return watched(cycle_.beginFromTracks(t)); }
  /// Starts from the steady state between known ends, both moving at the vessel end's velocity, at time t [s].
  const TetherEstimate& begin(double t, const EndTargets& ends) { return watched(cycle_.begin(t, ends)); }
  /// Steps to time t [s] towards `ends`; begin() must have succeeded, else as begin().
  const TetherEstimate& advance(double t, const EndTargets& ends) { return watched(cycle_.advance(t, ends)); }

  /// With true, tick() looks for a start in a thread of its own: no tick waits for it; the status is SETTLING
  /// meanwhile. Default false: the same input gives the same output. Not saved.
  void setBackgroundStart(bool background) { cycle_.setBackgroundStart(background); }

  /// Forgets motion, measurements and settles anew. Alarms stay as they are.
  void reset();
  /// Acknowledges all alarms at the time of the last estimate. @return how many changed.
  int acknowledge() { return alarms_.acknowledge(estimate().time); }
  /// An operator's action on one alarm at that time; see AlarmSet::act().
  std::string actOnAlarm(const std::string& name, AlarmAction action, double seconds)
  {
    return alarms_.act(name, action, estimate().time, seconds);
  }

  const Config& config() const { return config_; }
  const TetherEstimate& estimate() const { return cycle_.estimate(); }
  const AlarmSet& alarms() const { return alarms_; }
  /// What alarms watch beside the estimate, load cell and snag included.
  const AlarmInputTracker& alarmInputs() const { return alarm_inputs_; }
  /// True if any alarm changed its state in the last estimate.
  bool alarmsChanged() const { return alarms_changed_; }
  /// What a control loop must see: true while INVALID, and unless nothing is out while a limit alarm of
  /// over-tension or breaking is active or latched.
  bool overTension() const
  {
    return estimate().status == Status::INVALID || (!estimate().is_stowed && alarms_.overTension());
  }
  Phase phase() const { return cycle_.phase(); }
  bool isRunning() const { return cycle_.isRunning(); }
  /// The tether that is stepped: model, state, mesh, cost.
  const CableSimulation& simulation() const { return cycle_.simulation(); }
  const VesselEnd& vessel() const { return cycle_.vessel(); }
  const VehicleEnd& vehicle() const { return cycle_.vehicle(); }
  /// What was found unbelievable of the inputs, and when.
  const PlausibilityRecord& findings() const { return cycle_.findings().record(); }
  /// How long such a thing stays in the tether [s].
  double memory() const { return cycle_.memory(); }
  const core::VortexShedding& vortexShedding() const { return cycle_.vortexShedding(); }
  /// What is believed of tether, water and vehicle; empty unless an ensemble is in motion. Allocates.
  std::vector<ParameterEstimate> parameters() const;

  /// What a forecast begins with, copied; nothing unless a tether is in motion and its estimate is valid.
  /// Allocates.
  std::optional<ForecastStart> forecastStart() const;

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
    a(cycle_, alarms_changed_, alarms_, alarm_inputs_, forecast_inputs_);
  }
  const TetherEstimate& watched(const TetherEstimate& estimate);

  Config config_;
  EstimationCycle cycle_;
  AlarmInputTracker alarm_inputs_;
  AlarmSet alarms_;
  bool alarms_changed_ = false;
  ForecastInputs forecast_inputs_;
};

}  // namespace tether_monitor::monitor
