#include "tether_monitor/ros/input_topics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

namespace tether_monitor
{
std::string textOf(const std::string& file)
{
  std::ifstream in(std::string(PROJECT_DIR) + "/" + file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(InputTopics, HaveNamesOfTheirOwn)
{
  std::set<std::string> names;
  for (const InputTopic& topic : inputTopics())
  {
    EXPECT_TRUE(names.insert(topic.name).second) << topic.name;
    EXPECT_EQ(findInputTopic(topic.name), &topic);
    EXPECT_FALSE(topic.types.empty());
    EXPECT_FALSE(topic.meaning.empty());
  }
  EXPECT_EQ(findInputTopic("vessel/pos"), nullptr);
}

monitor::SourceConfig sourceOf(const std::string& topic)
{
  monitor::SourceConfig source;
  source.topic = topic;
  return source;
}

TEST(InputTopics, NumberedOnesAreFurtherSources)
{
  EXPECT_EQ(findInputTopic("vehicle/pose3"), findInputTopic("vehicle/pose"));
  EXPECT_EQ(findInputTopic("vehicle/pose1"), nullptr);
  EXPECT_EQ(findInputTopic("vehicle/pose22"), nullptr);
  monitor::InputsConfig config;
  EXPECT_EQ(inputSources(config).size(), inputTopics().size());
  config.sources = {sourceOf("vessel/fix"), sourceOf("vehicle/pose2")};
  config.sources[0].frame = "antenna";
  config.sources[1].from = "/usbl/pose";
  const std::vector<InputSource> sources = inputSources(config);
  ASSERT_EQ(sources.size(), inputTopics().size() + 1);
  EXPECT_EQ(sources.back().config.topic, "vehicle/pose2");
  EXPECT_EQ(sources.back().topic, findInputTopic("vehicle/pose"));
  EXPECT_EQ(sources.back().published(), "/usbl/pose");
  const auto fix = std::find_if(sources.begin(), sources.end(),
                                [](const InputSource& source) { return source.config.topic == "vessel/fix"; });
  EXPECT_EQ(fix->config.frame, "antenna");
  for (const char* wrong : {"vehicle/pos", "tension2", "payout2"})
  {
    config.sources = {sourceOf(wrong)};
    try
    {
      inputSources(config);
      ADD_FAILURE() << wrong;
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find("'" + std::string(wrong) + "' is no input"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find(", vehicle/depth,"), std::string::npos) << error.what();
    }
  }
}

TEST(InputTopics, ReadWhicheverTypeIsPublished)
{
  const InputSource source{findInputTopic("vehicle/depth"), monitor::SourceConfig()};
  const auto shapeOf = [](const auto& message)
  {
    topic_tools::ShapeShifter shape;
    using Message = std::decay_t<decltype(message)>;
    shape.morph(ros::message_traits::md5sum<Message>(), ros::message_traits::datatype<Message>(),
                ros::message_traits::definition<Message>(), "0");
    std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
    ros::serialization::OStream out(bytes.data(), bytes.size());
    ros::serialization::serialize(out, message);
    ros::serialization::IStream in(bytes.data(), bytes.size());
    shape.read(in);
    return shape;
  };
  InputMessage message;
  EXPECT_EQ(source.read(shapeOf(std_msgs::Float64()), "/pilot", message), std::nullopt);
  EXPECT_FALSE(message.stamp);
  sensor_msgs::FluidPressure pressure;
  pressure.header.stamp = ros::Time(7.0);
  EXPECT_EQ(source.read(shapeOf(pressure), "/pilot", message), std::nullopt);
  EXPECT_EQ(message.stamp, ros::Time(7.0));
  EXPECT_EQ(message.publisher, "/pilot");
  const auto error = source.read(shapeOf(sensor_msgs::Imu()), "/pilot", message);
  ASSERT_TRUE(error);
  EXPECT_EQ(*error, "its type is sensor_msgs/Imu, not std_msgs/Float64 or sensor_msgs/FluidPressure");
}

TEST(InputTopics, EveryBodyHasPoses)
{
  for (const InputStream body : {InputStream::VESSEL, InputStream::VEHICLE})
    EXPECT_TRUE(std::any_of(inputTopics().begin(), inputTopics().end(),
                            [&](const InputTopic& topic) { return topic.stream == body && topic.is_pose; }));
}

TEST(InputTopics, StandInTheDocumentsWithTheirTypes)
{
  const std::string documents = textOf("doc/interfaces.md");
  for (const InputTopic& topic : inputTopics())
  {
    EXPECT_NE(documents.find("`" + topic.name + "`"), std::string::npos) << topic.name;
    for (const InputType& type : topic.types)
      EXPECT_NE(documents.find(type.name.substr(type.name.find('/') + 1)), std::string::npos) << type.name;
  }
}

TEST(InputTopics, AreRecordedByTheSimulation)
{
  // Absolute names, which tether_replay --ns finds.
  const std::string launch = std::regex_replace(textOf("launch/sim.launch"), std::regex("\\s+|\""), " ");
  for (const InputTopic& topic : inputTopics())
    EXPECT_NE(launch.find(" /$(arg ns)/" + topic.name + " "), std::string::npos) << topic.name;
}

TEST(InputTopics, EachHasALaunchArgument)
{
  const std::string launch = textOf("launch/tether_monitor.launch");
  for (const InputTopic& topic : inputTopics())
  {
    std::string argument = topic.name;
    std::replace(argument.begin(), argument.end(), '/', '_');
    EXPECT_NE(launch.find("<remap from=\"" + topic.name + "\""), std::string::npos) << topic.name;
    EXPECT_NE(launch.find("to=\"$(arg " + argument + ")\""), std::string::npos) << topic.name;
  }
}

}  // namespace tether_monitor
