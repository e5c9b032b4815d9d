#include <XmlRpcClient.h>
#include <ros/network.h>
#include <signal.h>
#include <tether_monitor/AlarmAction.h>
#include <tether_monitor/AlarmEvent.h>
#include <tether_monitor/AlarmLog.h>

#include <cmath>
#include <cstdio>

#include "common/main.h"
#include "common/ros_test_bench.h"

using namespace tether_monitor;

namespace
{
const std::string NODE = "/rov1/tether_monitor/";

struct Events
{
  Events()
  {
    subscriber_ = nh_.subscribe<AlarmEvent>(NODE + "events", 100,
                                            [this](const AlarmEvent::ConstPtr& event) { all.push_back(*event); });
  }
  const AlarmEvent* last(const std::string& name) const
  {
    for (auto event = all.rbegin(); event != all.rend(); ++event)
      if (event->alarm.name == name)
        return &*event;
    return nullptr;
  }
  std::vector<AlarmEvent> all;

 private:
  ros::NodeHandle nh_;
  ros::Subscriber subscriber_;
};

// What is wrong; empty: nothing.
std::string act(const std::string& name, const std::string& action, double seconds = 0.0)
{
  AlarmAction call;
  call.request.name = name;
  call.request.action = action;
  call.request.seconds = seconds;
  if (!ros::service::call(NODE + "alarm_action", call))
    return "no answer";
  EXPECT_EQ(call.response.success, call.response.message.empty());
  return call.response.message;
}

std::vector<AlarmEvent> logAfter(unsigned number)
{
  AlarmLog call;
  call.request.after = number;
  EXPECT_TRUE(ros::service::call(NODE + "alarm_log", call));
  return call.response.events;
}

// Drives the vehicle off until the tether is taut, then back.
void strain(RosTestBench& scenario)
{
  scenario.vehicle_velocity = {0.8, 0.0, -0.5};
  for (int i = 0; i < 400 && !(scenario.state.working_utilisation > 1.2); ++i)
    scenario.run(0.05);
  scenario.run(0.3);
}

void slacken(RosTestBench& scenario)
{
  scenario.vehicle_velocity = {-0.8, 0.0, 0.5};
  scenario.run(5.0);
  scenario.vehicle_velocity = {0.0, 0.0, 0.0};
}

int pidOfNode()
{
  XmlRpc::XmlRpcValue arguments, response, payload;
  arguments[0] = ros::this_node::getName();
  arguments[1] = std::string("/rov1/tether_monitor");
  if (!ros::master::execute("lookupNode", arguments, response, payload, false))
    return 0;
  std::string host;
  std::uint32_t port = 0;
  ros::network::splitURI(payload, host, port);
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue caller, answer;
  caller[0] = ros::this_node::getName();
  return client.execute("getPid", caller, answer) ? static_cast<int>(answer[2]) : 0;
}
}  // namespace

// One for both tests: time goes on.
RosTestBench& bench()
{
  static RosTestBench scenario;
  return scenario;
}

