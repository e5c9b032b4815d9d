#pragma once

#include "tether_monitor/monitor/estimator/payout_follower.h"
#include "tether_monitor/monitor/estimator/vehicle_end.h"
#include "tether_monitor/monitor/estimator/vessel_end.h"
#include "tether_monitor/monitor/measurements/plausibility_record.h"

namespace tether_monitor::monitor
{
/// Gathers what is unbelievable of the inputs, and remembers when it was seen last.
class InputFindings
{
 public:
  /// What the inputs have found of themselves, as seen at time t [s].
  void collect(const VesselEnd& vessel, const VehicleEnd& vehicle, const PayoutFollower& payout, double t);
  /// Whether the ends of a tether are in the water and over it, as they should. @param estimate  with stations.
  void checkWorld(const core::EnvironmentModel& sea, const TetherEstimate& estimate);
  /// Something that was seen elsewhere, at time t [s].
  void note(Subject subject, Implausibility what, double t) { record_.note(subject, what, t); }
  void clear() { record_.clear(); }
  const PlausibilityRecord& record() const { return record_; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(record_);
  }

 private:
  void update(Subject subject, Implausibility what, double last, double t);

  PlausibilityRecord record_;
};

}  // namespace tether_monitor::monitor
