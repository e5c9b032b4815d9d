#pragma once

#include <optional>

#include "tether_monitor/core/statics.h"
#include "tether_monitor/core/stepper.h"
#include "tether_monitor/monitor/config.h"
#include "tether_monitor/monitor/fix_judge.h"
#include "tether_monitor/monitor/fix_log.h"
#include "tether_monitor/monitor/ring.h"
#include "tether_monitor/monitor/tether_estimate.h"

namespace tether_monitor::monitor
{
/**
 * A simulated vehicle that measurements correct, each at its own time: doc/estimation.md.
 *
 * Steps the tether and remembers what drove it; a measurement that comes late sets everything back to a saved
 * state before it and steps again. The filter pulls the simulated vehicle softly to where it believes it is, so
 * that no measurement is a shock to the tether. Steps without allocating.
 */
class VehicleObserver
{
 public:
  /// @param nodes  of the model.
  VehicleObserver(const Config& config, int nodes);

  /// Takes a measurement; fixes from before the beginning are of no more use and no fault.
  Rejection add(const VehicleFix& fix);
  /// Attitude that the vehicle shall turn to.
  void setAttitude(const Eigen::Quaterniond& attitude) { attitude_ = attitude; }
  /// Forgets measurements and motion.
  void clear();

  /// Where the vehicle most probably is at time t [s] by the measurements alone, if it moves with `velocity`; none
  /// without measurements. findStart() trusts it as far as it is recent.
  std::optional<core::Vector3> firstPosition(double t, const core::Vector3& velocity);
  /// True if any position has been measured.
  bool hasPosition() const { return newest_ > -std::numeric_limits<double>::infinity(); }
  /// True if there are measurements enough to begin at time t [s].
  bool isReady(double t) const;

  /**
   * Steady state to begin with: the likeliest, given how unsure the position and the disturbance are.
   *
   * @param model  with the simulated vehicle.
   * @param ends   with the measured place of the tether's end at the vehicle.
   * @param velocity_stddev  of the common velocity [m/s].
   * @param shape  out: unchanged unless the report says converged.
   */
  core::SolveReport findStart(core::Statics& statics, const core::CableModel& model, const core::SteadyEnds& ends,
                              const core::Vector3& velocity_stddev, const core::Vector3& thrust,
                              core::NodeField& shape);
  /// Begins at a state of findStart(). @param origin  of the model's coordinates in the world [m].
  void begin(const core::CableModel& model, const core::Vector3& origin, core::CableState& state);
  /// The model with the vehicle of findStart(), what is told and what is not acting on it.
  core::CableModel startModel(const core::CableModel& model, const core::Vector3& thrust) const;
  /// Obstacle `k` is told to be elsewhere at time t [s]: saved states get it too.
  void moveObstacle(std::size_t k, const core::ObstacleMotion& now, double t);
  /// Another model from now on: saved states of the old one are of no more use.
  void forgetPast(const core::CableModel& model, const core::CableState& state);
  /// Another number of nodes; findStart() and begin() must follow.
  void setNodes(int nodes);

  /**
   * Steps to time t [s], measurements included.
   *
   * @param paths   from state.time to t.
   * @param vessel_stddev  of the place of the vessel's end [m]. @param error_rate  how fast its errors are [1/s].
   * @return        the stepping, that again included; as Stepper::advance().
   */
  core::SolveReport advance(core::CableModel& model, core::Stepper& stepper, const core::EndPaths& paths,
                            const core::Vector3& vessel_stddev, double error_rate, double t,
                            core::CableState& state);

  /// Writes the vehicle and the standard deviations into an estimate whose tensions are known.
  void describe(TetherEstimate& estimate) const;

