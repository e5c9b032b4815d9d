#include "tether_monitor/ros/input_topics.h"

#include <ros/message_traits.h>

#include <algorithm>
#include <stdexcept>

namespace tether_monitor
{
namespace
{
using Result = std::optional<InputError>;

template <typename Message>
using Accept =
    std::function<Result(InputAdapter&, const Message&, const ros::Time&, const monitor::SourceConfig&)>;

template <typename Message>
std::optional<ros::Time> stampOf(const Message& message)
{
  const ros::Time* stamp = ros::message_traits::timeStamp(message);
  return stamp ? std::optional<ros::Time>(*stamp) : std::nullopt;
}

template <typename Message>
InputType type(const Accept<Message>& accept)
{
  InputType entry;
  entry.name = ros::message_traits::datatype<Message>();
  entry.read = [accept](const topic_tools::ShapeShifter& shape, const InputSource& source)
  {
    const boost::shared_ptr<const Message> message = shape.instantiate<Message>();
    return InputMessage{stampOf(*message), "",
                        [message, accept, config = source.config](InputAdapter& adapter, const ros::Time& now)
                        { return accept(adapter, *message, now, config); }};
  };
  return entry;
}

// What InputAdapter has an accept() for.
template <typename Message>
InputType type()
{
  return type<Message>([](InputAdapter& adapter, const Message& message, const ros::Time& now,
                          const monitor::SourceConfig&) { return adapter.accept(message, now); });
}

template <typename Message>
InputType type(Result (InputAdapter::*accept)(const Message&, const ros::Time&))
{
  return type<Message>(
      [accept](InputAdapter& adapter, const Message& message, const ros::Time& now,
               const monitor::SourceConfig& source)
      {
        Message scaled = message;
        if constexpr (std::is_same_v<Message, std_msgs::Float64>)
          scaled.data *= source.scale;
        return (adapter.*accept)(scaled, now);
      });
}

template <typename... Messages>
InputTopic bodyTopic(const char* name, const char* meaning, Body body, bool is_pose)
{
  InputTopic topic;
  topic.name = name;
  topic.meaning = meaning;
  topic.stream = body == Body::VESSEL ? InputStream::VESSEL : InputStream::VEHICLE;
  topic.is_pose = is_pose;
  topic.types = {type<Messages>([body](InputAdapter& adapter, const Messages& message, const ros::Time& now,
                                       const monitor::SourceConfig& source)
                                { return adapter.accept(body, message, now, source); })...};
  return topic;
}

InputTopic otherTopic(const char* name, const char* meaning, std::vector<InputType> types)
{
  InputTopic topic;
  topic.name = name;
  topic.meaning = meaning;
  topic.types = std::move(types);
  return topic;
}

std::string withoutNumber(const std::string& name)
{
  const std::size_t last = name.find_last_not_of("23456789");
  const bool has_number = last != std::string::npos && last + 2 == name.size();
  return has_number ? name.substr(0, last + 1) : name;
}
}  // namespace

const std::vector<InputTopic>& inputTopics()
{
  using namespace geometry_msgs;
  using namespace sensor_msgs;
  using std_msgs::Float64;
  static const std::vector<InputTopic> topics{
      bodyTopic<PoseStamped, PoseWithCovarianceStamped, PointStamped>("vessel/pose", "where the vessel is",
                                                                      Body::VESSEL, true),
      bodyTopic<PoseStamped, PoseWithCovarianceStamped, PointStamped>("vehicle/pose", "where the vehicle is",
                                                                      Body::VEHICLE, true),
      bodyTopic<TwistStamped, TwistWithCovarianceStamped>("vessel/velocity", "velocity of the vessel",
                                                          Body::VESSEL, false),
      bodyTopic<TwistStamped, TwistWithCovarianceStamped>("vehicle/velocity", "velocity of the vehicle",
                                                          Body::VEHICLE, false),
      bodyTopic<nav_msgs::Odometry>("vessel/odom", "pose and velocity of the vessel", Body::VESSEL, true),
      bodyTopic<nav_msgs::Odometry>("vehicle/odom", "pose and velocity of the vehicle", Body::VEHICLE, true),
      bodyTopic<NavSatFix>("vessel/fix", "where a satellite antenna on the vessel is", Body::VESSEL, true),
      bodyTopic<NavSatFix>("vehicle/fix", "where the vehicle is, on the globe", Body::VEHICLE, true),
      bodyTopic<Imu>("vessel/imu", "attitude of the vessel", Body::VESSEL, false),
      bodyTopic<Imu>("vehicle/imu", "attitude of the vehicle", Body::VEHICLE, false),
      bodyTopic<Float64, FluidPressure>("vehicle/depth", "depth of the vehicle", Body::VEHICLE, false),
      bodyTopic<AcousticFix>("vehicle/acoustic", "where a transducer hears the vehicle", Body::VEHICLE, true),
      otherTopic("payout", "deployed length and its rate",
                 {type<Payout>(), type(&InputAdapter::acceptLength), type<JointState>()}),
      otherTopic("turns", "turns that the winch has paid out", {type(&InputAdapter::acceptTurns)}),
      otherTopic("vehicle/turns", "turns of the tether about itself", {type(&InputAdapter::acceptTetherTurns)}),
      otherTopic("plan", "where the vessel is meant to go", {type<nav_msgs::Path>()}),
      otherTopic("payout/plan", "what the winch is meant to do", {type(&InputAdapter::acceptPayoutPlan)}),
      otherTopic("tension", "load cell at the vessel end",
                 {type<TensionMeasurement>(), type(&InputAdapter::acceptTension)}),
      otherTopic("vessel_end/direction", "direction in which the tether leaves the vessel",
                 {type<Vector3Stamped>()}),
      otherTopic("current", "current by depth", {type<CurrentProfile>()}),
      otherTopic("obstacles", "what the tether may touch", {type<ObstacleArray>()}),
      otherTopic("seabed", "depth of the sea", {type(&InputAdapter::acceptDepth)}),
      otherTopic("vehicle/thrust", "thrust of a simulated vehicle", {type<WrenchStamped>()}),
  };
  return topics;
}

std::string InputTopic::typeNames() const
{
  std::string text;
  for (std::size_t i = 0; i < types.size(); ++i)
    text += (i == 0 ? "" : i + 1 == types.size() ? " or " : ", ") + types[i].name;
  return text;
}

const InputTopic* findInputTopic(const std::string& name)
{
  const auto isNamed = [](const std::string& wanted)
  { return [&wanted](const InputTopic& topic) { return topic.name == wanted; }; };
  auto found = std::find_if(inputTopics().begin(), inputTopics().end(), isNamed(name));
  if (found == inputTopics().end())
    found = std::find_if(inputTopics().begin(), inputTopics().end(), isNamed(withoutNumber(name)));
  return found == inputTopics().end() ? nullptr : &*found;
}

Result InputSource::read(const topic_tools::ShapeShifter& message, const std::string& publisher,
                         InputMessage& out) const
{
  const auto known = std::find_if(topic->types.begin(), topic->types.end(),
                                  [&](const InputType& type) { return type.name == message.getDataType(); });
  if (known == topic->types.end())
    return "its type is " + message.getDataType() + ", not " + topic->typeNames();
  try
  {
    out = known->read(message, *this);
  }
  catch (const std::exception& error)
  {
    return message.getDataType() + " cannot be read: " + error.what();
  }
  out.publisher = publisher;
  return std::nullopt;
}

namespace
{
std::string inputNames()
{
  std::string names;
  for (const InputTopic& topic : inputTopics())
    names += (names.empty() ? "" : ", ") + std::string(topic.name);
  return names;
}
}  // namespace

std::vector<InputSource> inputSources(const monitor::InputsConfig& config)
{
  std::vector<InputSource> sources;
  for (const InputTopic& topic : inputTopics())
    sources.push_back({&topic, config.source(topic.name)});
  for (const monitor::SourceConfig& source : config.sources)
  {
    const InputTopic* topic = findInputTopic(source.topic);
    const bool is_further = topic && topic->name != source.topic;
    if (!topic || (is_further && topic->stream == InputStream::OTHER))
      throw std::invalid_argument("inputs: '" + source.topic + "' is no input; those are " + inputNames() +
                                  "; a second source is vehicle/pose2");
    if (is_further)
      sources.push_back({topic, source});
  }
  return sources;
}

}  // namespace tether_monitor
