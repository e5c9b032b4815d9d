#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/core/analysis/vortex_shedding.h"
#include "tether_monitor/core/assembly/cable_model.h"
#include "tether_monitor/core/base/binary_archive.h"
#include "tether_monitor/core/cable/cable_state.h"
#include "tether_monitor/core/solve/adaptive_stepper.h"
#include "tether_monitor/core/solve/mesh_convergence.h"
#include "tether_monitor/core/solve/steady_state_solver.h"
#include "tether_monitor/monitor/alarms/alarm_set.h"
#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"
#include "tether_monitor/monitor/measurements/correction_blender.h"
#include "tether_monitor/monitor/measurements/motion_buffer.h"
#include "tether_monitor/monitor/measurements/payout_buffer.h"
#include "tether_monitor/monitor/vehicle/vehicle_observer.h"
#include "tether_monitor/monitor/vessel/vessel_motion_filter.h"

namespace tether_monitor::monitor
{
/// What drives the tether at one time, and how old the knowledge is.
struct EndTargets
{
  core::EndMotion vessel;
  core::EndMotion vehicle;                                 ///< not used in mode free.
  double vessel_age = 0.0;                                 ///< [s]
  double vehicle_age = 0.0;                                ///< [s]
  std::optional<core::PayoutState> payout = std::nullopt;  ///< deployed length and rate; none: the length stays.
  double payout_age = std::numeric_limits<double>::quiet_NaN();  ///< [s]
  core::Vector3 vessel_stddev = core::Vector3::Zero();           ///< of the vessel end's position [m].
  double vessel_error_rate = 1.0;                                ///< how fast its errors are [1/s].
};

/// A measured pose of a body's reference point.
struct PoseMeasurement
{
  static constexpr double UNTOLD = std::numeric_limits<double>::quiet_NaN();

  double t = 0.0;                                                   ///< its stamp [s].
  core::Vector3 position = core::Vector3::Zero();                   ///< world frame [m].
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< body to world, unit.
  core::Vector3 position_stddev =
      core::Vector3::Constant(UNTOLD);  ///< of every axis [m]; NaN: as configured;
                                        ///< VesselMotionFilter::UNMEASURED or more: none.
  double orientation_stddev = UNTOLD;   ///< [rad]; above 1: the orientation was not measured.
};

/// Measured rates of a body's reference point, world axes.
struct TwistMeasurement
{
  double t = 0.0;                                                                    ///< its stamp [s].
  core::Vector3 velocity = core::Vector3::Zero();                                    ///< [m/s]
  core::Vector3 angular_velocity = core::Vector3::Zero();                            ///< [rad/s]
  core::Vector3 velocity_stddev = core::Vector3::Constant(PoseMeasurement::UNTOLD);  ///< as position_stddev [m/s].
};

/// What stepping has cost since the start.
struct StepCount
{
  long steps = 0;
  long rejected = 0;
  long iterations = 0;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(steps, rejected, iterations);
  }
};

/**
 * The monitor of one tether: measurements in, estimate and alarms out. The only class that a shell needs.
 *
 * Live use: feed the tracks, call tick() at the monitor's rate. Use with known motion: begin() once, then
 * advance(). No clock, no log, no global state; copy an estimator to save it. Nothing here throws after
 * construction; after the first estimate advance() allocates nothing.
 */
class TetherEstimator
{
 public:
  /// @throws std::invalid_argument listing every problem of `config`.
  explicit TetherEstimator(const Config& config);

  /// RecordedMeasurements of the vessel and of the vehicle. In mode observed they may come late and out of order.
  Rejection addVessel(const PoseMeasurement& pose);
  Rejection addVessel(const TwistMeasurement& rates);
  Rejection addVehicle(const PoseMeasurement& pose);
  Rejection addVehicle(const TwistMeasurement& rates);
  /// Tells how the vessel's end moves before anything has measured its velocity; for mode observed.
  void setInitialVesselMotion(double t, const BodyState& vessel);
  const MotionBuffer& vesselTrack() const { return vessel_; }
  const MotionBuffer& vehicleTrack() const { return vehicle_; }
  /// A measurement had to be refused at time t [s]: the status is DEGRADED for a pose_timeout.
  void noteRejectedInput(double t) { rejected_at_ = t; }
  /// Replaces the current profile, from the next step on.
  void setCurrent(const core::CurrentProfile& current);
  /// Replaces the depth of the sea [m], from the next step on. @return false, and nothing changes, if there is no
  /// seabed in the configuration or the depth cannot be.
  bool setDepth(double depth);
  /**
   * Replaces the obstacles, whose places are those of time t [s]. One with the name of an old one keeps the grip
   * of the tether on it.
   * @return what is wrong with them, and nothing changes; empty if nothing is.
   */
  std::vector<std::string> setObstacles(double t, const std::vector<core::Obstacle>& obstacles);
  /// Thrust on a simulated vehicle at time t [s]; from the first on it ages like a pose.
  void setThrust(double t, const core::Wrench& thrust)
  {
    thrust_at_ = t;
    thrust_ = thrust;
  }
  /// Epoch of the clock that all times count from [s]: waves are those of the clock.
  void setEpoch(double epoch) { model_.sea().setEpoch(epoch); }
  /**
   * Report of the winch at time t [s]: deployed length [m] and its rate [m/s] (NaN: not told). The tether is paid
   * out accordingly; a leap that no winch makes lets it settle anew, with one estimate that says so.
   * @return false, and nothing changes, unless the length can be meshed, the rate is no infinity, and t is later
   * than that of the last report.
   */
  bool addPayout(double t, double length, double rate = TetherEstimate::NONE);

