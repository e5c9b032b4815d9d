#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tether_monitor/TetherForecast.h>
#include <tether_monitor/WhatIf.h>

#include <memory>
#include <mutex>

#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/ros/forecast_thread.h"
#include "tether_monitor/ros/priority_mutex.h"
#include "tether_monitor/ros/time_conversion.h"

namespace tether_monitor
{
/// Message of a forecast. @param header  its stamp is that of the forecast's begin.
TetherForecast toMessage(const std_msgs::Header& header, const monitor::TetherForecast& forecast);

/**
 * **Publishes** (private) forecast. **Service** (private): what_if. Both work in
 * threads of their own; the cycle only hands over a copy once a second.
 */
class ForecastPublisher
{
 public:
  ForecastPublisher(const ros::NodeHandle& private_nh, const monitor::Config& config);
  ~ForecastPublisher();

  /// After a cycle. @param time  of the estimator's seconds.
  void offer(const monitor::TetherEstimator& estimator, const TimeOrigin& time);
  /// With other numbers, from the next forecast on.
  void reconfigure(const monitor::Config& config) { thread_.reconfigure(config); }
  ForecastBudget budget() const { return thread_.budget(); }
  /// Of over-tension, as the last forecast has it; NaN if it is old at time t [s], or there is none.
  double probability(double t) const;
  /// Where the tether will be, as the last forecast has it; none if it is old at this stamp, or there is none.
  std::vector<core::Vector3> position(const ros::Time& stamp) const;

 private:
  void publish(const monitor::TetherForecast& forecast);
  bool answer(WhatIf::Request& request, WhatIf::Response& response);
  std_msgs::Header headerOf(double t) const;

  const std::string frame_;
  const double horizon_;  // [s]
  ros::NodeHandle nh_;    // with the queue of its own
  ros::CallbackQueue queue_;
  ros::Publisher publisher_;
  mutable PriorityMutex mutex_;
  TimeOrigin time_;                                    // guarded by mutex_
  ForecastThread::Start latest_;                       // likewise
  double probability_t_ = -1e300, probability_ = 0.0;  // likewise; of the last forecast
  std::vector<core::Vector3> position_;                // likewise
  double last_empty_ = -1e300;                         // [s]
  ros::ServiceServer service_;
  ForecastThread thread_;
  ros::AsyncSpinner spinner_;
};

}  // namespace tether_monitor
