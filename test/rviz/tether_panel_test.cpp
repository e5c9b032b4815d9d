#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rviz/panel.h>
#include <std_srvs/Trigger.h>
#include <tether_monitor/AlarmAction.h>
#include <tether_monitor/AlarmArray.h>
#include <tether_monitor/TetherForecast.h>
#include <tether_monitor/TetherState.h>
#include <pluginlib/class_loader.hpp>

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <limits>
#include <string>
#include <vector>

namespace tether_monitor
{
namespace
{
constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

// The panel as rviz has it: loaded by its name, messages and timers served in one thread.
class Panel : public testing::Test
{
 protected:
  void SetUp() override
  {
    panel = loader.createUniqueInstance("tether_monitor/TetherPanel");
    panel->load(configured("/rov1/tether_monitor"));
    panel->show();
  }

  static rviz::Config configured(const char* node)
  {
    rviz::Config config;
    config.mapSetValue("Node", node);
    return config;
  }

  template <class Condition>
  bool until(const Condition& condition, double seconds = 8.0)
  {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
    while (!condition() && ros::WallTime::now() < end)
    {
      ros::spinOnce();
      QApplication::processEvents();
      ros::WallDuration(0.01).sleep();
    }
    return condition();
  }

  std::string text(const char* name) { return panel->findChild<QLabel*>(name)->text().toStdString(); }
  bool shows(const char* name, const std::string& words) { return text(name).find(words) != std::string::npos; }
  QTableWidget& table() { return *panel->findChild<QTableWidget*>(); }
  QPushButton& button() { return *panel->findChild<QPushButton*>("acknowledge"); }

