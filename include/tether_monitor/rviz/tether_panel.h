#pragma once

#include <ros/ros.h>
#include <rviz/panel.h>
#include <tether_monitor/AlarmArray.h>
#include <tether_monitor/TetherForecast.h>
#include <tether_monitor/TetherState.h>

#include <future>
#include <string>

class QLabel;
class QLineEdit;
class QPushButton;

namespace tether_monitor
{
class AlarmTable;
class TensionScale;

/**
 * A panel of rviz for one monitor: what its estimate is worth, tensions with their bands, the colours of the
 * tether, forecast, alarms and their acknowledgement. Numbers that are older than two seconds are gone (a
 * forecast: five). The name of the node is kept in the configuration of rviz ("Node").
 */
class TetherPanel : public rviz::Panel
{
 public:
  explicit TetherPanel(QWidget* parent = nullptr);
  ~TetherPanel() override;

  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  void layOut();
  /// Listens to another node.
  void connectTo(const std::string& node);
  void show(const TetherState& state);
  void show(const TetherForecast& forecast);
  void show(const AlarmArray& alarms);
  /// Twice a second: is anybody there, and has the acknowledgement been answered?
  void look();
  void acknowledge();

  std::string node_;
  ros::Subscriber state_, forecast_, alarms_;
  ros::WallTime last_state_, last_forecast_;
  std::future<std::string> answer_;  // what was wrong with the acknowledgement, empty: nothing

  QLineEdit* node_edit_ = nullptr;
  QLabel *status_ = nullptr, *largest_ = nullptr, *vessel_ = nullptr, *vehicle_ = nullptr, *length_ = nullptr,
         *outlook_ = nullptr, *note_ = nullptr;
  TensionScale* scale_ = nullptr;
  AlarmTable* table_ = nullptr;
  QPushButton* button_ = nullptr;
};

}  // namespace tether_monitor
