#include "tether_monitor/ros/output_publisher.h"

#include <std_msgs/Bool.h>
#include <tether_monitor/WrenchWithCovarianceStamped.h>

#include "tether_monitor/ros/message_conversions.h"

namespace tether_monitor
{
namespace
{
constexpr int OUTPUT_QUEUE = 10;
}

OutputPublisher::OutputPublisher(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh,
                                 const monitor::Config& config, bool has_ensemble, bool has_vehicle,
                                 MakeMarkers make_markers)
  : config_(config),
    make_markers_(std::move(make_markers)),
    nh_(private_nh),
    alarms_(nh_),
    bridge_(nh, config.runtime.bridge),
    standard_(nh, private_nh, config)
{
  over_tension_ = nh_.advertise<std_msgs::Bool>("over_tension", OUTPUT_QUEUE);
  state_ = nh_.advertise<TetherState>("state", OUTPUT_QUEUE);
  vessel_force_ = nh_.advertise<geometry_msgs::WrenchStamped>("vessel_end/force", OUTPUT_QUEUE);
  vehicle_force_ = nh_.advertise<geometry_msgs::WrenchStamped>("vehicle_end/force", OUTPUT_QUEUE);
  wrench_body_ = nh_.advertise<WrenchWithCovarianceStamped>("vehicle_end/wrench_body", OUTPUT_QUEUE);
  contacts_ = nh_.advertise<ContactArray>("contacts", OUTPUT_QUEUE);
  markers_ = nh_.advertise<visualization_msgs::MarkerArray>("markers", OUTPUT_QUEUE);
  if (has_ensemble)
    parameters_ = nh_.advertise<ParameterEstimate>("parameters", OUTPUT_QUEUE);
  if (has_vehicle)
    vehicle_ = nh_.advertise<nav_msgs::Odometry>("vehicle/estimate", OUTPUT_QUEUE);
}

std_msgs::Header OutputPublisher::headerOf(const CycleOutput& output) const
{
  std_msgs::Header header;
  header.stamp = output.stamp;
  header.frame_id = config_.world_frame;
  return header;
}

void OutputPublisher::publishFlag(const CycleOutput& output)
{
  std_msgs::Bool message;
  message.data = output.over_tension;
  over_tension_.publish(message);
}

void OutputPublisher::publishAlarms(const CycleOutput& output)
{
  if (output.alarms)
    alarms_.publish(headerOf(output), *output.alarms, output.time);
}

void OutputPublisher::publishNumbers(const CycleOutput& output)
{
  const monitor::TetherEstimate& e = output.estimate;
  std_msgs::Header header = headerOf(output);
  toMessage(e, state_message_);
  state_message_.header = header;
  state_message_.step_time = output.step_time;
  state_.publish(state_message_);
  vessel_force_.publish(wrenchMessage(header, e, e.stations.ends.vessel, e.stations.ends.vessel_moment));
  vehicle_force_.publish(wrenchMessage(header, e, e.stations.ends.vehicle, e.stations.ends.vehicle_moment));
  bridge_.publish(e, output.attitude);
  standard_.publish(output);
  if (e.has_vehicle)
    vehicle_.publish(vehicleMessage(header, config_.vehicle, e));
  if (output.parameters)
    parameters_.publish(*output.parameters);
  if (output.contacts)
    contacts_.publish(*output.contacts);
  header.frame_id = config_.vehicle.frame;
  wrench_body_.publish(bodyWrenchMessage(header, e, output.attitude, config_.vehicle));
}

void OutputPublisher::publishMarkers(const CycleOutput& output)
{
  if (markers_.getNumSubscribers() > 0)
    markers_.publish(make_markers_(headerOf(output)));
}

}  // namespace tether_monitor