  pluginlib::ClassLoader<rviz::Panel> loader{"rviz", "rviz::Panel"};
  ros::NodeHandle nh{"/rov1/tether_monitor"};
  ros::Publisher state = nh.advertise<TetherState>("state", 1, true);
  ros::Publisher forecast = nh.advertise<TetherForecast>("forecast", 1, true);
  ros::Publisher alarms = nh.advertise<AlarmArray>("alarms", 1, true);
  pluginlib::UniquePtr<rviz::Panel> panel;
};

TetherState tow()
{
  TetherState tow;
  tow.length = 250.0;
  tow.payout_rate = -0.2;
  tow.vessel_tension = tow.max_tension = 4540.0;
  tow.vehicle_tension = 820.0;
  tow.vessel_tension_p05 = 3910.0;
  tow.vessel_tension_p95 = tow.max_tension_p95 = 5300.0;
  tow.vehicle_tension_p05 = tow.vehicle_tension_p95 = NONE;
  tow.working_utilisation = 0.454;
  return tow;
}

AlarmArray twoAlarms()
{
  AlarmArray array;
  for (const char* name : {"slack", "over_tension", "breaking"})
  {
    Alarm alarm;
    alarm.name = name;
    alarm.severity = alarm.name == "slack" ? Alarm::WARNING : Alarm::ALARM;
    alarm.state = alarm.name == "breaking" ? Alarm::NORMAL : Alarm::UNACKNOWLEDGED;
    alarm.value = 1.12;
    alarm.peak = NONE;
    array.alarms.push_back(alarm);
  }
  return array;
}
}  // namespace

TEST_F(Panel, ShowsWhatThereIsAndNoStaleNumber)
{
  EXPECT_TRUE(shows("status", "nothing from /rov1/tether_monitor yet"));
  EXPECT_FALSE(table().isEnabled());
  state.publish(tow());
  ASSERT_TRUE(until([&] { return shows("status", "valid") && table().isEnabled(); }));
  EXPECT_EQ(text("vessel"), "4.54 kN (3.91 kN to 5.3 kN)");
  EXPECT_EQ(text("vehicle"), "820 N");
  EXPECT_TRUE(shows("largest", "45 % of working load")) << text("largest");
  EXPECT_EQ(text("length"), "250 m, in 0.20 m/s");
  ASSERT_TRUE(until([&] { return shows("status", "nothing from /rov1/tether_monitor for"); }));
  EXPECT_EQ(text("vessel"), "unknown");
  EXPECT_FALSE(table().isEnabled());
  TetherState none = tow();
  none.status = TetherState::STATUS_INVALID;
  none.reason = TetherState::REASON_VESSEL_STALE;
  none.max_tension = none.vessel_tension = NONE;
  state.publish(none);
  ASSERT_TRUE(until([&] { return shows("status", "INVALID"); }));
  EXPECT_EQ(text("vessel"), "unknown");
}

TEST_F(Panel, AForecastGoesWithItsNode)
{
  TetherForecast f;
  f.members = 96;
  f.horizon = 30.0;
  f.probability_over_tension = 0.62;
  forecast.publish(f);
  ASSERT_TRUE(until([&] { return shows("forecast", "over-tension 62 %"); }));
  EXPECT_TRUE(until([&] { return shows("forecast", "no forecast"); }));
}

TEST_F(Panel, AcknowledgesTheOneThatIsSelectedOrAll)
{
  std::vector<std::string> asked;
  bool is_refused = false;
  const ros::ServiceServer one = nh.advertiseService<AlarmAction::Request, AlarmAction::Response>(
      "alarm_action",
      [&](AlarmAction::Request& request, AlarmAction::Response& response)
      {
        asked.push_back(request.action + " " + request.name);
        response.success = !is_refused;
        response.message = is_refused ? "it is shelved" : "";
        return true;
      });
  const ros::ServiceServer all = nh.advertiseService<std_srvs::Trigger::Request, std_srvs::Trigger::Response>(
      "acknowledge",
      [&](std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response)
      {
        asked.push_back("all");
        response.success = true;
        return true;
      });
  alarms.publish(twoAlarms());
  ASSERT_TRUE(until([&] { return table().rowCount() == 2 && button().isEnabled(); }));
  EXPECT_EQ(table().item(0, 0)->text().toStdString(), "over tension");
  EXPECT_EQ(table().item(0, 1)->text().toStdString(), "ACTIVE");
  EXPECT_EQ(table().item(0, 3)->text().toStdString(), "not known");
  button().click();
  ASSERT_TRUE(until([&] { return asked.size() == 1 && button().isEnabled(); }));
  table().selectRow(1);
  alarms.publish(twoAlarms());
  until([] { return false; }, 0.3);
  is_refused = true;
  button().click();
  ASSERT_TRUE(until([&] { return asked.size() == 2 && shows("note", "it is shelved"); }))
      << asked.back() << ": " << text("note");
  EXPECT_EQ(asked, (std::vector<std::string>{"all", "acknowledge slack"}));
}

TEST_F(Panel, ANodeThatIsNotThereIsSaid)
{
  alarms.publish(twoAlarms());
  ASSERT_TRUE(until([&] { return table().rowCount() == 2 && button().isEnabled(); }));
  button().click();
  EXPECT_TRUE(until([&] { return shows("note", "no service /rov1/tether_monitor/acknowledge"); }));
}

TEST_F(Panel, AnotherNodeIsListenedToAndKept)
{
  auto* edit = panel->findChild<QLineEdit*>("node");
  state.publish(tow());
  ASSERT_TRUE(until([&] { return shows("status", "valid"); }));
  edit->setText("no name");
  Q_EMIT edit->editingFinished();
  EXPECT_TRUE(shows("note", "no name of a node"));
  edit->setText("/other");
  Q_EMIT edit->editingFinished();
  EXPECT_TRUE(shows("status", "nothing from /other yet"));
  rviz::Config saved;
  panel->save(saved);
  QString node;
  EXPECT_TRUE(saved.mapGetString("Node", &node));
  EXPECT_EQ(node.toStdString(), "/other");
}
}  // namespace tether_monitor

int main(int argc, char** argv)
{
  qputenv("QT_QPA_PLATFORM", "offscreen");
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "tether_panel_test");
  QApplication application(argc, argv);
  ros::NodeHandle keeps_ros_alive;
  return RUN_ALL_TESTS();
}
