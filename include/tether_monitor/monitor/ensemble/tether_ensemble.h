#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "tether_monitor/monitor/ensemble/ensemble_filter.h"
#include "tether_monitor/monitor/ensemble/ensemble_members.h"
#include "tether_monitor/monitor/ensemble/ensemble_summary.h"
#include "tether_monitor/monitor/ensemble/measurement_timing.h"
#include "tether_monitor/monitor/ensemble/vehicle_initializer.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"
#include "tether_monitor/monitor/measurements/implausibility.h"
#include "tether_monitor/monitor/measurements/measurement_history.h"

namespace tether_monitor::monitor
{
/**
 * An ensemble of tethers that measurements correct: doc/theory/estimation.md.
 *
 * Members know of different parameters; what they predict of a measurement tells which are right. Measurements may
 * come late, out of order and twice: add() them as they come, advance() uses them. The stepping path allocates
 * nothing.
 */
class TetherEnsemble
{
 public:
  explicit TetherEnsemble(const Config& config);

  /// What add() would answer; nothing changes.
  Rejection check(const VehicleMeasurement& fix) const;
  Rejection add(const VehicleMeasurement& fix);
  void setAttitude(const Eigen::Quaterniond& attitude) { attitude_ = attitude; }
  void clear();

  /// True if any position has been measured.
  bool hasPosition() const { return timing_.newest() > -std::numeric_limits<double>::infinity(); }
  /// True if there are positions enough to begin at time t [s].
  bool isReady(double t) const;
  /// Measured position of the centre of mass at time t [s]: the median of the last few, moved on with `velocity`
  /// [m/s]. None before every axis has been measured.
  std::optional<MeasuredVector> initialPositionEstimate(double t, const core::Vector3& velocity) const;

  /// Steady state to begin with, and that of every member. @param start  out: unchanged unless the report says
  /// converged.
  core::SolveReport initialize(core::SteadyStateSolver& statics, const core::CableModel& model,
                               const core::SteadyEnds& ends, const core::Matrix3& covariance,
                               const core::Vector3& thrust, VehicleInitialization& start) const;
  /// The members of a start whose nominal state is found. @return false if they have no steady states.
  bool findMembers(core::SteadyStateSolver& statics, const core::CableModel& model, const core::SteadyEnds& ends,
                   const core::Matrix3& covariance, const core::Vector3& velocity_stddev,
                   const core::Vector3& thrust, VehicleInitialization& start) const;
  core::CableModel modelWithInitialForces(const core::CableModel& model, const VehicleInitialization& start,
                                          const core::Vector3& thrust) const;
  /// Begins at the state of `simulation`. @param measured_at  time of the last position that it rests on [s].
  void begin(const VehicleInitialization& start, double measured_at, CableSimulation& simulation);
  /// See EnsembleFilter.
  void forgetWhatIsToldAnew(const Config& before, const Config& now) { filter_.forgetWhatIsToldAnew(before, now); }
  void moveObstacle(std::size_t k, const core::ObstacleMotion& now) { members_.moveObstacle(k, now); }
  void takeObstacles(const CableSimulation& simulation) { members_.takeObstacles(simulation); }
  /// Accepts memory for a model; the state of an archive must follow.
  void prepare(const core::CableModel& model);

  /**
   * Steps to time t [s], measurements included.
   *
   * @param paths          from state.time to t.
   * @param vessel_stddev  of the place of the vessel's end [m].
   * @param error_rate     how fast its errors are [1/s].
   * @param state          out: of the representative member.
   */
  core::SolveReport advance(const core::CableModel& model, const core::BoundaryConditions& paths,
                            const core::Vector3& vessel_stddev, double error_rate, double t,
                            core::CableState& state);

  /// Writes what is known of the vehicle, and the distributions, into an estimate of the representative member.
  void describe(const core::DeployedCable& cable, TetherEstimate& estimate) const;

  /// Age at time t [s] of the last position that was accepted; after begin().
  double age(double t) const { return t - filter_.gate().lastAccepted(); }
  /// Age at time t [s] of the last position that was measured; infinite before the first.
  double measuredAge(double t) const { return t - timing_.newest(); }
  /// See MeasurementTiming.
  double overdueTime(double age) const { return timing_.overdueTime(age); }
  /// True while measurements and model contradict each other.
  bool isInconsistent(double t) const;
  /// What only a deviation far beyond its standard deviation explains. @param note  called for each.
  void reportImprobable(const std::function<void(Subject, Implausibility)>& note) const;
  const InnovationStatistics& innovations() const { return filter_.gate().report(); }
  const EnsembleFilter& filter() const { return filter_; }
  const EnsembleMembers& members() const { return members_; }
  const EnsembleSummary& summary() const { return summary_; }
  /// Measured attitude that the vehicles are held in.
  const std::optional<Eigen::Quaterniond>& attitude() const { return attitude_; }
  bool isValid(const core::CableModel& model) const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(history_, filter_, members_, summary_, attitude_, origin_, initialized_at_, relinearize_at_, timing_);
  }

 private:
  core::SolveReport advanceOnePart(const core::CableModel& model, const core::BoundaryConditions& paths,
                                   const core::Vector3& vessel_stddev, double error_rate, double t);
  void linearize(double error_rate);
  void summarize(const core::Vector3& vessel_stddev);
  void followLoadCell(double common);
  double oldestUsableTime(double t) const;

  NavigationConfig navigation_;
  core::RigidBody body_;
  double invalid_timeout_;  // [s]
  MeasurementHistory history_;
  core::EndDynamicStiffnessSolver solver_;
  EnsembleMembers members_;
  EnsembleFilter filter_;
  EnsembleSummary summary_;
  EnsembleSummary::Own own_;
  Eigen::RowVectorXd residual_;  // of the load cell, of every member [N]
  MemberVectors position_;
  std::optional<Eigen::Quaterniond> attitude_;
  core::Vector3 origin_ = core::Vector3::Zero();
  double initialized_at_;
  double relinearize_at_ = 0.0;
  MeasurementTiming timing_;
};

}  // namespace tether_monitor::monitor
