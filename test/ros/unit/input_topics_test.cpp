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
    EXPECT_FALSE(topic.type.empty());
    EXPECT_FALSE(topic.meaning.empty());
  }
  EXPECT_EQ(findInputTopic("vessel/pos"), nullptr);
}

TEST(InputTopics, EveryBodyHasPoses)
{
  for (const InputStream body : {InputStream::VESSEL, InputStream::VEHICLE})
    EXPECT_TRUE(std::any_of(inputTopics().begin(), inputTopics().end(),
                            [&](const InputTopic& topic) { return topic.stream == body && topic.is_pose; }));
}

TEST(InputTopics, StandInTheReadmeWithTheirTypes)
{
  const std::string readme = textOf("README.md");
  for (const InputTopic& topic : inputTopics())
  {
    EXPECT_NE(readme.find("`" + topic.name + "`"), std::string::npos) << topic.name;
    EXPECT_NE(readme.find(topic.type.substr(topic.type.find('/') + 1)), std::string::npos) << topic.type;
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
