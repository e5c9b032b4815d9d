#pragma once

#include <string>
#include <vector>

#include "tether_monitor/replay/csv_replay.h"

namespace tether_monitor::apps
{
/// What a dive was recorded in: one of the two.
struct Recording
{
  std::string bag, ns;
  std::string motion;  ///< CSV file
};

/// Where the results go.
struct Results
{
  std::string folder;
  double shape_rate = 1.0;  ///< [Hz]; 0: no shapes.
  bool forecast = false;
};

/**
 * Runs an estimator over a recording and writes the files of a replay.
 *
 * @return  warnings for the user.
 * @throws  std::runtime_error naming what cannot be read or written.
 */
std::vector<std::string> replayRecording(const Recording& recording, const replay::ReplayOptions& options,
                                         const Results& results, monitor::TetherEstimator& estimator);

/// From now on an interrupt from the keyboard, or a request to end, is only noted.
void noteInterrupts();
bool isInterrupted();
constexpr int INTERRUPTED = 130;  ///< exit code, as the shell has it.

/// Progress as a bar on stderr, if somebody looks at it. @param share  done [0, 1].
void showProgress(double share);
bool isWatched();

}  // namespace tether_monitor::apps
