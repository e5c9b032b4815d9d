#include "tether_monitor/ros/simulator_node.h"

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/Float64.h>
#include <tether_monitor/ObstacleArray.h>
#include <tether_monitor/Payout.h>
#include <tether_monitor/TetherState.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cmath>

#include "tether_monitor/params/load_config.h"
#include "tether_monitor/params/load_simulation.h"
#include "tether_monitor/ros/geometry_conversions.h"
#include "tether_monitor/ros/parameter_server.h"

namespace tether_monitor
{
namespace
{
constexpr double CONNECTING = 1.0;  // [s], wall clock: what is published before all have connected is lost to some
constexpr int QUEUE = 20;
constexpr double OBSTACLE_PERIOD = 0.5;  // [s]
constexpr double COMMAND_LIFE = 1.0;     // [s]
constexpr double LONGEST_WAIT = 1.0;     // [s], wall clock, for who says nothing
constexpr double LONGEST_STALL = 10.0;   // [s], likewise, of a monitor that has spoken
constexpr double LONGEST_ANSWER = 0.25;  // [s], of simulated time, from a measurement to a command

visualization_msgs::Marker box(const std_msgs::Header& header, int id, const monitor::BodyState& body,
                               const core::Vector3& centre, const core::Vector3& size)
{
  visualization_msgs::Marker m;
  m.header = header;
  m.ns = "body";
  m.id = id;
  m.type = visualization_msgs::Marker::CUBE;
  m.pose.position = pointMessage(body.position + body.orientation * centre);
  m.pose.orientation = quaternionMessage(body.orientation);
  m.scale = vectorMessage(size);
  m.color.r = id == 0 ? 0.75f : 0.95f;
  m.color.g = id == 0 ? 0.75f : 0.75f;
  m.color.b = id == 0 ? 0.8f : 0.2f;
  m.color.a = 0.9f;
  return m;
}

geometry_msgs::TransformStamped transformOf(const std_msgs::Header& header, const std::string& child,
                                            const monitor::BodyState& body)
{
  geometry_msgs::TransformStamped transform;
  transform.header = header;
  transform.child_frame_id = child;
  transform.transform.translation = vectorMessage(body.position);
  transform.transform.rotation = quaternionMessage(body.orientation);
  return transform;
}
}  // namespace

SimulatorNode::SimulatorNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
  : nh_(nh),
    private_nh_(private_nh),
    plan_(params::loadSimulation(readParameterServer(private_nh), private_nh.getNamespace())),
    config_(params::loadConfig(readParameterServer(private_nh), private_nh.getNamespace())),
    simulator_(config_, plan_),
    vessel_sensor_(plan_.vessel_sensor, plan_.seed),
    vehicle_sensor_(plan_.vehicle_sensor, plan_.seed + 1),
    heave_sensor_(plan_.heave, plan_.seed + 2),
    generator_(plan_.seed + 3)
{
  if (plan_.heave.rate > 0.0)
    vessel_odometry_ = nh_.advertise<nav_msgs::Odometry>("vessel/odom", QUEUE);
  else
    vessel_pose_ = nh_.advertise<geometry_msgs::PoseStamped>("vessel/pose", QUEUE);
  vehicle_pose_ = nh_.advertise<geometry_msgs::PoseStamped>("vehicle/pose", QUEUE);
  if (plan_.vessel_sensor.velocity && !vessel_odometry_)
    vessel_velocity_ = nh_.advertise<geometry_msgs::TwistStamped>("vessel/velocity", QUEUE);
  if (plan_.vehicle_sensor.velocity)
    vehicle_velocity_ = nh_.advertise<geometry_msgs::TwistStamped>("vehicle/velocity", QUEUE);
  if (simulator_.hasWinch() && plan_.payout_rate > 0.0)
    payout_ = nh_.advertise<Payout>("payout", QUEUE);
  if (plan_.publish_obstacles)
    obstacles_ = nh_.advertise<ObstacleArray>("obstacles", QUEUE);
  if (config_.vehicle_mode != monitor::VehicleMode::TRACKED)
    thrust_ = nh_.advertise<geometry_msgs::WrenchStamped>("vehicle/thrust", QUEUE);
  vessel_force_ = private_nh_.advertise<geometry_msgs::WrenchStamped>("vessel_end/force", QUEUE);
  vehicle_force_ = private_nh_.advertise<geometry_msgs::WrenchStamped>("vehicle_end/force", QUEUE);
  markers_ = private_nh_.advertise<visualization_msgs::MarkerArray>("markers", QUEUE);
  subscribeToCommands();
  frame_prefix_ = nh_.getNamespace() == "/" ? "" : nh_.getNamespace().substr(1) + "/";

  period_ =
      std::min({simulation::Simulator::STEP, 1.0 / plan_.vessel_sensor.rate, 1.0 / plan_.vehicle_sensor.rate});
  if (plan_.clock)
  {
    clock_ = nh_.advertise<rosgraph_msgs::Clock>("/clock", QUEUE);
    begin(ros::Time(1.0));
    wall_timer_ = nh_.createWallTimer(ros::WallDuration(period_ / plan_.speed),
                                      [this](const ros::WallTimerEvent&) { tick(); });
  }
  else
  {
    timer_ = nh_.createTimer(ros::Duration(period_), [this](const ros::TimerEvent&) { tick(); });
  }
  ROS_INFO("%s simulates a vessel and a vehicle on %g m of tether", private_nh_.getNamespace().c_str(),
           config_.tether.length);
}

void SimulatorNode::subscribeToCommands()
{
  if (plan_.winch_is_commanded)
  {
    const boost::function<void(const std_msgs::Float64&)> obey = [this](const std_msgs::Float64& rate)
    {
      if (!std::isfinite(rate.data))
        return;
      simulator_.commandWinch(rate.data);
      winch_commanded_at_ = time_;
    };
    winch_command_ = nh_.subscribe<std_msgs::Float64>("winch/command", 1, obey);
  }
  if (plan_.vehicle.control == simulation::VehicleControl::EXTERNAL)
  {
    const boost::function<void(const geometry_msgs::Wrench&)> obey = [this](const geometry_msgs::Wrench& message)
    {
      const core::Wrench thrust{vector(message.force), vector(message.torque)};
      if (thrust.force.allFinite() && thrust.torque.allFinite())
      {
        simulator_.commandThrust(thrust);
        thrust_commanded_at_ = time_;
      }
    };
    thrust_command_ = nh_.subscribe<geometry_msgs::Wrench>("vehicle/command", 1, obey);
  }
  if (plan_.lockstep)
  {
    const boost::function<void(const TetherState&)> note = [this](const TetherState& state)
    {
      monitored_ = (state.header.stamp - start_).toSec();
      waits_since_ = ros::WallTime();
    };
    monitor_state_ =
        nh_.subscribe<TetherState>("tether_monitor/state", 1, note, {}, ros::TransportHints().tcpNoDelay());
  }
}

// In lockstep: until the monitor, and who has begun to command, have answered.
bool SimulatorNode::mustWait()
{
  const auto isLate = [this](double commanded_at)
  { return commanded_at >= 0.0 && time_ - commanded_at > LONGEST_ANSWER; };
  const bool is_monitor_due = plan_.lockstep && time_ - monitored_ > 1.0 / config_.rate - 1e-6;
  const bool waits =
      is_monitor_due || (plan_.lockstep && (isLate(winch_commanded_at_) || isLate(thrust_commanded_at_)));
  const double patience = is_monitor_due && monitored_ > 0.0 ? LONGEST_STALL : LONGEST_WAIT;
  const ros::WallTime now = ros::WallTime::now();
  if (!waits || waits_since_.isZero())
    waits_since_ = waits ? now : ros::WallTime();
  if (!waits || (now - waits_since_).toSec() < patience)
    return waits;
  // Who has ended is not waited for again until it commands again.
  if (isLate(winch_commanded_at_))
    winch_commanded_at_ = -1e300;
  if (isLate(thrust_commanded_at_))
    thrust_commanded_at_ = -1e300;
  return false;
}

// A winch whose controller is gone stops.
void SimulatorNode::dropOldCommands()
{
  if (plan_.winch_is_commanded && time_ - winch_commanded_at_ > COMMAND_LIFE)
    simulator_.commandWinch(simulator_.hasOrders() ? std::nan("") : 0.0);
}

void SimulatorNode::begin(const ros::Time& now)
{
  start_ = now;
  started_ = true;
  simulator_.setEpoch(now.toSec());
}

void SimulatorNode::tick()
{
  if (!running_)
    return;
  if ((ros::WallTime::now() - made_at_).toSec() < CONNECTING)
  {
    if (plan_.clock)
      publishClock();
    return;
  }
  if (!started_)
  {
    const ros::Time now = ros::Time::now();
    if (!now.isZero())
      begin(now);
    return;
  }
  if (mustWait())
    return;
  // The timer may skip or bunch ticks; the simulation keeps its own even pace.
  const double now = plan_.clock ? time_ + period_ : (ros::Time::now() - start_).toSec();
  for (; time_ + period_ <= now + 1e-6; time_ = static_cast<double>(++steps_) * period_)
  {
    dropOldCommands();
    if (!simulator_.advance(time_ + period_))
    {
      running_ = false;
      ROS_FATAL("the simulation has failed at %.2f s: its solver found no solution", time_);
      ros::shutdown();
      return;
    }
    publishMeasurements(time_ + period_);
  }
  if (plan_.clock)
    publishClock();
  publishTruth();
}

void SimulatorNode::publishClock()
{
  rosgraph_msgs::Clock clock;
  clock.clock = stamp(time_);
  clock_.publish(clock);
}

void SimulatorNode::publishMeasurements(double t)
{
  for (const simulation::Measurement& m : vessel_sensor_.sample(t, simulator_.vessel()))
  {
    if (vessel_odometry_)
      publishOdometry(m);
    else
      publishBody(m, vessel_pose_, vessel_velocity_);
  }
  publishHeave(t);
  for (const simulation::Measurement& m : vehicle_sensor_.sample(t, simulator_.vehicle()))
    publishBody(m, vehicle_pose_, vehicle_velocity_);
  publishWinch(t);
  publishObstacles(t);
  if (thrust_)
  {
    geometry_msgs::WrenchStamped thrust;
    thrust.header.stamp = stamp(t);
    thrust.header.frame_id = config_.vehicle.frame;
    thrust.wrench.force = vectorMessage(simulator_.vehicleThrust().force);
    thrust.wrench.torque = vectorMessage(simulator_.vehicleThrust().torque);
    thrust_.publish(thrust);
  }
}

void SimulatorNode::publishBody(const simulation::Measurement& m, const ros::Publisher& pose,
                                const ros::Publisher& velocity)
{
  geometry_msgs::PoseStamped p;
  p.header.stamp = stamp(m.time);
  p.header.frame_id = config_.world_frame;
  p.pose.position = pointMessage(m.body.position);
  p.pose.orientation = quaternionMessage(m.body.orientation);
  // Velocity first: the pose then finds it there.
  if (m.has_velocity)
  {
    geometry_msgs::TwistStamped v;
    v.header = p.header;
    v.twist.linear = vectorMessage(m.body.velocity);
    v.twist.angular = vectorMessage(m.body.angular_velocity);
    velocity.publish(v);
  }
  pose.publish(p);
}

// The position with its covariance; what is not measured has a variance that says so.
void SimulatorNode::publishOdometry(const simulation::Measurement& m)
{
  nav_msgs::Odometry message;
  message.header.stamp = stamp(m.time);
  message.header.frame_id = config_.world_frame;
  message.child_frame_id = config_.vessel.frame;
  message.pose.pose.position = pointMessage(m.body.position);
  message.pose.pose.orientation = quaternionMessage(m.body.orientation);
  const Eigen::Quaterniond to_body = m.body.orientation.conjugate();
  message.twist.twist.linear = vectorMessage(to_body * m.body.velocity);
  message.twist.twist.angular = vectorMessage(to_body * m.body.angular_velocity);
  for (int i = 0; i < 3; ++i)
  {
    message.pose.covariance[7 * i] = std::pow(std::max(plan_.vessel_sensor.position_stddev, 1e-3), 2);
    message.pose.covariance[7 * (i + 3)] = std::pow(std::max(plan_.vessel_sensor.orientation_stddev, 1e-4), 2);
    message.twist.covariance[7 * i] =
        m.has_velocity ? std::pow(std::max(plan_.vessel_sensor.velocity_stddev, 1e-3), 2) : NOT_MEASURED_VARIANCE;
    message.twist.covariance[7 * (i + 3)] = message.twist.covariance[7 * i];
  }
  vessel_odometry_.publish(message);
}

// The height alone, from the motion sensor, with the attitude of the moment.
void SimulatorNode::publishHeave(double t)
{
  const monitor::BodyState vessel = simulator_.vessel();
  const std::optional<double> height = heave_sensor_.sample(t, vessel);
  if (!height)
    return;
  nav_msgs::Odometry message;
  message.header.stamp = stamp(t);
  message.header.frame_id = config_.world_frame;
  message.child_frame_id = config_.vessel.frame;
  message.pose.pose.position.z = *height;
  message.pose.pose.orientation = quaternionMessage(vessel.orientation);
  for (int i = 0; i < 3; ++i)
  {
    message.pose.covariance[7 * i] =
        i < 2 ? NOT_MEASURED_VARIANCE : std::pow(std::max(plan_.heave.stddev, 1e-3), 2);
    message.pose.covariance[7 * (i + 3)] = 1e-8;
    message.twist.covariance[7 * i] = message.twist.covariance[7 * (i + 3)] = NOT_MEASURED_VARIANCE;
  }
  vessel_odometry_.publish(message);
}

void SimulatorNode::publishWinch(double t)
{
  if (!payout_ || t < next_payout_ - 1e-9)
    return;
  next_payout_ = std::max(next_payout_ + 1.0 / plan_.payout_rate, t);
  std::normal_distribution<double> noise;
  Payout report;
  report.header.stamp = stamp(t);
  report.header.frame_id = config_.world_frame;
  report.length = simulator_.payout().length + plan_.payout_stddev * noise(generator_);
  report.rate = simulator_.payout().rate;
  payout_.publish(report);
}

void SimulatorNode::publishObstacles(double t)
{
  if (!obstacles_ || t < next_obstacles_ - 1e-9)
    return;
  next_obstacles_ = t + OBSTACLE_PERIOD;
  ObstacleArray array;
  array.header.stamp = stamp(t);
  array.header.frame_id = config_.world_frame;
  const std::vector<core::Obstacle>& known = simulator_.model().environment().obstacles();
  for (std::size_t k = 0; k < known.size(); ++k)
  {
    Obstacle message;
    message.name = known[k].name;
    message.shape = static_cast<uint8_t>(known[k].shape);
    message.pose.position = pointMessage(simulator_.state().obstacles[k].position);
    message.pose.orientation = quaternionMessage(known[k].orientation);
    for (int i = 0; i <= static_cast<int>(known[k].shape); ++i)
      message.size.push_back(known[k].size[i]);
    message.velocity = vectorMessage(simulator_.state().obstacles[k].velocity);
    message.mass = known[k].mass;
    message.friction = known[k].friction;
    array.obstacles.push_back(message);
  }
  obstacles_.publish(array);
}

void SimulatorNode::publishTruth()
{
  std_msgs::Header header;
  header.stamp = stamp(time_);
  header.frame_id = config_.world_frame;
  const core::EndForces forces = simulator_.endForces();
  for (const auto& [publisher, force] :
       {std::make_pair(&vessel_force_, forces.vessel), std::make_pair(&vehicle_force_, forces.vehicle)})
  {
    geometry_msgs::WrenchStamped message;
    message.header = header;
    message.wrench.force = vectorMessage(force);
    publisher->publish(message);
  }
  const monitor::BodyState vessel = simulator_.vessel(), vehicle = simulator_.vehicle();
  broadcaster_.sendTransform(transformOf(header, frame_prefix_ + "vessel", vessel));
  broadcaster_.sendTransform(transformOf(header, frame_prefix_ + "vehicle", vehicle));
  if (markers_.getNumSubscribers() == 0)
    return;
  visualization_msgs::MarkerArray array;
  const core::Hull& hull = *simulator_.model().bodies().vessel->hull;
  array.markers.push_back(
      box(header, 0, vessel, hull.keel + core::Vector3(0.0, 0.0, 0.5 * hull.size.z()), hull.size));
  const double side = std::max(std::cbrt(plan_.vehicle.body.volume), 0.3);
  array.markers.push_back(box(header, 1, vehicle, core::Vector3::Zero(), core::Vector3(2.0 * side, side, side)));
  markers_.publish(array);
}

}  // namespace tether_monitor
