#include "tether_monitor/rviz/tether_panel.h"

#include <std_srvs/Trigger.h>
#include <tether_monitor/AlarmAction.h>
#include <pluginlib/class_list_macros.hpp>

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

#include "tether_monitor/rviz/alarm_table.h"
#include "tether_monitor/rviz/panel_text.h"
#include "tether_monitor/rviz/tension_scale.h"

namespace tether_monitor
{
namespace
{
constexpr double STALE = 2.0, FORECAST_STALE = 5.0;  // [s], wall clock
constexpr int PERIOD = 500;                          // [ms]
constexpr int NARROWEST = 400;                       // [pixels]
const char* const USUAL_NODE = "/tether_monitor";

QLabel* readout(const char* name)
{
  auto* label = new QLabel("unknown");
  label->setObjectName(name);
  label->setWordWrap(true);
  QFont font = label->font();
  font.setPointSizeF(1.3 * font.pointSizeF());
  label->setFont(font);
  return label;
}

void paint(QLabel* label, const char* background, const char* text)
{
  label->setStyleSheet(
      QString("QLabel { background: %1; color: %2; padding: 6px; font-weight: bold; }").arg(background, text));
}

const char* colourOf(std::uint8_t status)
{
  if (status == TetherState::STATUS_OK)
    return "#cfe8d8";
  if (status == TetherState::STATUS_STOWED)
    return "#d0d4d8";
  return status == TetherState::STATUS_DEGRADED ? "#f0e442" : "#d55e00";
}

// In a thread of its own: a node that hangs must not hold rviz.
template <class Service>
std::future<std::string> call(const std::string& name, Service service)
{
  std::packaged_task<std::string()> task(
      [name, service]() mutable -> std::string
      {
        if (!ros::service::exists(name, false))
          return "no service " + name;
        if (!ros::service::call(name, service))
          return name + " did not answer";
        return service.response.success ? "" : service.response.message;
      });
  std::future<std::string> answer = task.get_future();
  std::thread(std::move(task)).detach();
  return answer;
}
}  // namespace

TetherPanel::TetherPanel(QWidget* parent) : rviz::Panel(parent)
{
  layOut();
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, [this] { look(); });
  timer->start(PERIOD);
  connectTo(USUAL_NODE);
}

// A field that loses the focus while the panel is taken apart has finished being edited.
TetherPanel::~TetherPanel()
{
  node_edit_->disconnect(this);
}

void TetherPanel::layOut()
{
  setMinimumWidth(NARROWEST);
  auto* layout = new QVBoxLayout(this);
  status_ = readout("status");
  layout->addWidget(status_);
  auto* form = new QFormLayout;
  const std::pair<const char*, QLabel**> rows[] = {{"largest", &largest_},
                                                   {"vessel", &vessel_},
                                                   {"vehicle", &vehicle_},
                                                   {"length", &length_},
                                                   {"forecast", &outlook_}};
  for (const auto& [name, label] : rows)
    form->addRow(name, *label = readout(name));
  layout->addLayout(form);
  layout->addWidget(new QLabel("tension over the working load, and its colours"));
  scale_ = new TensionScale;
  layout->addWidget(scale_);
  table_ = new AlarmTable;
  layout->addWidget(table_, 1);
  button_ = new QPushButton("acknowledge");
  button_->setObjectName("acknowledge");
  button_->setToolTip("Acknowledges the alarm that is selected, or all if none is");
  layout->addWidget(button_);
  note_ = new QLabel;
  note_->setObjectName("note");
  note_->setWordWrap(true);
  layout->addWidget(note_);
  node_edit_ = new QLineEdit;
  node_edit_->setObjectName("node");
  auto* bottom = new QFormLayout;
  bottom->addRow("node", node_edit_);
  layout->addLayout(bottom);
  connect(button_, &QPushButton::clicked, this, [this] { acknowledge(); });
  connect(node_edit_, &QLineEdit::editingFinished, this,
          [this]
          {
            const std::string node = node_edit_->text().trimmed().toStdString();
            if (node == node_)
              return;
            connectTo(node);
            Q_EMIT configChanged();
          });
}

