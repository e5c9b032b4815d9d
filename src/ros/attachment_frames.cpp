#include "tether_monitor/ros/attachment_frames.h"

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <set>
#include <vector>

#include "tether_monitor/params/attachment_frames.h"
#include "tether_monitor/params/parameter_reader.h"
#include "tether_monitor/ros/bag_messages.h"
#include "tether_monitor/ros/crash_guard.h"
#include "tether_monitor/ros/sensor_mounts.h"
#include "tether_monitor/ros/transform_input.h"

namespace tether_monitor
{
namespace
{
constexpr double PATIENCE = 10.0;  // [s], wall clock

std::vector<std::string> place(params::Value& tree, const tf2::BufferCore& transforms)
{
  return params::placeAttachments(
      tree,
      [&](const std::string& frame, const std::string& body_frame) -> std::optional<core::Vector3>
      {
        monitor::BodyConfig body;
        body.frame = body_frame;
        Eigen::Isometry3d mount;
        if (SensorMounts(transforms).find(body, frame, mount))
          return std::nullopt;
        return core::Vector3(mount.translation());
      });
}
}  // namespace

params::Value withPlacedAttachments(params::Value tree, const ros::NodeHandle& nh)
{
  tf2::BufferCore transforms;
  std::vector<std::string> unknown = place(tree, transforms);
  if (unknown.empty())
    return tree;
  ros::CallbackQueue queue;
  ros::NodeHandle listener;
  listener.setCallbackQueue(&queue);
  std::vector<ros::Subscriber> subscribers;
  for (const bool is_static : {true, false})
  {
    const boost::function<void(const tf2_msgs::TFMessageConstPtr&)> receive =
        [&transforms, is_static](const tf2_msgs::TFMessageConstPtr& message)
    { addTransforms(*message, is_static, ros::Time::now(), transforms); };
    subscribers.push_back(listener.subscribe<tf2_msgs::TFMessage>(is_static ? "/tf_static" : "/tf", 100, receive));
  }
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(PATIENCE);
  while (!unknown.empty() && ros::ok() && ros::WallTime::now() < end)
  {
    queue.callAvailable(ros::WallDuration(0.1));
    unknown = place(tree, transforms);
  }
  if (!unknown.empty())
    throw params::ParameterError(nh.getNamespace(), unknown);
  return tree;
}

params::Value withPlacedAttachments(params::Value tree, const std::string& where, const std::string& bag)
{
  tf2::BufferCore transforms(ros::Duration(1e9));
  std::vector<std::string> unknown = place(tree, transforms);
  if (unknown.empty())
    return tree;
  const CrashGuard crash("the bag is damaged beyond what can be read\n");
  rosbag::Bag recording;
  openBag(bag, recording);
  std::set<std::string> frames;
  for (const bool is_static : {true, false})
  {
    const std::string topic = is_static ? "/tf_static" : "/tf";
    rosbag::View view(recording, rosbag::TopicQuery({topic, topic.substr(1)}));
    visitMessages(bag, view,
                  [&](const rosbag::MessageInstance& m)
                  {
                    const auto message = m.instantiate<tf2_msgs::TFMessage>();
                    if (!message)
                      return true;
                    addTransforms(*message, is_static, ros::Time(), transforms);
                    bool is_news = false;
                    for (const geometry_msgs::TransformStamped& transform : message->transforms)
                      is_news |= frames.insert(transform.child_frame_id).second;
                    if (is_news)
                      unknown = place(tree, transforms);
                    return !unknown.empty();
                  });
    if (unknown.empty())
      return tree;
  }
  throw params::ParameterError(where + " with " + bag, unknown);
}

}  // namespace tether_monitor
