#include "tether_monitor/ros/state_keeper.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

namespace tether_monitor
{
std::string freshPath(const std::string& name)
{
  const std::string path = testing::TempDir() + name + std::to_string(getpid());
  std::remove(path.c_str());
  return path;
}

TEST(StateKeeper, GivesBackTheLastOne)
{
  const std::string path = freshPath("state_keeper");
  {
    StateKeeper keeper(path);
    EXPECT_FALSE(keeper.read());
    EXPECT_TRUE(keeper.isDue(0.0));
    keeper.submit(0.0, {TimeOrigin(ros::Time(1000.5)), {1, 2, 3}});
    EXPECT_FALSE(keeper.isDue(0.9));
    EXPECT_TRUE(keeper.isDue(1.0));
    EXPECT_TRUE(keeper.isDue(-1.0)) << "the clock went back";
    keeper.submit(1.0, {TimeOrigin(ros::Time(1000.5)), {4, 5}});
  }
  const auto state = StateKeeper(path).read();
  ASSERT_TRUE(state);
  EXPECT_DOUBLE_EQ(state->time.epoch(), 1000.0);
  EXPECT_EQ(state->bytes, (std::vector<std::uint8_t>{4, 5}));
  std::remove(path.c_str());
}

TEST(StateKeeper, WhatItDidNotWriteIsNothing)
{
  const std::string path = freshPath("state_keeper_other");
  std::ofstream(path) << "something else that is long enough to be a header";
  EXPECT_FALSE(StateKeeper(path).read());
  std::ofstream(path) << "";
  EXPECT_FALSE(StateKeeper(path).read());
  std::remove(path.c_str());
}

TEST(StateKeeper, WithoutAFileThereIsNothing)
{
  StateKeeper keeper("");
  EXPECT_FALSE(keeper.isOn());
  EXPECT_FALSE(keeper.isDue(1e9));
  EXPECT_FALSE(keeper.read());
}

TEST(StateKeeper, AFileThatCannotBeWrittenIsNamed)
{
  try
  {
    StateKeeper keeper("/no/such/folder/state");
    FAIL();
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("/no/such/folder/state"), std::string::npos) << error.what();
  }
}

}  // namespace tether_monitor
