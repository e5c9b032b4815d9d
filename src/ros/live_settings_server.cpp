#include "tether_monitor/ros/live_settings_server.h"

#include <algorithm>

namespace tether_monitor
{
namespace
{
using monitor::LiveSetting;

// The first holds the others.
std::vector<std::string> groupsOf(const std::vector<LiveSetting>& settings)
{
  std::vector<std::string> groups{"Default"};
  for (const LiveSetting& setting : settings)
    if (setting.group != groups.back())
      groups.push_back(setting.group);
  return groups;
}

template <typename NumberOf>
dynamic_reconfigure::Config toMessage(const std::vector<LiveSetting>& settings, const NumberOf& numberOf)
{
  const std::vector<std::string> groups = groupsOf(settings);
  dynamic_reconfigure::Config message;
  for (const LiveSetting& setting : settings)
  {
    dynamic_reconfigure::DoubleParameter parameter;
    parameter.name = setting.key;
    parameter.value = numberOf(setting);
    message.doubles.push_back(parameter);
  }
  for (std::size_t k = 0; k < groups.size(); ++k)
  {
    dynamic_reconfigure::GroupState state;
    state.name = groups[k];
    state.state = true;
    state.id = static_cast<int>(k);
    message.groups.push_back(state);
  }
  return message;
}

double valueOf(const LiveSetting& setting)
{
  return *setting.value;
}

dynamic_reconfigure::ConfigDescription describe(const std::vector<LiveSetting>& settings)
{
  dynamic_reconfigure::ConfigDescription message;
  const std::vector<std::string> groups = groupsOf(settings);
  for (std::size_t k = 0; k < groups.size(); ++k)
  {
    dynamic_reconfigure::Group group;
    group.name = groups[k];
    group.type = k == 0 ? "" : "tab";
    group.id = static_cast<int>(k);
    for (const LiveSetting& setting : settings)
      if (setting.group == groups[k])
      {
        dynamic_reconfigure::ParamDescription parameter;
        parameter.name = setting.key;
        parameter.type = "double";
        parameter.description = setting.meaning;
        group.parameters.push_back(parameter);
      }
    message.groups.push_back(group);
  }
  message.min = toMessage(settings, [](const LiveSetting& setting) { return setting.least; });
  message.max = toMessage(settings, [](const LiveSetting& setting) { return setting.most; });
  message.dflt = toMessage(settings, valueOf);
  return message;
}

// Writes what is wanted into the settings; why it cannot be, if it cannot.
std::vector<std::string> write(const dynamic_reconfigure::Config& wanted, std::vector<LiveSetting>& settings)
{
  std::vector<std::string> problems;
  const auto set = [&](const std::string& key, double value)
  {
    const auto setting =
        std::find_if(settings.begin(), settings.end(), [&](const LiveSetting& one) { return one.key == key; });
    if (setting == settings.end())
      problems.push_back(key + " cannot be changed while the monitor works");
    else if (!(value >= setting->least && value <= setting->most))
      problems.push_back(key + " = " + std::to_string(value) + " (must be " + std::to_string(setting->least) +
                         " to " + std::to_string(setting->most) + ")");
    else
      *setting->value = value;
  };
  for (const auto& parameter : wanted.doubles)
    set(parameter.name, parameter.value);
  for (const auto& parameter : wanted.ints)
    set(parameter.name, parameter.value);
  for (const auto& parameter : wanted.bools)
    problems.push_back(parameter.name + " is no number");
  for (const auto& parameter : wanted.strs)
    problems.push_back(parameter.name + " is no number");
  return problems;
}

std::string pathOf(std::string key)
{
  std::replace(key.begin(), key.end(), '.', '/');
  return key;
}
}  // namespace

LiveSettingsServer::LiveSettingsServer(const ros::NodeHandle& private_nh, const monitor::Config& config,
                                       Apply apply)
  : nh_(private_nh), apply_(std::move(apply)), config_(config)
{
  const std::vector<LiveSetting> settings = liveSettings(config_);
  description_ = nh_.advertise<dynamic_reconfigure::ConfigDescription>("parameter_descriptions", 1, true);
  description_.publish(describe(settings));
  updates_ = nh_.advertise<dynamic_reconfigure::Config>("parameter_updates", 1, true);
  updates_.publish(toMessage(settings, valueOf));
  service_ = nh_.advertiseService("set_parameters", &LiveSettingsServer::answer, this);
}

bool LiveSettingsServer::answer(dynamic_reconfigure::Reconfigure::Request& request,
                                dynamic_reconfigure::Reconfigure::Response& response)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  monitor::Config wanted = config_;
  std::vector<LiveSetting> settings = liveSettings(wanted);
  std::vector<std::string> problems = write(request.config, settings);
  if (problems.empty())
    problems = apply_(wanted);
  if (problems.empty())
    take(wanted);
  for (const std::string& problem : problems)
    ROS_ERROR("set_parameters: refused: %s", problem.c_str());
  settings = liveSettings(config_);
  response.config = toMessage(settings, valueOf);
  updates_.publish(response.config);
  return true;
}

void LiveSettingsServer::take(const monitor::Config& wanted)
{
  monitor::Config before = config_;
  config_ = wanted;
  const std::vector<LiveSetting> old = liveSettings(before), now = liveSettings(config_);
  for (std::size_t k = 0; k < now.size(); ++k)
  {
    if (*now[k].value == *old[k].value)
      continue;
    ROS_INFO("set_parameters: %s %g -> %g", now[k].key.c_str(), *old[k].value, *now[k].value);
    nh_.setParam(pathOf(now[k].key), *now[k].value);
  }
}

}  // namespace tether_monitor
