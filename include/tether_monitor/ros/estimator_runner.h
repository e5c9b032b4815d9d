#pragma once

#include <tf2/buffer_core.h>
#include <visualization_msgs/MarkerArray.h>

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/ros/cycle_output.h"
#include "tether_monitor/ros/cycle_statistics.h"
#include "tether_monitor/ros/diagnostics.h"
#include "tether_monitor/ros/input_adapter.h"
#include "tether_monitor/ros/input_queue.h"
#include "tether_monitor/ros/priority_mutex.h"
#include "tether_monitor/ros/state_keeper.h"
#include "tether_monitor/ros/transform_pose_reader.h"

namespace tether_monitor
{
/**
 * The estimator of the node with what it is fed from: messages go into a queue, a cycle takes them, steps, and
 * leaves an output. receive() is for the thread of the callbacks, cycle() for that of the cycles; access() for
 * any.
 */
class EstimatorRunner
{
 public:
  explicit EstimatorRunner(const monitor::Config& config);

  /// The state of a node that was before this one: goes on from it at the first cycle, if it is not too old, else
  /// keeps its alarms alone. Before the first cycle.
  void adopt(KeptState state) { kept_ = std::move(state); }

  void receive(const ReceivedMessage& message) { queue_.push(message); }
  /// @param lateness  of this cycle [s]. @return false if there is nothing to publish: time has not gone on.
  bool cycle(const ros::Time& now, double lateness, CycleOutput& output);

  /// Calls use(estimator, diagnostic inputs) while no cycle is under way.
  template <typename Use>
  auto access(const Use& use)
  {
    const std::lock_guard<PriorityMutex> lock(mutex_);
    return use(estimator_, diagnostics_);
  }
  /// What is seen of the estimate of the moment.
  visualization_msgs::MarkerArray picture(const std_msgs::Header& header);
  /// Nothing that is not a state to keep yet. Allocates.
  std::optional<KeptState> keep();
  /// Of the estimator; to be read while nobody calls reconfigure().
  const monitor::Config& config() const { return estimator_.config(); }
  TimeOrigin timeOrigin();
  /// How punctual the cycles are, copied.
  CycleStatistics statistics();

 private:
  template <typename Work>
  bool guarded(const std::string& what, const Work& work);
  void takeMessages(const ros::Time& now);
  void takeMessage(const ReceivedMessage& received);
  void accept(const std::string& topic, const InputMessage& message, const ros::Time& now);
  void acceptEarly(const ros::Time& now);
  bool noteStatistics(const ReceivedMessage& received);
  void noteRefusal(const std::string& topic, const InputError& why);
  void ensureTimeBase(const ros::Time& now);
  bool restore(const ros::Time& now);
  void step(const ros::Time& now);
  void noteCycle(const ros::Time& now, double lateness);
  void describe(const ros::Time& now, double step_time, CycleOutput& output);

  PriorityMutex mutex_;  // guards all below but the queue
  monitor::TetherEstimator estimator_;
  tf2::BufferCore transforms_;
  InputAdapter adapter_;
  TransformPoseReader transform_poses_;
  InputQueue queue_;
  DiagnosticInputs diagnostics_;
  CycleStatistics statistics_;
  TimeOrigin time_;
  std::optional<KeptState> kept_;
  bool has_time_base_ = false, had_contact_ = false;
  ros::Time last_cycle_, last_alarms_, last_parameters_;
  ros::WallTime newest_received_;
  long last_event_ = 0;

  struct EarlyMessage
  {
    std::string topic;
    InputMessage message;
  };
  std::vector<EarlyMessage> early_;  // stamped ahead of the clock; in mode observed they wait for their time
};

}  // namespace tether_monitor
