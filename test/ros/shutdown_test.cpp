#include <signal.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "common/main.h"
#include "common/ros_test_bench.h"

using namespace tether_monitor;

namespace
{
std::string contentOf(const std::filesystem::path& path)
{
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// Process of the node that talks to this test's master, found by command line and environment; 0 if there is none.
pid_t nodeProcess()
{
  const std::string master = std::string("ROS_MASTER_URI=") + std::getenv("ROS_MASTER_URI") + '\0';
  for (const auto& entry : std::filesystem::directory_iterator("/proc"))
    if (contentOf(entry.path() / "cmdline").find("tether_monitor_node") != std::string::npos &&
        contentOf(entry.path() / "environ").find(master) != std::string::npos)
      return std::atoi(entry.path().filename().c_str());
  return 0;
}
}  // namespace

TEST(Shutdown, IsCleanWithinASecondOfSigint)
{
  RosTestBench scenario;
  scenario.run(1.0);
  ASSERT_EQ(scenario.state.status, TetherState::STATUS_OK) << "precondition";
  ASSERT_TRUE(ros::param::has("/rov1/tether_monitor/tether/length"));
  const pid_t pid = nodeProcess();
  ASSERT_GT(pid, 0);
  const ros::WallTime began = ros::WallTime::now();
  ASSERT_EQ(kill(pid, SIGINT), 0);
  while (nodeProcess() != 0 && (ros::WallTime::now() - began).toSec() < 5.0)
    ros::WallDuration(0.02).sleep();
  EXPECT_LT((ros::WallTime::now() - began).toSec(), 1.0);
}
