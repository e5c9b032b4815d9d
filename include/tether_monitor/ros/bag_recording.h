#pragma once

#include <tf2/buffer_core.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "tether_monitor/ros/diagnostics.h"
#include "tether_monitor/ros/input_topics.h"
#include "tether_monitor/ros/transform_pose_reader.h"

namespace tether_monitor
{
/// One input message of a bag, ready to be given to the estimator.
struct BagInput
{
  ros::Time stamp;
  ros::Time recorded;
  const InputSource* source;
  InputMessage message;

  ros::Time arrival() const { return std::max(stamp, recorded); }
};

/// Inputs of one kind, in order of their stamps.
struct BagStream
{
  std::vector<BagInput> inputs;
  std::size_t next = 0;

  bool hasNext() const { return next < inputs.size(); }
};

/// Each body has its own stream: looking ahead on one takes nothing of another.
constexpr std::array<InputStream, 3> ALL_STREAMS{InputStream::VESSEL, InputStream::VEHICLE, InputStream::OTHER};

/// Streams without which there is no estimate.
std::vector<InputStream> bodiesNeeded(bool needs_vehicle);

/// The inputs in a bag.
struct BagRecording
{
  explicit BagRecording(const monitor::Config& config);
  BagRecording(const BagRecording&) = delete;

  /// @param ns  namespace of the topics, "" for vessel/pose at the root.
  /// @throws std::runtime_error naming the bag: unreadable, truncated, without poses.
  void read(const std::string& path, const std::string& ns, bool needs_vehicle);
  void refuse(const std::string& topic, const InputError& why);
  /// Topics that are told and missing; those on which messages were refused, with count and last reason.
  std::vector<std::string> warnings() const;

  BagStream& at(InputStream stream) { return streams[static_cast<std::size_t>(stream)]; }
  const BagStream& at(InputStream stream) const { return streams[static_cast<std::size_t>(stream)]; }

  std::vector<InputSource> sources;
  std::array<BagStream, ALL_STREAMS.size()> streams;
  tf2::BufferCore transforms{ros::Duration(1e9)};
  TransformPoseReader transform_poses;
  InputSource vessel_frame, vehicle_frame;  ///< whose messages are transforms.
  std::map<std::string, RefusalCount> refusals;
  std::vector<std::string> missing;  ///< warnings.
};

}  // namespace tether_monitor
