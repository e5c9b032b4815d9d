#include "tether_monitor/ros/input_topics.h"

#include <ros/message_traits.h>

#include <algorithm>

namespace tether_monitor
{
namespace
{
constexpr int BODY_QUEUE = 100, OTHER_QUEUE = 5;  // messages that wait

template <typename Message>
using Accept = std::function<std::optional<InputError>(InputAdapter&, const Message&, const ros::Time&)>;

template <typename Message>
std::optional<ros::Time> stampOf(const Message& message)
{
  const ros::Time* stamp = ros::message_traits::timeStamp(message);
  return stamp ? std::optional<ros::Time>(*stamp) : std::nullopt;
}

template <typename Message>
InputMessage wrapped(const boost::shared_ptr<const Message>& message, const std::string& publisher,
                     const Accept<Message>& accept)
{
  return {stampOf(*message), publisher, [message, accept](InputAdapter& adapter, const ros::Time& now) {
            return accept(adapter, *message, now);
          }};
}

template <typename Message>
InputTopic topic(const char* name, const char* meaning, InputStream stream, bool is_pose,
                 const Accept<Message>& accept)
{
  InputTopic entry;
  entry.name = name;
  entry.type = ros::message_traits::datatype<Message>();
  entry.meaning = meaning;
  entry.stream = stream;
  entry.is_pose = is_pose;
  const std::string topic_name = name;
  // What is large and rare must not pile up.
  const int queue = stream == InputStream::OTHER ? OTHER_QUEUE : BODY_QUEUE;
  entry.subscribe = [topic_name, queue, accept](ros::NodeHandle& nh, const InputTopic::Callback& callback)
  {
    using Event = ros::MessageEvent<const Message>;
    const boost::function<void(const Event&)> receive = [accept, callback](const Event& event)
    { callback(wrapped(event.getConstMessage(), event.getPublisherName(), accept)); };
    ros::SubscribeOptions options;
    options.template initByFullCallbackType<const Event&>(topic_name, queue, receive);
    options.transport_hints = ros::TransportHints().tcpNoDelay();
    return nh.subscribe(options);
  };
  entry.read = [accept](const rosbag::MessageInstance& instance) -> std::optional<InputMessage>
  {
    const boost::shared_ptr<const Message> message = instance.instantiate<Message>();
    return message ? std::optional<InputMessage>(wrapped(message, instance.getCallerId(), accept)) : std::nullopt;
  };
  return entry;
}

template <typename Message>
InputTopic bodyTopic(const char* name, const char* meaning, Body body, bool is_pose)
{
  const InputStream stream = body == Body::VESSEL ? InputStream::VESSEL : InputStream::VEHICLE;
  return topic<Message>(name, meaning, stream, is_pose,
                        [body](InputAdapter& adapter, const Message& message, const ros::Time& now)
                        { return adapter.accept(body, message, now); });
}

template <typename Message>
InputTopic otherTopic(const char* name, const char* meaning)
{
  return topic<Message>(name, meaning, InputStream::OTHER, false,
                        [](InputAdapter& adapter, const Message& message, const ros::Time& now)
                        { return adapter.accept(message, now); });
}
}  // namespace

const std::vector<InputTopic>& inputTopics()
{
  static const std::vector<InputTopic> topics{
      bodyTopic<geometry_msgs::PoseStamped>("vessel/pose", "where the vessel is", Body::VESSEL, true),
      bodyTopic<geometry_msgs::PoseStamped>("vehicle/pose", "where the vehicle is", Body::VEHICLE, true),
      bodyTopic<geometry_msgs::TwistStamped>("vessel/velocity", "velocity of the vessel", Body::VESSEL, false),
      bodyTopic<geometry_msgs::TwistStamped>("vehicle/velocity", "velocity of the vehicle", Body::VEHICLE, false),
      bodyTopic<nav_msgs::Odometry>("vessel/odom", "pose and velocity of the vessel", Body::VESSEL, true),
      bodyTopic<nav_msgs::Odometry>("vehicle/odom", "pose and velocity of the vehicle", Body::VEHICLE, true),
      otherTopic<Payout>("payout", "deployed length and its rate"),
      topic<std_msgs::Float64>("turns", "turns that the winch has paid out", InputStream::OTHER, false,
                               &InputAdapter::acceptTurns),
      topic<std_msgs::Float64>("vehicle/turns", "turns of the tether about itself", InputStream::OTHER, false,
                               &InputAdapter::acceptTetherTurns),
      otherTopic<nav_msgs::Path>("plan", "where the vessel is meant to go"),
      topic<Payout>("payout/plan", "what the winch is meant to do", InputStream::OTHER, false,
                    &InputAdapter::acceptPayoutPlan),
      otherTopic<TensionMeasurement>("tension", "load cell at the vessel end"),
      otherTopic<geometry_msgs::Vector3Stamped>("vessel_end/direction",
                                                "direction in which the tether leaves the vessel"),
      otherTopic<CurrentProfile>("current", "current by depth"),
      otherTopic<ObstacleArray>("obstacles", "what the tether may touch"),
      topic<std_msgs::Float64>("seabed", "depth of the sea", InputStream::OTHER, false,
                               &InputAdapter::acceptDepth),
      otherTopic<geometry_msgs::WrenchStamped>("vehicle/thrust", "thrust of a simulated vehicle"),
  };
  return topics;
}

const InputTopic* findInputTopic(const std::string& name)
{
  const auto found = std::find_if(inputTopics().begin(), inputTopics().end(),
                                  [&](const InputTopic& topic) { return topic.name == name; });
  return found == inputTopics().end() ? nullptr : &*found;
}

}  // namespace tether_monitor
