#pragma once

#include <string>

#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/replay/csv_replay.h"
#include "tether_monitor/replay/result_recorder.h"

namespace tether_monitor
{
/**
 * Runs an estimator over the inputs in a bag, as the node would see them, by header stamps. Each tick knows the
 * measurements up to its time and the next one after it, so motion is interpolated.
 *
 * @param path       a bag; transforms on /tf and /tf_static are used.
 * @param ns         namespace of the topics, "" for vessel/pose at the root.
 * @param options    rate 0 means 20 Hz.
 * @return           warnings for the user: topics on which messages were refused, with count and last reason.
 * @throws std::runtime_error naming the bag: unreadable, truncated, without our topics, or all messages refused.
 */
std::vector<std::string> replayBag(const std::string& path, const std::string& ns,
                                   const replay::ReplayOptions& options, monitor::TetherEstimator& estimator,
                                   replay::ResultRecorder& recorder);

}  // namespace tether_monitor
