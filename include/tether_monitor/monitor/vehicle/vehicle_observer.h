#pragma once

#include <optional>

#include "tether_monitor/core/solve/adaptive_stepper.h"
#include "tether_monitor/core/solve/steady_state_solver.h"
#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"
#include "tether_monitor/monitor/measurements/measurement_history.h"
#include "tether_monitor/monitor/measurements/ring_buffer.h"
#include "tether_monitor/monitor/vehicle/innovation_gate.h"
#include "tether_monitor/monitor/vehicle/measurement_timing.h"
#include "tether_monitor/monitor/vehicle/vehicle_initializer.h"

namespace tether_monitor::monitor
{
/**
 * A simulated vehicle that measurements correct, each at its own time: doc/estimation.md.
 *
 * Steps the tether and remembers what drove it; a measurement that comes late sets everything back to a snapshot
 * state before it and steps rewindAndReplay. The filter pulls the simulated vehicle softly to where it believes it
 * is, so that no measurement is a shock to the tether. Steps without allocating.
 */
class VehicleObserver
{
 public:
  /// @param nodes  of the model.
  VehicleObserver(const Config& config, int nodes);

  /// What add() would answer; nothing changes.
  Rejection check(const VehicleMeasurement& fix) const;
  /// Accepts a measurement; those from before the beginning are of no more use and no fault.
  Rejection add(const VehicleMeasurement& fix);
  /// Attitude that the vehicle shall turn to.
  void setAttitude(const Eigen::Quaterniond& attitude) { attitude_ = attitude; }
  /// Forgets measurements and motion.
  void clear();

  /// Where the vehicle most probably is at time t [s] by the measurements alone, if it moves with `velocity`, with
  /// the covariance; none without measurements.
  std::optional<MeasuredVector> initialPositionEstimate(double t, const core::Vector3& velocity) const;
  /// True if any position has been measured.
  bool hasPosition() const { return timing_.newest() > -std::numeric_limits<double>::infinity(); }
  /// True if there are measurements enough to begin at time t [s].
  bool isReady(double t) const;

  /**
   * Steady state to begin with: the likeliest, given how unsure the position and the disturbance are.
   *
   * @param model            with the simulated vehicle.
   * @param ends             with the measured place of the tether's end at the vehicle.
   * @param covariance       of that place [m^2].
   * @param velocity_stddev  of the common velocity [m/s].
   * @param start            out: unchanged unless the report says converged.
   */
  core::SolveReport initialize(core::SteadyStateSolver& statics, const core::CableModel& model,
                               const core::SteadyEnds& ends, const core::Matrix3& covariance,
                               const core::Vector3& velocity_stddev, const core::Vector3& thrust,
                               VehicleInitialization& start) const;
  /// Begins at the state of an initialize(), to which the measured attitude is given.
  /// @param measured_at  time of the last position that it rests on [s].
  void begin(const core::CableModel& model, const VehicleInitialization& start, double measured_at,
             core::CableState& state);
  /// The model with the vehicle of `start`, what is known and what is not acting on it.
  core::CableModel modelWithInitialForces(const core::CableModel& model, const VehicleInitialization& start,
                                          const core::Vector3& thrust) const;
  /// Obstacle `k` is elsewhere at time t [s]: snapshots get it too.
  void moveObstacle(std::size_t k, const core::ObstacleMotion& now, double t);
  /// Another model from now on: snapshots of the old one are of no more use.
  void forgetPast(const core::CableState& state);
  /// Accepts memory for a model; begin() or the state of an archive must follow.
  void prepare(const core::CableModel& model);

  /**
   * Steps to time t [s], measurements included.
   *
   * @param paths          from state.time to t.
   * @param vessel_stddev  of the place of the vessel's end [m].
   * @param error_rate     how fast its errors are [1/s].
   * @return               the stepping, that again included; as AdaptiveStepper::advance().
   */
  core::SolveReport advance(const core::CableModel& model, core::AdaptiveStepper& stepper,
                            const core::BoundaryConditions& paths, const core::Vector3& vessel_stddev,
                            double error_rate, double t, core::CableState& state);

