#pragma once

#include "tether_monitor/core/analysis/dynamic_stiffness.h"
#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"
#include "tether_monitor/monitor/measurements/ring_buffer.h"
#include "tether_monitor/monitor/measurements/tension_residual.h"
#include "tether_monitor/monitor/model/cable_simulation.h"

namespace tether_monitor::monitor
{
/// What explains that load cell and model disagree.
enum class MismatchCause
{
  NONE,    ///< they agree, or nothing is measured.
  SNAG,    ///< more than predicted, and it came fast: the tether, or the vehicle, is held fast.
  LENGTH,  ///< a deployed length that is a little off would explain it.
  SENSOR   ///< the reading stands still, or nothing else explains it.
};

/// Words for people, with what to look at.
const char* describe(MismatchCause cause);

/**
 * Compares the load cell with the tension that the model predicts: (E21) of doc/theory/estimation.md.
 *
 * In mode observed the ensemble's own prediction counts, before it is corrected, with its spread. In the other
 * modes the standard deviation is made of the cell's, of the configured uncertainties of drag and length, and of
 * the band of the tension. update() allocates nothing.
 */
class LoadCellCheck
{
 public:
  explicit LoadCellCheck(const Config& config);

  /// A reading at time t [s]; for the modes without an ensemble. The oldest of too many goes.
  void add(double t, double tension);
  void clear();
  /// After every cycle. @param observed  the last residual of an ensemble; null: there is none.
  void update(const TetherEstimate& estimate, CableSimulation& simulation, const TensionResidual* observed);

  /// The last one; its members are NaN if there was none in the last seconds.
  const TensionResidual& residual() const { return residual_; }
  /// Size of the normalized residual; NaN: nothing is measured.
  double mismatch() const;
  MismatchCause cause() const { return cause_; }
  /// By how much the deployed length would have to be wrong to explain it [m], > 0 if less is out; NaN: unknown.
  double lengthError() const { return length_error_; }
  /// False for what update() cannot have made.
  bool isValid() const { return readings_.isValid(MOST_READINGS); }
  /// True while residuals are as small as they should be.
  bool isQuiet() const { return !(mismatch() >= QUIET); }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(readings_, residual_, last_tension_, last_time_, length_stiffness_, updated_at_, quiet_at_, loud_since_,
      repeats_, last_reading_, length_error_, cause_);
  }

 private:
  static constexpr double QUIET = 2.0;  // standard deviations
  static constexpr std::size_t MOST_READINGS = 64;
  struct Reading
  {
    double t = 0.0, tension = 0.0;
    template <class Archive>
    void serialize(Archive& a)
    {
      a(t, tension);
    }
  };
  void compare(const TetherEstimate& estimate);
  void note(const TensionResidual& residual);
  void updateStiffness(CableSimulation& simulation);
  MismatchCause findCause(double length) const;

  UncertaintyConfig uncertainty_;
  double working_load_;  // [N]
  int nodes_;
  core::EndDynamicStiffnessSolver solver_;
  core::EndDynamicStiffness stiffness_;
  RingBuffer<Reading> readings_;
  TensionResidual residual_;
  double last_tension_ = TetherEstimate::NONE, last_time_ = TetherEstimate::NONE;  // predicted, of the last cycle
  double length_stiffness_ = TetherEstimate::NONE;  // tension for a shorter tether [N/m]
  double updated_at_ = -std::numeric_limits<double>::infinity();
  double quiet_at_ = TetherEstimate::NONE;    // [s] the last time that it was quiet
  double loud_since_ = TetherEstimate::NONE;  // [s] beyond FAULT
  int repeats_ = 0;                           // readings in a row that are the same to the last digit
  double last_reading_ = TetherEstimate::NONE;
  double length_error_ = TetherEstimate::NONE;
  MismatchCause cause_ = MismatchCause::NONE;
};

}  // namespace tether_monitor::monitor
