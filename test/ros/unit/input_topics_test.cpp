#include "tether_monitor/ros/input_topics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
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
  std::istringstream launch(textOf("launch/sim.launch"));
  const std::set<std::string> words{std::istream_iterator<std::string>(launch), {}};
  for (const InputTopic& topic : inputTopics())
    EXPECT_EQ(words.count(topic.name), 1u) << topic.name;
}

}  // namespace tether_monitor
