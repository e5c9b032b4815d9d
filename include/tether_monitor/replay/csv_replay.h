#pragma once

#include <functional>
#include <optional>
#include <string>

#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/replay/recorded_measurements.h"
#include "tether_monitor/replay/recorded_motion.h"
#include "tether_monitor/replay/result_recorder.h"

namespace tether_monitor::replay
{
/// A tether that parts.
struct Parting
{
  double t = 0.0;  ///< [s], to within a step.
  double s = 0.0;  ///< from the vessel end [m].
};

/// The tether with a node, and short elements, where it will part: little of it is lost there.
/// @throws std::invalid_argument naming what is wrong with the parting.
monitor::Config preparedToPart(monitor::Config config, const Parting& parting);

/// Options of a replay.
struct ReplayOptions
{
  std::optional<Parting> parting = std::nullopt;  ///< of a tether that preparedToPart() has made.

  double rate = 0.0;                     ///< [Hz] of ends.csv; 0: the times of the motion's rows.
  std::function<bool()> is_interrupted;  ///< asked after every output: true ends the replay; may be empty.
  std::function<void(double)> progress;  ///< called with the share done [0, 1]; may be empty.
};

/**
 * Runs an estimator over a known motion, from the steady state of its first row.
 *
 * Between two outputs the motion is followed in equal parts of at most the solver's step, so a coarse output does
 * not coarsen the motion.
 * @throws std::runtime_error if the tether is to part outside of the motion.
 */
void replayMotion(const Motion& motion, const ReplayOptions& options, monitor::TetherEstimator& estimator,
                  ResultRecorder& recorder);

/**
 * Runs an estimator of mode observed over measurements, each known from its row's time on, as they would come in
 * live.
 *
 * Starts with the first position of the vehicle; until then the estimate is INVALID (NO_INPUT).
 *
 * @param motion  of the same file: pay-out, current, thrust.
 */
void replayMeasurements(const RecordedMeasurements& measurements, const Motion& motion,
                        const ReplayOptions& options, monitor::TetherEstimator& estimator,
                        ResultRecorder& recorder);

}  // namespace tether_monitor::replay