  /// Estimate at time t [s] from the tracks, which it interpolates or extrapolates to t.
  const TetherEstimate& tick(double t);

  /// Starts at time t [s] from the steady state between the ends that the tracks give; both tracks must have a
  /// pose.
  const TetherEstimate& beginFromTracks(double t) { return begin(t, targetsAt(t)); }
  /// True if everything that beginFromTracks() needs has been measured.
  bool canBegin(double t) const;
  /// Starts from the steady state between known ends, both moving at the vessel end's velocity, at time t [s].
  const TetherEstimate& begin(double t, const EndTargets& ends);
  /// Steps to time t [s], ends on the way to `ends`; begin() must have succeeded, else as begin().
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
  const StepCount& count() const { return count_; }
  /// How the last settling or stepping ended.
  const core::SolveReport& lastSolve() const { return last_solve_; }
  const core::CableModel& model() const { return model_; }
  const core::CableState& state() const { return state_; }
  /// Place of the model's coordinates in the world [m].
  const core::Vector3& origin() const { return origin_; }
  /// Elements and step in use, and what error they were chosen for; error NaN where they were given.
  const core::MeshSelection& mesh() const { return mesh_; }
  /// VortexShedding at the last look, once a second of model time.
  const core::VortexShedding& strumming() const { return strumming_; }
  bool isVehicleFree() const { return config_.vehicle_mode == VehicleMode::FREE; }
  bool isVehicleObserved() const { return config_.vehicle_mode == VehicleMode::OBSERVED; }
  /// Free or observed.
  bool isVehicleSimulated() const { return config_.vehicle_mode != VehicleMode::TRACKED; }
  /// Of mode observed.
  const VehicleObserver& observer() const { return observer_; }
  const VesselMotionFilter& vesselFilter() const { return vessel_filter_; }
  bool isSettled() const { return settled_; }

  /// Everything that changes while it works, as bytes: see core/archive.h. Inputs and estimate included.
  std::vector<std::uint8_t> save() const;
  /// Goes on from where save() was called in an estimator of the same configuration, bit for bit. @return false,
  /// and nothing changes, if the bytes are not such a state.
  bool restore(const std::vector<std::uint8_t>& bytes);

 private:
  friend class core::BinaryWriter;
  friend class core::BinaryReader;
  template <class Archive>
  void serialize(Archive& a)
  {
    a(state_, origin_, settled_, announced_settling_, started_, alarms_changed_, payout_rate_, strumming_at_,
      obstacles_at_, told_depth_, strumming_, retry_settling_at_, rejected_at_, thrust_, thrust_at_, vessel_,
      vehicle_, vessel_blender_, vehicle_blender_, payout_, alarms_, estimate_, count_, last_solve_, mesh_length_,
      mesh_chord_, mesh_velocity_, vessel_filter_, observer_);
  }
  void rebuild(core::CableModel model, const core::MeshSelection& mesh);
  const TetherEstimate& refuse(double t, Reason reason);
  const TetherEstimate& withhold(Reason reason);
  const TetherEstimate& publish(const EndTargets& ends);
  bool settle(double t, const EndTargets& ends);
  void selectMesh(const core::SteadyEnds& ends);
  bool needsMesh(const core::SteadyEnds& ends) const;
  bool isPossible(double length) const;
  double thrustAge(double t) const;
  double observedAge(double t) const;
  void moveObstacles(double t, const core::Vector3& origin);
  bool setLength(double length);
  void setVehicleAge(double age);
  void lookAtAges(double t);
  void lookAtStrumming();
  Reason degradation(const EndTargets& ends) const;
  EndTargets targetsAt(double t);
  void aimAtObserved(double t, EndTargets& targets);
  core::CableModel modelAtRest() const;
  double tensionStddev() const;
  Reason lackOf(double t) const;
  Reason doubt(double t) const;
  core::SolveReport step(const core::BoundaryConditions& paths, const EndTargets& ends, double t);
  core::SolveReport initialize(const core::SteadyEnds& steady, core::NodeField& shape);
  core::EndMotion targetOf(const MotionBuffer& track, const BodyConfig& body, double t,
                           CorrectionBlender& blender) const;

  Config config_;
  core::CableModel model_;
  core::AdaptiveStepper stepper_;
  core::SteadyStateSolver statics_;
  MotionBuffer vessel_, vehicle_;
  CorrectionBlender vessel_blender_, vehicle_blender_;
  VesselMotionFilter vessel_filter_;
  VehicleObserver observer_;
  PayoutBuffer payout_;
  core::Wrench thrust_;
  double thrust_at_ = TetherEstimate::NONE;
  AlarmSet alarms_;

  core::CableState state_;                        // relative to origin_
  core::Vector3 origin_ = core::Vector3::Zero();  // vessel end when it settled, on the surface
  bool settled_ = false;
  bool announced_settling_ = false;
  bool started_ = false;
  bool alarms_changed_ = false;
  double payout_rate_ = 0.0;  // of the model at its time [m/s]
  double strumming_at_;
  std::optional<double> told_depth_;  // by a message [m]
  double obstacles_at_;               // time of the places of the model's obstacles [s]; NaN: since ever
  double winch_capacity_;             // [m]; infinite without a winch
  core::VortexShedding strumming_;
  core::MeshSelection mesh_;
  // What it was chosen for.
  double mesh_length_ = TetherEstimate::NONE, mesh_chord_ = TetherEstimate::NONE;
  core::Vector3 mesh_velocity_ = core::Vector3::Zero();
  double retry_settling_at_ = 0.0;
  double rejected_at_;
  TetherEstimate estimate_;
  StepCount count_;
  core::SolveReport last_solve_;
};

}  // namespace tether_monitor::monitor
