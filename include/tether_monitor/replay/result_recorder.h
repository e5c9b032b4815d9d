#pragma once

#include <array>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/files/folder_lock.h"
#include "tether_monitor/replay/forecast_recorder.h"
#include "tether_monitor/replay/input_log.h"
#include "tether_monitor/replay/result_files.h"

namespace tether_monitor::replay
{
/// Writes the files of a replay and sums it up. Nothing is touched before the first estimate: a recording that
/// cannot be read leaves the results of another as they are.
class ResultRecorder
{
 public:
  /**
   * @param folder      made if needed.
   * @param shape_rate  [Hz] of shape.csv; 0: none.
   * @param vehicle     columns of ends.csv about it.
   * @throws std::runtime_error naming what cannot be written.
   */
  ResultRecorder(const std::string& folder, double shape_rate, VehicleColumns vehicle = VehicleColumns::NONE);

  /// Makes forecasts from now on, and scores them.
  void addForecasts(const monitor::Config& config);

  /// Time of t = 0 on the clock of the recording, for summary.json [s since 1970].
  void setEpoch(double epoch) { epoch_ = epoch; }

  /// Starts and stops the clock around one call of the estimator.
  void startTimer();
  void stopTimer();
  /// Looks at an estimate between output times: extremes and alarms.
  void accumulate(const monitor::TetherEstimator& estimator);
  /// Writes an estimate at an output time; observe() it first.
  void writeRow(const monitor::TetherEstimator& estimator);
  /// What came, for inputs.csv.
  InputLog& inputs() { return inputs_; }
  /// Writes summary.json and closes all files. @param interrupted  the run was ended before its time.
  void finish(const monitor::TetherEstimator& estimator, bool interrupted = false);
  /// Names of the files that finish() leaves.
  std::vector<std::string> files() const;
  /// How often each status was, and each reason: "OK 98.8 %, INVALID 1.2 % (SETTLING 1.1 %, NO_INPUT 0.1 %)".
  std::string statusText() const;
  double shareOf(monitor::Status status) const;  ///< of the rows; 0 without any.

 private:
  void open();

  std::string folder_;
  files::FolderLock lock_;
  double shape_rate_;
  VehicleColumns vehicle_;
  std::optional<monitor::Config> forecast_config_;
  std::unique_ptr<EndsFile> ends_;  // none before open()
  std::unique_ptr<AlarmsFile> alarms_;
  std::unique_ptr<ShapeFile> shape_;
  std::unique_ptr<ParametersFile> parameters_;
  std::unique_ptr<ForecastRecorder> forecasts_;
  InputLog inputs_;
  std::optional<double> epoch_;
  double next_parameters_ = -std::numeric_limits<double>::infinity();
  std::unique_ptr<ContactsFile> contacts_;  // from the first estimate with obstacles on
  double next_shape_ = -std::numeric_limits<double>::infinity();
  double first_time_ = std::numeric_limits<double>::quiet_NaN();
  double last_time_ = 0.0;
  double step_began_ = 0.0;
  double cpu_seconds_ = 0.0;
  double worst_step_ = 0.0;
  double max_tension_ = std::numeric_limits<double>::quiet_NaN();
  double max_tension_t_ = max_tension_;
  double max_tension_s_ = max_tension_;
  std::array<long, 4> status_count_{};
  std::map<std::string, long> reason_count_;
};

}  // namespace tether_monitor::replay