void TetherPanel::connectTo(const std::string& node)
{
  node_ = node;
  node_edit_->setText(QString::fromStdString(node));
  for (ros::Subscriber* subscriber : {&state_, &forecast_, &alarms_})
    subscriber->shutdown();
  last_state_ = last_forecast_ = ros::WallTime();
  table_->show(AlarmArray());
  note_->clear();
  look();
  std::string why;
  if (node.empty() || !ros::names::validate(node, why))
    return note_->setText(QString::fromStdString("no name of a node: " + (node.empty() ? "it is empty" : why)));
  ros::NodeHandle nh(node);
  const boost::function<void(const TetherStateConstPtr&)> on_state = [this](const TetherStateConstPtr& state)
  { show(*state); };
  const boost::function<void(const AlarmArrayConstPtr&)> on_alarms = [this](const AlarmArrayConstPtr& alarms)
  { show(*alarms); };
  const boost::function<void(const TetherForecastConstPtr&)> on_forecast =
      [this](const TetherForecastConstPtr& forecast) { show(*forecast); };
  state_ = nh.subscribe<TetherState>("state", 1, on_state);
  alarms_ = nh.subscribe<AlarmArray>("alarms", 1, on_alarms);
  forecast_ = nh.subscribe<TetherForecast>("forecast", 1, on_forecast);
}

void TetherPanel::show(const TetherState& state)
{
  last_state_ = ros::WallTime::now();
  status_->setText(QString::fromStdString("estimate " + estimateText(state)));
  paint(status_, colourOf(state.status), state.status == TetherState::STATUS_INVALID ? "white" : "black");
  const bool has_numbers = std::isfinite(state.max_tension);
  const auto set = [&](QLabel* label, const std::string& text)
  { label->setText(QString::fromStdString(has_numbers ? text : "unknown")); };
  set(largest_, largestText(state));
  set(vessel_, bandText(state.vessel_tension, state.vessel_tension_p05, state.vessel_tension_p95));
  set(vehicle_, bandText(state.vehicle_tension, state.vehicle_tension_p05, state.vehicle_tension_p95));
  set(length_, lengthText(state));
  const double per_newton = state.working_utilisation / state.max_tension;
  const double p05 = std::fmax(state.vessel_tension_p05, state.vehicle_tension_p05);
  scale_->show({state.working_utilisation, per_newton * p05, per_newton * state.max_tension_p95});
}

void TetherPanel::show(const TetherForecast& forecast)
{
  last_forecast_ = ros::WallTime::now();
  outlook_->setText(QString::fromStdString(forecastText(forecast)));
}

void TetherPanel::show(const AlarmArray& alarms)
{
  table_->show(alarms);
  for (const Alarm& alarm : alarms.alarms)
    if (alarm.name == "over_tension_warning" && alarm.limit > 0.0 && alarm.limit < 1.0)
      scale_->setWarning(alarm.limit);
}

void TetherPanel::look()
{
  const ros::WallTime now = ros::WallTime::now();
  const double age = (now - last_state_).toSec();
  if ((now - last_forecast_).toSec() > FORECAST_STALE)
    outlook_->setText("no forecast");
  table_->setEnabled(age <= STALE);
  if (age > STALE)
  {
    status_->setText(
        last_state_.isZero()
            ? QString("nothing from %1 yet").arg(QString::fromStdString(node_))
            : QString("nothing from %1 for %2 s").arg(QString::fromStdString(node_)).arg(age, 0, 'f', 0));
    paint(status_, "#d55e00", "white");
    for (QLabel* label : {largest_, vessel_, vehicle_, length_})
      label->setText("unknown");
    scale_->show({NAN, NAN, NAN});
  }
  button_->setEnabled(table_->rowCount() > 0 && !answer_.valid());
  if (answer_.valid() && answer_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
    note_->setText(QString::fromStdString(answer_.get()));
}

void TetherPanel::acknowledge()
{
  if (answer_.valid())
    return;
  note_->clear();
  button_->setEnabled(false);
  AlarmAction one;
  one.request.name = table_->selected();
  one.request.action = "acknowledge";
  answer_ = one.request.name.empty() ? call(node_ + "/acknowledge", std_srvs::Trigger())
                                     : call(node_ + "/alarm_action", one);
}

void TetherPanel::load(const rviz::Config& config)
{
  rviz::Panel::load(config);
  QString node;
  if (config.mapGetString("Node", &node))
    connectTo(node.toStdString());
}

void TetherPanel::save(rviz::Config config) const
{
  rviz::Panel::save(config);
  config.mapSetValue("Node", QString::fromStdString(node_));
}

}  // namespace tether_monitor

PLUGINLIB_EXPORT_CLASS(tether_monitor::TetherPanel, rviz::Panel)
