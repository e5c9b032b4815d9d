#pragma once

#include "tether_monitor/monitor/estimator/vessel_end.h"
#include "tether_monitor/monitor/vessel/vessel_motion_filter.h"

namespace tether_monitor::monitor
{
/// The vessel's end on what VesselMotionFilter makes of noisy measurements, which may come late and out of order.
class FilteredVesselEnd final : public VesselEnd
{
 public:
  explicit FilteredVesselEnd(const Config& config) : body_(config.vessel) {}
  std::unique_ptr<VesselEnd> clone() const override { return std::make_unique<FilteredVesselEnd>(*this); }

  Rejection add(const PoseMeasurement* pose, const TwistMeasurement* twist) override;
  void setInitialMotion(double t, const BodyState& vessel) override;
  void clear() override;
  bool isReady(double t) const override { return filter_.isReady(t); }
  double age(double t) const override { return filter_.age(t); }
  void aim(double t, EndTargets& targets) override;
  /// A steady state has no waves: it begins on the vessel's track and fades into its motion.
  void aimAtStart(double t, EndTargets& targets) override;
  std::optional<BodyState> bodyAt(double t) const override;
  core::Vector3 positionStddev(double t) const override
  {
    return filter_.hasPosition() ? filter_.at(t).position_stddev : core::Vector3(core::Vector3::Zero());
  }
  const MotionBuffer& track() const override { return track_; }
  const MotionPlausibility* plausibility() const override { return &plausibility_; }
  long outliers() const override { return filter_.outliers(); }
  const VesselMotionFilter& filter() const { return filter_; }
  bool isValid() const override
  {
    return track_.isValid() && whole_.isValid() && filter_.isValid() && plausibility_.isValid();
  }
  void write(core::BinaryWriter& archive) const override { archive(track_, whole_, filter_, plausibility_); }
  void read(core::BinaryReader& archive) override { archive(track_, whole_, filter_, plausibility_); }

 private:
  MeasuredVector attachmentPosition(const PoseMeasurement& pose) const;
  MeasuredVector attachmentVelocity(const TwistMeasurement& twist, const Eigen::Quaterniond& orientation) const;
  Eigen::Quaterniond orientationOf(const PoseMeasurement* pose) const;
  Rejection check(const PoseMeasurement* pose, const TwistMeasurement* twist) const;

  BodyConfig body_;
  MotionBuffer track_;
  MotionBuffer whole_;  // positions of which all axes were measured
  VesselMotionFilter filter_;
  MotionPlausibility plausibility_;  // leaps are the filter's
};

}  // namespace tether_monitor::monitor
