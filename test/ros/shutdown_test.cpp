#include <signal.h>
#include <stdio.h>

#include <memory>

#include "common/main.h"
#include "common/scenario.h"

using namespace tether_monitor;

namespace
{
// Process of the node, by its unique command line argument; 0 if there is none.
pid_t nodeProcess()
{
  std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen("pgrep -f '[t]ether_monitor_node __name:=tether_monitor'", "r"), pclose);
  int pid = 0;
  return pipe && fscanf(pipe.get(), "%d", &pid) == 1 ? pid : 0;
}
}  // namespace

TEST(Shutdown, IsCleanWithinASecondOfSigint)
{
  Scenario scenario;
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
