#pragma once

#include "tether_monitor/core/analysis/vortex_shedding.h"
#include "tether_monitor/monitor/alarms/alarm_inputs.h"
#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"
#include "tether_monitor/monitor/estimator/load_cell_check.h"
#include "tether_monitor/monitor/estimator/snag_locator.h"
#include "tether_monitor/monitor/estimator/vehicle_end.h"
#include "tether_monitor/monitor/estimator/vessel_end.h"
#include "tether_monitor/monitor/measurements/turn_counter.h"

namespace tether_monitor::monitor
{
/// What only the one who runs the estimator knows; see AlarmInputs.
struct ShellReport
{
  double forecast_probability = AlarmInputs::NONE;
  double resonance = AlarmInputs::NONE;
  double missed_cycles = AlarmInputs::NONE;
};

/// Finds, after every cycle, what alarms watch beside the estimate. update() allocates nothing.
class AlarmInputTracker
{
 public:
  explicit AlarmInputTracker(const Config& config);

  void report(const ShellReport& report) { report_ = report; }
  void addTension(double t, double tension) { load_cell_.add(t, tension); }
  bool setTurns(double turns) { return turns_.set(turns); }
  /// Forgets motion and measurements; the turns stay.
  void clear();
  const AlarmInputs& update(const TetherEstimate& estimate, CableSimulation& simulation, const VesselEnd& vessel,
                            const VehicleEnd& vehicle, const core::VortexShedding& vortex_shedding);

  bool isValid() const { return load_cell_.isValid() && locator_.isValid(); }
  const AlarmInputs& last() const { return inputs_; }
  const LoadCellCheck& loadCell() const { return load_cell_; }
  /// Where the tether is held fast, while the cause of a mismatch is a snag.
  const SnagPlace& snag() const { return snag_; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(turns_, load_cell_, locator_, snag_, last_time_, last_tension_);
  }

 private:
  void describeTension(const TetherEstimate& estimate);
  void describeGeometry(const TetherEstimate& estimate);
  void describeContact(const TetherEstimate& estimate, const CableSimulation& simulation);
  void findClearance(const TetherEstimate& estimate, const CableSimulation& simulation);
  void countTurns(const TetherEstimate& estimate, const VesselEnd& vessel, const VehicleEnd& vehicle);
  void checkLoadCell(const TetherEstimate& estimate, CableSimulation& simulation, const VehicleEnd& vehicle);

  double longest_interval_;  // between two tensions of which the rate is one [s]
  bool wants_clearance_;
  double contact_radius_;  // [m]
  ShellReport report_;
  TurnCounter turns_;
  LoadCellCheck load_cell_;
  SnagLocator locator_;
  SnagPlace snag_;
  double last_time_ = AlarmInputs::NONE, last_tension_ = AlarmInputs::NONE;
  AlarmInputs inputs_;
};

}  // namespace tether_monitor::monitor
