#pragma once

#include <limits>

#include "tether_monitor/monitor/ensemble/ensemble_members.h"
#include "tether_monitor/monitor/ensemble/innovation_gate.h"
#include "tether_monitor/monitor/ensemble/load_cell_record.h"
#include "tether_monitor/monitor/ensemble/motion_error_filter.h"
#include "tether_monitor/monitor/ensemble/random_numbers.h"
#include "tether_monitor/monitor/ensemble/reading_statistics.h"
#include "tether_monitor/monitor/measurements/measurement_history.h"
#include "tether_monitor/monitor/measurements/ring_buffer.h"
#include "tether_monitor/monitor/measurements/tension_residual.h"

namespace tether_monitor::monitor
{
/**
 * What the measurements tell of an ensemble: of every member's vehicle, MotionErrorFilter, and from the
 * innovations of all of them of the parameters, EnsembleTransform: Friedland's two-stage filter (1969), (E1)-(E7)
 * of doc/theory/estimation.md.
 *
 * A measurement counts at its own time. How the members moved is remembered; one that comes late is compared with
 * that, and the motion filters go on from there again, which costs no step of any tether. What it tells of the
 * parameters is told by what the members would have predicted, had they known what was learnt since then.
 */
class EnsembleFilter
{
 public:
  explicit EnsembleFilter(const Config& config);

  void begin(const EnsembleStart& start, const core::Matrix3& position_covariance,
             const TetherLinearization& tether, const MemberMotion& motion, double t, double measured_at);
  void setTether(const TetherLinearization& tether) { motion_.setTether(tether); }

  /// What was learnt of parameters that are configured otherwise now is forgotten: their mean is what is
  /// configured, their spread the prior's. Unknown forces get the variance that they are told more.
  void forgetWhatIsToldAnew(const Config& before, const Config& now);

  /// What is uncertain of the vessel's end of the tether.
  struct VesselNoise
  {
    core::Vector3 stddev = core::Vector3::Zero();  ///< of its position [m].
    double tension = 0.0;                          ///< what that makes of a tension there [N].
  };
  /**
   * The members have moved to time t [s].
   *
   * @param history  measurements; those that have not been seen are processed, and marked so.
   * @param origin   of the members' coordinates in the world [m].
   */
  void update(double t, const MemberMotion& moved, const VesselNoise& noise, const core::Vector3& origin,
              MeasurementHistory& history);

  /// Parameters of the members.
  const ParameterMatrix& parameters() const { return parameters_; }
  const ParameterPrior& prior() const { return prior_; }
  const MotionErrorFilter& motionError() const { return motion_; }
  const InnovationGate& gate() const { return gate_; }
  /// Of the last reading of the load cell, before it corrected anything.
  const TensionResidual& tensionResidual() const { return tension_residual_; }
  const LoadCellRecord& loadCell() const { return load_cell_; }
  /// Force that every nominal vehicle is to feel from now on: what is unknown, and what brings it to its mean [N].
  const MemberVectors& appliedForce() const { return applied_; }
  /// Times that the parameters were drawn anew since the measurements contradicted them.
  long resets() const { return resets_; }
  /// Time of the oldest measurement that can still count [s].
  double earliestTime() const
  {
    return ticks_.empty() ? -std::numeric_limits<double>::infinity() : ticks_.front().t;
  }
  /// Time of the last update [s]; NaN before the first.
  double latestTime() const { return ticks_.empty() ? std::numeric_limits<double>::quiet_NaN() : ticks_.back().t; }
  const UnknownForce& unknownForce() const { return unknown_force_; }
  bool isValid() const;
  void prepare() { ticks_.clear(); }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(parameters_, motion_, gate_, transferred_, applied_, ticks_, transforms_, next_transform_, first_transform_,
      random_, walked_at_, began_at_, resets_, position_rate_, tension_rate_, direction_rate_, tension_spread_,
      tension_residual_, load_cell_);
  }

 private:
  struct Tick
  {
    double t = 0.0;
    MemberMotion motion;
    MemberVectors applied;
    VesselNoise noise;
    MotionErrorFilter::Belief belief;

    template <class Archive>
    void serialize(Archive& a)
    {
      a(t, motion, applied, noise.stddev, noise.tension, belief);
    }
  };
  struct Transform
  {
    EnsembleTransform transform;
    double t = 0.0, learnt_at = 0.0;  // of the measurement, and when it came [s]
    bool accepted = false;

    template <class Archive>
    void serialize(Archive& a)
    {
      a(transform, t, learnt_at, accepted);
    }
  };
  // One measurement as the members see it.
  struct Sight
  {
    MotionErrorFilter::Jacobian jacobian;
    MemberVectors predicted, innovations, hindcast;
    Eigen::RowVectorXd nominal_tension;  // of a reading of the load cell
    core::Matrix3 noise;
  };

  static std::size_t ticksFor(const Config& config);
  void process(VehicleMeasurement& fix, std::size_t tick, const core::Vector3& origin);
  bool look(const VehicleMeasurement& fix, std::size_t tick, const core::Vector3& origin);
  bool isAccepted(const VehicleMeasurement& fix, const core::Vector3& innovation);
  void believe(const VehicleMeasurement& reading);
  void hindcast(double t);
  void learn(const VehicleMeasurement& fix, double moved_at, EnsembleTransform& transform);
  ReadingRate& rateOf(VehicleMeasurement::Kind kind);
  double startError(double t) const;
  void reset();
  void walk(double t);
  void feedBack(double dt);

  int count_;
  ParameterPrior prior_;
  UnknownForce unknown_force_;
  double sensor_stddev_;  // of the load cell, relative
  double direction_stddev_, pull_limit_;
  ParameterMatrix parameters_;
  MotionErrorFilter motion_;
  InnovationGate gate_;
  MemberVectors transferred_;  // of the unknown force, to the nominal vehicles
  MemberVectors applied_;
  RingBuffer<Tick> ticks_;
  std::vector<Transform> transforms_;
  long next_transform_ = 0, first_transform_ = 0;  // since the parameters were drawn
  RandomNumbers random_;
  Sight sight_;
  Eigen::MatrixXd sample_;
  LoadCellRecord load_cell_;
  double spacing_;  // [s] of ticks
  double walked_at_ = 0.0, began_at_ = 0.0;
  long resets_ = 0;
  ReadingRate position_rate_, tension_rate_, direction_rate_;
  TensionSpread tension_spread_;
  TensionResidual tension_residual_;
};

}  // namespace tether_monitor::monitor