TEST(Alarms, LifeForAnOperator)
{
  RosTestBench& scenario = bench();
  Events events;
  scenario.run(2.0);
  ASSERT_EQ(scenario.state.status, TetherState::STATUS_OK) << "precondition";
  strain(scenario);
  ASSERT_TRUE(scenario.over_tension);
  ASSERT_TRUE(scenario.waitFor([&] { return events.last("over_tension") != nullptr; }, 10.0));
  const AlarmEvent raised = *events.last("over_tension");
  EXPECT_EQ(raised.from, Alarm::NORMAL);
  EXPECT_EQ(raised.to, Alarm::UNACKNOWLEDGED);
  EXPECT_FALSE(raised.first_out) << "the warning came first";
  EXPECT_GT(raised.alarm.value, 1.0);
  EXPECT_EQ(raised.alarm.unit, "fraction of working_load");
  EXPECT_NE(raised.alarm.advice, "");

  EXPECT_EQ(act("over_tension", "acknowledge"), "");
  EXPECT_EQ(act("over_tension", "acknowledge"), "'over_tension' is active, acknowledged");
  EXPECT_EQ(act("over_tensions", "acknowledge"), "there is no alarm 'over_tensions'");
  EXPECT_NE(act("over_tension", "silence"), "");
  EXPECT_NE(act("over_tension", "shelve"), "") << "no time";
  EXPECT_EQ(act("over_tension", "shelve", 30.0), "");
  scenario.run(0.2);
  EXPECT_EQ(scenario.alarm("over_tension")->state, Alarm::SHELVED);
  EXPECT_NEAR((scenario.alarm("over_tension")->shelved_until - ros::Time(scenario.time)).toSec(), 30.0, 1.0);
  EXPECT_TRUE(scenario.over_tension) << "no operator hides it from a control loop";

  slacken(scenario);
  scenario.run(2.0);
  EXPECT_FALSE(scenario.over_tension);
  EXPECT_EQ(act("over_tension", "unshelve"), "");
  scenario.run(0.2);
  EXPECT_EQ(scenario.alarm("over_tension")->state, Alarm::NORMAL);
  EXPECT_GT(scenario.alarm("over_tension")->peak, 1.0);
  ASSERT_TRUE(scenario.waitFor([&] { return events.last("over_tension")->to == Alarm::NORMAL; }, 10.0));

  const std::vector<AlarmEvent> log = logAfter(0);
  for (std::size_t i = 0; i < log.size(); ++i)
    EXPECT_EQ(log[i].number, i + 1);
  ASSERT_FALSE(events.all.empty());
  for (std::size_t i = 0; i < events.all.size(); ++i)
    EXPECT_EQ(events.all[i].number, events.all[0].number + i) << "every change once";
  EXPECT_EQ(events.all.back().number, log.back().number);
  EXPECT_EQ(logAfter(log.back().number).size(), 0u);
}

TEST(Alarms, SurviveAKillAndSoDoesTheEstimate)
{
  RosTestBench& scenario = bench();
  strain(scenario);
  ASSERT_TRUE(scenario.over_tension) << "precondition";
  scenario.vehicle_velocity = {0.0, 0.0, 0.0};
  scenario.run(1.5);  // the state is kept once a second
  ros::WallDuration(0.3).sleep();
  const std::vector<AlarmEvent> before = logAfter(0);
  ASSERT_FALSE(before.empty());
  const double tension = scenario.state.vessel_tension;

  const int pid = pidOfNode();
  ASSERT_GT(pid, 0);
  ASSERT_EQ(kill(pid, SIGKILL), 0);
  const ros::WallTime killed = ros::WallTime::now();
  scenario.state.status = TetherState::STATUS_INVALID;
  ASSERT_TRUE(scenario.waitFor(
      [&]
      {
        const int now = pidOfNode();
        return now > 0 && now != pid;
      },
      15.0));
  ASSERT_TRUE(ros::service::waitForService(NODE + "alarm_log", ros::Duration(-1)));
  int ticks = 0;
  while (ticks < 40 && scenario.state.status == TetherState::STATUS_INVALID)
  {
    scenario.run(0.05);
    ++ticks;
  }
  const double took = (ros::WallTime::now() - killed).toSec();
  RecordProperty("seconds", std::to_string(took));
  std::cout << "valid again " << took << " s after the kill, " << ticks << " cycles\n";
  EXPECT_LE(scenario.state.status, TetherState::STATUS_DEGRADED);
  EXPECT_LE(ticks, 5);
  EXPECT_NEAR(scenario.state.vessel_tension, tension, 0.2 * tension) << "it goes on, it does not settle anew";
  EXPECT_TRUE(scenario.over_tension);
  const std::vector<AlarmEvent> after = logAfter(0);
  ASSERT_GE(after.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    EXPECT_EQ(after[i].number, before[i].number);
    EXPECT_EQ(after[i].alarm.name, before[i].alarm.name);
    EXPECT_EQ(after[i].header.stamp, before[i].header.stamp);
  }
  std::string file;
  ASSERT_TRUE(ros::param::get(NODE + "monitor/state_file", file));
  EXPECT_EQ(std::remove(file.c_str()), 0);
}
