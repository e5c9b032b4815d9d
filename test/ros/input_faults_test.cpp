// Every fault of the poses on the live node, beside the truth: OK is never more than 10 % off for longer than a
// second, and the word for control loops is true whenever the status is INVALID.
#include <geometry_msgs/PoseStamped.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>
#include <tether_monitor/TetherState.h>

#include "common/main.h"
#include "support/fault_campaign.h"
#include "tether_monitor/params/load_config.h"

namespace tether_monitor
{
namespace
{
using monitor::PoseFault;
using monitor::Subject;

constexpr double PERIOD = 0.05, CLEAN = 7.0, FAULTY = 7.0, AFTER = 7.0;  // [s]

// One node, and what it should say.
class Campaign
{
 public:
  /// @param begin  time of the clock [s].
  Campaign(const std::string& ns, monitor::VehicleMode mode, double begin)
    : ns_("/" + ns + "/"), config_(loadConfig(mode)), begin_(begin), time_(begin)
  {
    clock_ = nh_.advertise<rosgraph_msgs::Clock>("/clock", 10);
    vessel_ = nh_.advertise<geometry_msgs::PoseStamped>(ns_ + "vessel/pose", 10);
    vehicle_ = nh_.advertise<geometry_msgs::PoseStamped>(ns_ + "vehicle/pose", 10);
    state_sub_ = nh_.subscribe<TetherState>(ns_ + "tether_monitor/state", 100,
                                            [this](const TetherState::ConstPtr& s) { state_ = *s; });
    word_sub_ = nh_.subscribe<std_msgs::Bool>(ns_ + "tether_monitor/over_tension", 100,
                                              [this](const std_msgs::Bool::ConstPtr& b)
                                              {
                                                over_tension_ = b->data;
                                                ++words_;
                                              });
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(30.0);
    while (ros::WallTime::now() < end && (vessel_.getNumSubscribers() == 0 || vehicle_.getNumSubscribers() == 0 ||
                                          clock_.getNumSubscribers() < 2 || state_sub_.getNumPublishers() == 0))
      ros::WallDuration(0.05).sleep();
    setClock();
  }

  void run(Subject faulty, PoseFault fault)
  {
    const std::string name = ns_ + " " + describe(faulty) + " " + describe(fault);
    resetNode();
    const double t0 = time_;
    monitor::TetherEstimator truth(config_);
    monitor::FaultySource vessel(faulty == Subject::VESSEL ? fault : PoseFault::NONE, t0 + CLEAN,
                                 t0 + CLEAN + FAULTY);
    monitor::FaultySource vehicle(faulty == Subject::VEHICLE ? fault : PoseFault::NONE, t0 + CLEAN,
                                  t0 + CLEAN + FAULTY);
    monitor::Trust trust;
    long silent = 0, unsafe = 0;
    while (time_ < t0 + CLEAN + FAULTY + AFTER)
    {
      time_ += PERIOD;
      publish(vessel_, vessel.at(time_, tow_.vessel(time_ - begin_)));
      publish(vehicle_, vehicle.at(time_, tow_.vehicle(time_ - begin_)));
      truth.addVessel(monitor::PoseMeasurement{time_ - begin_, tow_.vessel(time_ - begin_).position});
      truth.addVehicle(monitor::PoseMeasurement{time_ - begin_, tow_.vehicle(time_ - begin_).position});
      const monitor::TetherEstimate& right = truth.tick(time_ - begin_);
      ros::WallDuration(0.003).sleep();  // poses travel on other sockets than the clock
      if (!step())
      {
        ++silent;
        continue;
      }
      unsafe += state_.status == TetherState::STATUS_INVALID && !over_tension_;
      if (time_ > t0 + 5.0)
        trust.add(time_, static_cast<monitor::Status>(state_.status), state_.vessel_tension, right.vessel_tension);
    }
    std::printf("%-34s longest lie %.2f s, OK %.0f %%\n", name.c_str(), trust.longestLie(),
                100.0 * trust.shareOk());
    EXPECT_LE(trust.longestLie(), 1.0) << name;
    EXPECT_EQ(unsafe, 0) << name;
    EXPECT_LT(silent, 20) << name;
    if (fault == PoseFault::NONE)
    {
      EXPECT_GT(trust.shareOk(), 0.9) << name;
    }
  }

 private:
  static monitor::Config loadConfig(monitor::VehicleMode mode)
  {
    monitor::Config config = params::loadConfigFile(ros::NodeHandle("~").param<std::string>("config", ""));
    config.vehicle_mode = mode;
    if (mode == monitor::VehicleMode::FREE)
      config.vehicle_body = monitor::smallVehicle();
    return config;
  }

  void publish(const ros::Publisher& to, const std::optional<monitor::PoseMeasurement>& pose)
  {
    if (!pose)
      return;
    geometry_msgs::PoseStamped message;
    message.header.stamp = ros::Time(pose->t);
    message.header.frame_id = "map";
    message.pose.position.x = pose->position.value().x();
    message.pose.position.y = pose->position.value().y();
    message.pose.position.z = pose->position.value().z();
    message.pose.orientation.w = 1.0;
    to.publish(message);
  }
  void setClock()
  {
    rosgraph_msgs::Clock now;
    now.clock = ros::Time(time_);
    clock_.publish(now);
  }
  // Lets the node make its cycle. @return false if nothing was heard of it.
  bool step()
  {
    const long words = words_;
    setClock();
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(2.0);
    while (ros::WallTime::now() < end)
    {
      ros::spinOnce();
      if (words_ > words && std::abs(state_.header.stamp.toSec() - time_) < 1e-3)
        return true;
      ros::WallDuration(0.0005).sleep();
    }
    return false;
  }
  void resetNode()
  {
    ros::WallDuration(1.1).sleep();
    std_srvs::Trigger reset;
    EXPECT_TRUE(ros::service::call(ns_ + "tether_monitor/reset", reset) && reset.response.success);
  }

  ros::NodeHandle nh_;
  std::string ns_;
  monitor::Config config_;
  monitor::TowedTruth tow_;
  ros::Publisher clock_, vessel_, vehicle_;
  ros::Subscriber state_sub_, word_sub_;
  TetherState state_;
  bool over_tension_ = true;
  long words_ = 0;
  double begin_, time_;  // [s]
};
}  // namespace

TEST(InputFaults, AreNeverBelievedForLongWhileTracked)
{
  Campaign campaign("tracked", monitor::VehicleMode::TRACKED, 1000.0);
  for (const Subject body : {Subject::VESSEL, Subject::VEHICLE})
    for (int k = 0; k < static_cast<int>(PoseFault::COUNT); ++k)
      campaign.run(body, static_cast<PoseFault>(k));
}

TEST(InputFaults, AreNeverBelievedForLongWhileFree)
{
  Campaign campaign("free", monitor::VehicleMode::FREE, 2.2e9);  // in 2039: no signed seconds any more
  for (int k = 0; k < static_cast<int>(PoseFault::COUNT); ++k)
    campaign.run(Subject::VESSEL, static_cast<PoseFault>(k));
}

}  // namespace tether_monitor
