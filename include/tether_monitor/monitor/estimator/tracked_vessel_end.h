#pragma once

#include "tether_monitor/monitor/estimator/tracked_body.h"
#include "tether_monitor/monitor/estimator/vessel_end.h"

namespace tether_monitor::monitor
{
/// The vessel's end on the measured motion, as it is.
class TrackedVesselEnd final : public VesselEnd
{
 public:
  explicit TrackedVesselEnd(const Config& config) : body_(config.vessel, config.pose_timeout) {}
  std::unique_ptr<VesselEnd> clone() const override { return std::make_unique<TrackedVesselEnd>(*this); }

  Rejection add(const PoseMeasurement* pose, const TwistMeasurement* twist) override
  {
    return body_.add(pose, twist);
  }
  void clear() override { body_.clear(); }
  bool isReady(double /*t*/) const override { return track().hasPose(); }
  double age(double t) const override { return track().age(t); }
  void aim(double t, EndTargets& targets) override;
  void aimAtStart(double t, EndTargets& targets) override { aim(t, targets); }
  std::optional<BodyState> bodyAt(double t) const override
  {
    return track().hasPose() ? std::optional<BodyState>(track().at(t)) : std::nullopt;
  }
  const MotionBuffer& track() const override { return body_.track(); }
  const MotionPlausibility* plausibility() const override { return &body_.plausibility(); }
  bool takeLeap() override { return body_.takeLeap(); }
  bool isValid() const override { return body_.isValid(); }
  void write(core::BinaryWriter& archive) const override { archive(body_); }
  void read(core::BinaryReader& archive) override { archive(body_); }

 private:
  TrackedBody body_;
};

}  // namespace tether_monitor::monitor