  /// Writes the vehicle and the standard deviations into an estimate whose tensions are known.
  void describe(TetherEstimate& estimate) const;

  /// Time of the beginning [s]; -infinity before.
  double initializedAt() const { return initialized_at_; }
  /// Age at time t [s] of the last position that was accepted; after begin().
  double age(double t) const { return t - filter_state_.gate.lastAccepted(); }
  /// Age at time t [s] of the last position that was measured; infinite before the first.
  double measuredAge(double t) const { return t - timing_.newest(); }
  /// See MeasurementTiming.
  double overdueTime(double age) const { return timing_.overdueTime(age); }
  /// True while positions, tether and vehicle contradict each other.
  bool isInconsistent(double t) const;
  /// True while the measured ends are farther apart than the tether is long.
  bool exceedsTetherLength() const;
  const InnovationStatistics& innovations() const { return filter_state_.gate.report(); }
  const VehicleErrorStateFilter& filter() const { return filter_state_.filter; }
  /// Steps that were made rewindAndReplay for late measurements.
  long replayedSteps() const { return replayed_; }
  /// See MotionBuffer::isValid().
  bool isValid(const core::CableModel& model) const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(history_, filter_state_, attitude_, origin_, initialized_at_, replayed_, steps_, snapshots_, timing_);
  }

 private:
  static constexpr std::size_t SNAPSHOTS = 32;
  static constexpr double OUT_OF_ORDER = 3.0;  // [s] by which a measurement may be later than the latency
  static constexpr double SAME = 1e-9;         // [s]

  // What a measurement changes.
  struct FilterState
  {
    VehicleErrorStateFilter filter;
    InnovationGate gate;
    double relinearize_at = 0.0;
    double chord_excess = 0.0;  // by which the measured ends are too far apart, over its standard deviation, mean

    template <class Archive>
    void serialize(Archive& a)
    {
      a(filter, gate, relinearize_at, chord_excess);
    }
  };
  struct StepInput
  {
    double from = 0.0, to = 0.0;
    core::BoundaryConditions paths;
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
    bool has_attitude = false;
    double error_rate = 1.0;
    core::Vector3 vessel_stddev = core::Vector3::Zero();

    template <class Archive>
    void serialize(Archive& a)
    {
      a(from, to, paths, attitude, has_attitude, error_rate, vessel_stddev);
    }
  };
  struct StateSnapshot
  {
    core::CableState state;
    FilterState filter_state;

    template <class Archive>
    void serialize(Archive& a)
    {
      a(state, filter_state);
    }
  };

  core::SolveReport advanceOneStep(const StepInput& step, const core::CableModel& model,
                                   core::AdaptiveStepper& stepper, core::CableState& state);
  core::SolveReport rewindAndReplay(double from, const core::CableModel& model, core::AdaptiveStepper& stepper,
                                    core::CableState& state);
  void save(const core::CableState& state);
  void processMeasurement(const VehicleMeasurement& fix, const core::EndTrajectory& nominal, const StepInput& step,
                          const core::CableModel& model, const core::CableState& state);
  void updateChordExcess(const core::Vector3& chord, const VehicleMeasurement& fix, const StepInput& step,
                         const core::CableModel& model, const core::CableState& state);
  core::Vector3 dragOn(const core::CableModel& model, const core::CableState& state) const;
  static std::size_t stepsFor(const Config& config);
  double earliestTime() const;
  double oldestUsableTime(double t) const;
  core::EndMotion centre(const core::CableState& state) const;

  NavigationConfig navigation_;
  core::RigidBody body_;
  double invalid_timeout_;  // [s]
  MeasurementHistory history_;
  std::size_t steps_capacity_;
  std::optional<core::DeployedCable> cable_;  // of the state that is linearised
  core::EndDynamicStiffnessSolver solver_;
  FilterState filter_state_;
  std::optional<Eigen::Quaterniond> attitude_;
  core::Vector3 origin_ = core::Vector3::Zero();
  double initialized_at_;
  long replayed_ = 0;
  RingBuffer<StepInput> steps_;
  RingBuffer<StateSnapshot> snapshots_;
  MeasurementTiming timing_;
};

}  // namespace tether_monitor::monitor
