#pragma once

#include "tether_monitor/monitor/measurements/measurement_history.h"

namespace tether_monitor::monitor
{
/// How the measured positions go with the model, for people.
struct InnovationStatistics
{
  long accepted = 0;         ///< positions and velocities that corrected the estimate.
  long refused = 0;          ///< that were rejected as outliers.
  long reacquired = 0;       ///< times that rejected ones were accepted after all.
  double noise_scale = 1.0;  ///< innovations over what they should be, root mean square [-].
  double normalized_innovation_mean =
      0.0;            ///< mean innovation over what chance would leave of it [-]; beyond 4 something is wrong.
  double last = 0.0;  ///< size of the last innovation [m].

  template <class Archive>
  void serialize(Archive& a)
  {
    a(accepted, refused, reacquired, noise_scale, normalized_innovation_mean, last);
  }
};

/**
 * Decides which measurements are accepted: (E14)-(E16) of doc/theory/estimation.md.
 *
 * What is too far from the prediction is refused. Where refused positions go on to agree with each other, the gate
 * was wrong and they are accepted; but if they contradict positions accepted just before, it stays in
 * question which were right. Plain data.
 */
class InnovationGate
{
 public:
  /// @param measured  time of the last position known then [s].
  void start(double t, double measured);

  enum class Verdict
  {
    ACCEPT,
    REJECT,
    REACQUIRE,  ///< accept: where the prediction was none to insist on, others agree with it.
    RESET       ///< accept: so many agree with it that the prediction must be wrong.
  };
  /**
   * @param innovation  measured less predicted.
   * @param covariance  of that. @param lasting  the part of it that is the same in many measurements.
   */
  Verdict evaluate(const VehicleMeasurement& fix, const core::Vector3& innovation, const core::Matrix3& covariance,
                   const core::Matrix3& lasting);

  /// Factor on the variance of measurements: those that scatter more than they should are worse than they say.
  double noiseVarianceScale() const;
  /// True while positions and model contradict each other.
  bool isInconsistent(double t) const;
  /// Time of the last position that was accepted, of the axis that has waited longest [s].
  double lastAccepted() const { return last_accepted_.minCoeff(); }
  const InnovationStatistics& report() const { return report_; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(last_accepted_, last_seen_, reacquisition_until_, consecutive_rejections_, last_offset_, last_position_,
      last_refused_, refused_axes_, square_, mean_, lasting_, samples_, other_refusals_, inconsistent_until_,
      report_);
  }

 private:
  Verdict evaluateOther(double square);
  Verdict reacquire(const VehicleMeasurement& fix, const core::Vector3& offset);
  void noteSeen(const VehicleMeasurement& fix);
  void updateStatistics(const VehicleMeasurement& fix, const core::Vector3& scaled, const core::Vector3& lasting,
                        double square);

  core::Vector3 last_accepted_ = core::Vector3::Zero();  // of every axis
  core::Vector3 last_seen_ = core::Vector3::Zero();      // last position of every axis, accepted or not
  double reacquisition_until_ = 0.0;                     // nothing better is known so long
  int consecutive_rejections_ = 0;                       // in a row that agree with each other
  core::Vector3 last_offset_ = core::Vector3::Zero(),
                last_position_ = core::Vector3::Zero();  // of the last rejected
  double last_refused_ = 0.0;
  core::Vector3 refused_axes_ = core::Vector3::Zero();  // 1 for those that the last rejected one measured
  double square_ = 1.0;                                 // running mean of the squared distances, over three
  core::Vector3 mean_ = core::Vector3::Zero(), lasting_ = core::Vector3::Zero();
  int samples_ = 0;
  int other_refusals_ = 0;  // of what is no position, in a row
  double inconsistent_until_ = -1e300;
  InnovationStatistics report_;
};

}  // namespace tether_monitor::monitor
