#include "tether_monitor/monitor/estimator/load_cell_check.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double FAULT = 4.0;             // standard deviations that chance does not explain
constexpr double STALE = 2.0;             // [s] after which a reading is none of now
constexpr double STIFFNESS_PERIOD = 1.0;  // [s]
constexpr double SLOW = 0.1;              // rate of what a wrong length does [1/s]
constexpr double DRAG_SHARE = 0.7;        // relative error of a tow's tension over that of the drag
constexpr double FAST_RISE = 30.0;        // [s] within which a snag shows
constexpr int FROZEN = 20;                // readings in a row that no working cell repeats
constexpr double LIKELY_LENGTH = 4.0;     // standard deviations of the length that still explain
}  // namespace

const char* describe(MismatchCause cause)
{
  switch (cause)
  {
    case MismatchCause::NONE:
      return "load cell and model agree";
    case MismatchCause::SNAG:
      return "SNAG: the tether or the vehicle is held fast; stop the vessel, pay out";
    case MismatchCause::LENGTH:
      return "the deployed length may be wrong: compare the winch's counter";
    case MismatchCause::SENSOR:
      return "the load cell may be wrong: look at its zero and its cable; else drag or current are far off";
  }
  return "unknown";
}

LoadCellCheck::LoadCellCheck(const Config& config)
  : uncertainty_(config.uncertainty),
    working_load_(config.tether.working_load),
    nodes_(config.elements + 1),
    solver_(nodes_),
    readings_(MOST_READINGS)
{
}

void LoadCellCheck::add(double t, double tension)
{
  if (!readings_.empty() && !(t > readings_.back().t))
    return;
  readings_.emplaceBack() = {t, tension};
}

void LoadCellCheck::clear()
{
  readings_.clear();
  residual_ = TensionResidual();
  last_tension_ = last_time_ = length_stiffness_ = quiet_at_ = loud_since_ = last_reading_ = length_error_ =
      TetherEstimate::NONE;
  updated_at_ = -std::numeric_limits<double>::infinity();
  repeats_ = 0;
  cause_ = MismatchCause::NONE;
}

double LoadCellCheck::mismatch() const
{
  return std::abs(residual_.normalized());
}

// A shorter tether pulls as one whose far end has moved on along itself.
void LoadCellCheck::updateStiffness(CableSimulation& simulation)
{
  const core::CableState& state = simulation.state;
  if (state.time < updated_at_ + STIFFNESS_PERIOD && state.time >= updated_at_)
    return;
  updated_at_ = state.time;
  length_stiffness_ = TetherEstimate::NONE;
  if (simulation.model.nodes() != nodes_)
  {
    nodes_ = simulation.model.nodes();
    solver_ = core::EndDynamicStiffnessSolver(nodes_);
  }
  if (!solver_.solve(simulation.updatedCable(), state, SLOW, stiffness_))
    return;
  const core::Vector3 a = state.q.front().tail<3>().normalized(), b = state.q.back().tail<3>().normalized();
  length_stiffness_ = std::abs(a.dot(stiffness_.transfer * b));
}

void LoadCellCheck::note(const TensionResidual& residual)
{
  repeats_ = residual.measured == last_reading_ ? repeats_ + 1 : 0;
  last_reading_ = residual.measured;
  residual_ = residual;
  const double size = mismatch();
  if (size < QUIET)
    quiet_at_ = residual.t;
  if (size < FAULT)
    loud_since_ = TetherEstimate::NONE;
  else if (std::isnan(loud_since_))
    loud_since_ = residual.t;
}

void LoadCellCheck::compare(const TetherEstimate& e)
{
  const double length_part =
      std::isnan(length_stiffness_) ? 0.0 : length_stiffness_ * uncertainty_.length * e.length;
  const double band = std::isnan(e.vessel_tension_stddev) ? 0.0 : e.vessel_tension_stddev;
  while (!readings_.empty() && readings_.front().t <= e.time)
  {
    const Reading reading = readings_.front();
    readings_.popFront();
    if (!(reading.t >= last_time_))
      continue;
    TensionResidual r;
    const double share = e.time > last_time_ ? (reading.t - last_time_) / (e.time - last_time_) : 1.0;
    r.t = reading.t;
    r.measured = reading.tension;
    r.predicted = last_tension_ + share * (e.vessel_tension - last_tension_);
    const double relative = std::hypot(uncertainty_.mass_per_length, DRAG_SHARE * uncertainty_.drag_normal);
    r.stddev = std::sqrt(std::pow(uncertainty_.tension_stddev * r.measured, 2) +
                         std::pow(uncertainty_.tension_bias * working_load_, 2) +
                         std::pow(relative * r.predicted, 2) + length_part * length_part + band * band);
    note(r);
  }
}

MismatchCause LoadCellCheck::findCause(double length) const
{
  if (!(mismatch() >= FAULT))
    return MismatchCause::NONE;
  if (repeats_ >= FROZEN)
    return MismatchCause::SENSOR;
  if (cause_ != MismatchCause::NONE)
    return cause_;
  if (residual_.normalized() > 0.0 && loud_since_ - quiet_at_ < FAST_RISE)
    return MismatchCause::SNAG;
  const bool is_length = std::abs(length_error_) < LIKELY_LENGTH * uncertainty_.length * length;
  return is_length ? MismatchCause::LENGTH : MismatchCause::SENSOR;
}

void LoadCellCheck::update(const TetherEstimate& e, CableSimulation& simulation, const TensionResidual* observed)
{
  if (!e.has_stations)
  {
    last_tension_ = last_time_ = TetherEstimate::NONE;
    return;
  }
  if (observed && observed->t != residual_.t && !std::isnan(observed->t))
    note(*observed);
  if (!observed && !readings_.empty())
  {
    updateStiffness(simulation);
    compare(e);
  }
  last_tension_ = e.vessel_tension;
  last_time_ = e.time;
  if (e.time - residual_.t > STALE)
    residual_ = TensionResidual();
  length_error_ = length_stiffness_ > 0.0 ? (residual_.measured - residual_.predicted) / length_stiffness_
                                          : TetherEstimate::NONE;
  cause_ = findCause(e.length);
}

}  // namespace tether_monitor::monitor
