#pragma once

#include <dynamic_reconfigure/ConfigDescription.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/ros.h>

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "tether_monitor/monitor/estimator/live_settings.h"

namespace tether_monitor
{
/**
 * liveSettings() for rqt_reconfigure and dynparam, by the keys of the parameter tree.
 *
 * **Publishes** (private, latched) parameter_descriptions, parameter_updates. **Service** (private):
 * set_parameters. A request is taken as a whole or refused as a whole, with its reasons in the log; what is taken
 * is on the parameter server as well, for the next start.
 */
class LiveSettingsServer
{
 public:
  /// @return why not; empty: it goes on with this configuration.
  using Apply = std::function<std::vector<std::string>(const monitor::Config&)>;

  LiveSettingsServer(const ros::NodeHandle& private_nh, const monitor::Config& config, Apply apply);

 private:
  bool answer(dynamic_reconfigure::Reconfigure::Request& request,
              dynamic_reconfigure::Reconfigure::Response& response);
  void take(const monitor::Config& wanted);

  ros::NodeHandle nh_;
  const Apply apply_;
  std::mutex mutex_;
  monitor::Config config_;  // guarded by mutex_
  ros::Publisher description_, updates_;
  ros::ServiceServer service_;
};

}  // namespace tether_monitor
