#pragma once

#include "tether_monitor/monitor/alarms/alarm_inputs.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"

namespace tether_monitor::monitor
{
/// What an alarm watches: a value, and where along the tether it is taken [m]; NaN: unknown, nowhere.
struct AlarmValue
{
  double value = TetherEstimate::NONE;
  double s = TetherEstimate::NONE;
};

/// The numbers behind alarmQuantities(), which says what they are.
AlarmValue workingUtilisation(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue breakingUtilisation(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue minTension(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue bendRadius(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue inputAge(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue tensionRate(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue seabedContact(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue touchdownDistance(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue obstacleForce(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue clearance(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue layBack(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue scope(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue turns(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue resonance(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue lockIn(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue forecast(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue mismatch(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue missedCycles(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue implausible(const TetherEstimate& estimate, const AlarmInputs& inputs);
AlarmValue solverFault(const TetherEstimate& estimate, const AlarmInputs& inputs);

}  // namespace tether_monitor::monitor