  /// Time of the beginning [s]; -infinity before.
  double begunAt() const { return begun_at_; }
  /// Age at time t [s] of the last position that was believed; after begin().
  double age(double t) const { return t - live_.judge.lastAccepted(); }
  /// Age at time t [s] of the last position that was measured; infinite before the first.
  double measuredAge(double t) const { return t - newest_; }
  /// Time for which measurements that were due have not come [s], when the last is `age` old: less latency and two
  /// of their usual intervals.
  double silence(double age) const { return age - lateness_ - 2.0 * interval_; }
  /// True while positions, tether and vehicle contradict each other.
  bool isDisputed(double t) const;
  /// True while the measured ends are farther apart than the tether is long.
  bool isOverstretched() const;
  const InnovationReport& innovations() const { return live_.judge.report(); }
  const VehicleFilter& filter() const { return live_.filter; }
  /// Steps that were made again for late measurements.
  long repeatedSteps() const { return repeated_; }
  /// See BodyTrack::isSound(). @param original  the observer before it was overwritten.
  bool isSound(const core::CableModel& model, const VehicleObserver& original) const;

  template <class Archive>
  void archive(Archive& a)
  {
    a(log_, live_, attitude_, origin_, begun_at_, first_stddev_, start_scale_, start_force_, start_place_,
      start_doubt_, repeated_, steps_, saved_, newest_, interval_, lateness_);
  }

 private:
  static constexpr std::size_t SAVED = 32;
  static constexpr double OUT_OF_ORDER = 3.0;  // [s] by which a measurement may be later than the latency
  static constexpr double SAME = 1e-9;         // [s]

  // What a measurement changes.
  struct Live
  {
    VehicleFilter filter;
    FixJudge judge;
    double refit_at = 0.0;
    double overstretch = 0.0;  // by which the measured ends are too far apart, over its standard deviation, mean

    template <class Archive>
    void archive(Archive& a)
    {
      a(filter, judge, refit_at, overstretch);
    }
  };
  struct Step
  {
    double from = 0.0, to = 0.0;
    core::EndPaths paths;
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
    bool has_attitude = false;
    double error_rate = 1.0;
    core::Vector3 vessel_stddev = core::Vector3::Zero();

    template <class Archive>
    void archive(Archive& a)
    {
      a(from, to, paths, attitude, has_attitude, error_rate, vessel_stddev);
    }
  };
  struct Saved
  {
    core::CableState state;
    core::PayoutMotion payout;
    Live live;

    template <class Archive>
    void archive(Archive& a)
    {
      a(state, payout, live);
    }
  };

  core::SolveReport make(const Step& step, core::CableModel& model, core::Stepper& stepper,
                         core::CableState& state);
  core::SolveReport again(double from, core::CableModel& model, core::Stepper& stepper, core::CableState& state);
  void save(const core::CableModel& model, const core::CableState& state);
  void look(const VehicleFix& fix, const core::EndPath& nominal, const Step& step, const core::CableModel& model,
            const core::CableState& state);
  static std::size_t stepsFor(const Config& config);
  double freshFrom(double t) const;
  core::EndPoint centre(const core::CableState& state) const;

  NavigationConfig navigation_;
  core::RigidBody body_;
  double invalid_timeout_;  // [s]
  FixLog log_;
  core::EndImpedanceSolver solver_;
  Live live_;
  std::optional<Eigen::Quaterniond> attitude_;
  core::Vector3 origin_ = core::Vector3::Zero();
  double begun_at_;
  double start_scale_ = 1.0;   // of the usual disturbance
  double first_stddev_ = 0.0;  // of firstPosition() [m]
  core::Vector3 start_force_ = core::Vector3::Zero();
  core::Matrix3 start_place_ = core::Matrix3::Identity();  // covariance
  core::Matrix3 start_doubt_ = core::Matrix3::Zero();      // covariance of the force
  long repeated_ = 0;
  Ring<Step> steps_;
  Ring<Saved> saved_;
  double newest_, interval_ = 0.0;  // position in the log: time, usual interval
  double lateness_;                 // usual [s]
};

}  // namespace tether_monitor::monitor
