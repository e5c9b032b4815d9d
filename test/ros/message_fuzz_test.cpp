// Typed extremes on every topic, transforms included, beside good poses: the node lives, keeps its pace, and what
// it says is a number or INVALID.
#include <geometry_msgs/TwistStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <nav_msgs/Odometry.h>
#include <std_msgs/Float64.h>
#include <std_msgs/String.h>
#include <tether_monitor/CurrentProfile.h>
#include <tether_monitor/ObstacleArray.h>
#include <tether_monitor/Payout.h>
#include <tf2_msgs/TFMessage.h>

#include <fstream>
#include <limits>
#include <random>

#include "common/main.h"
#include "common/ros_test_bench.h"

namespace tether_monitor
{
namespace
{
class Extremes
{
 public:
  double number()
  {
    static const double pool[] = {0.0,  NAN, INFINITY, -INFINITY, 1e300, -1e300, 1e-300, 4294967296.0,
                                  -1.0, 1e6, -1e6,     0.5,       100.0, 1e9,    -1e9,   1e-9};
    return pool[generator_() % 16];
  }
  std_msgs::Header header()
  {
    static const std::string frames[] = {"map", "map", "map", "", "base_link", "nowhere", std::string(10000, 'x'),
                                         "/map"};
    const ros::Time now = ros::Time::now();
    const ros::Time stamps[] = {now,
                                now,
                                now,
                                ros::Time(),
                                ros::Time(1, 0),
                                ros::Time(2147483653u, 0),
                                ros::Time(4294967295u, 999999999),
                                now + ros::Duration(0.4)};
    std_msgs::Header h;
    h.frame_id = frames[generator_() % 8];
    h.stamp = stamps[generator_() % 8];
    return h;
  }
  std::size_t size()
  {
    static const std::size_t pool[] = {0, 1, 2, 7, 300, 5000, 100000, 1};
    return pool[generator_() % 8];
  }
  bool often() { return generator_() % 4 != 0; }
  template <typename V>
  void fill(V& v)
  {
    v.x = number();
    v.y = number();
    v.z = number();
  }
  void fill(geometry_msgs::Quaternion& q)
  {
    q.w = often() ? 1.0 : number();
    q.x = often() ? 0.0 : number();
  }
  geometry_msgs::PoseStamped pose()
  {
    geometry_msgs::PoseStamped m;
    m.header = header();
    fill(m.pose.position);
    fill(m.pose.orientation);
    return m;
  }
  geometry_msgs::TwistStamped twist()
  {
    geometry_msgs::TwistStamped m;
    m.header = header();
    fill(m.twist.linear);
    fill(m.twist.angular);
    return m;
  }
  nav_msgs::Odometry odometry()
  {
    nav_msgs::Odometry m;
    m.header = header();
    fill(m.pose.pose.position);
    fill(m.pose.pose.orientation);
    fill(m.twist.twist.linear);
    for (double& c : m.pose.covariance)
      c = often() ? 0.0 : number();
    for (double& c : m.twist.covariance)
      c = often() ? 0.0 : number();
    return m;
  }
  Payout payout()
  {
    Payout m;
    m.header = header();
    m.length = often() ? 90.0 : number();
    m.rate = often() ? 0.0 : number();
    return m;
  }
  CurrentProfile current()
  {
    CurrentProfile m;
    m.header = header();
    m.depth.resize(size());
    m.velocity.resize(often() ? m.depth.size() : size());
    for (std::size_t i = 0; i < m.depth.size(); ++i)
      m.depth[i] = often() ? static_cast<double>(i) : number();
    return m;
  }
  ObstacleArray obstacles()
  {
    ObstacleArray m;
    m.header = header();
    m.obstacles.resize(std::min<std::size_t>(size(), 20000));
    for (Obstacle& o : m.obstacles)
    {
      o.shape = generator_() % 5;
      o.size.assign(often() ? o.shape + 1 : 7, often() ? 1.0 : number());
      fill(o.pose.position);
      o.pose.orientation.w = 1.0;
      o.mass = often() ? 0.0 : number();
      o.friction = often() ? 0.0 : number();
    }
    return m;
  }
  geometry_msgs::WrenchStamped thrust()
  {
    geometry_msgs::WrenchStamped m;
    m.header = header();
    fill(m.wrench.force);
    return m;
  }
  std_msgs::Float64 scalar()
  {
    std_msgs::Float64 m;
    m.data = number();
    return m;
  }
  tf2_msgs::TFMessage transforms()
  {
    tf2_msgs::TFMessage m;
    m.transforms.resize(1 + generator_() % 3);
    for (geometry_msgs::TransformStamped& t : m.transforms)
    {
      t.header = header();
      t.child_frame_id = often() ? "site" + std::to_string(generator_() % 5) : t.header.frame_id;
      fill(t.transform.translation);
      fill(t.transform.rotation);
    }
    return m;
  }
  std::size_t pick(std::size_t n) { return generator_() % n; }

 private:
  std::mt19937 generator_{20};
};

long residentKilobytes(const std::string& process)
{
  FILE* pipe = popen(("ps -C " + process + " -o rss= | sort -n | tail -1").c_str(), "r");
  long kilobytes = 0;
  if (!pipe || std::fscanf(pipe, "%ld", &kilobytes) != 1)
    kilobytes = 0;
  if (pipe)
    pclose(pipe);
  return kilobytes;
}

struct Watched
{
  ros::WallTime last;
  double longest_gap = 0.0, longest_step = 0.0;
  long states = 0, lies = 0;
  TetherState state;

  void onState(const TetherState& s)
  {
    const ros::WallTime now = ros::WallTime::now();
    if (states > 0)
      longest_gap = std::max(longest_gap, (now - last).toSec());
    last = now;
    ++states;
    longest_step = std::max(longest_step, s.step_time);
    const bool has_numbers = std::isfinite(s.vessel_tension) && std::isfinite(s.max_tension) && !s.s.empty();
    const bool should_be_empty = s.status == TetherState::STATUS_INVALID || s.status == TetherState::STATUS_STOWED;
    if (has_numbers == should_be_empty)
      ++lies;
    state = s;
  }
};
}  // namespace

TEST(MessageFuzz, TheNodeOutlivesEveryExtreme)
{
  ros::NodeHandle nh;
  const double duration = ros::NodeHandle("~").param("duration", 15.0);
  const std::string ns = "/rov1/";
  Watched watched;
  const ros::Subscriber states = nh.subscribe<TetherState>(
      ns + "tether_monitor/state", 100, [&](const TetherState::ConstPtr& s) { watched.onState(*s); });
  std::vector<ros::Publisher> out;
  std::vector<std::function<void()>> send;
  Extremes extremes;
  const auto offer = [&](auto make, const std::string& topic)
  {
    using Message = decltype(make());
    out.push_back(nh.advertise<Message>(topic[0] == '/' ? topic : ns + topic, 20));
    send.push_back([publisher = out.back(), make] { publisher.publish(make()); });
  };
  for (const char* body : {"vessel", "vehicle"})
  {
    offer([&] { return extremes.pose(); }, std::string(body) + "/pose");
    offer([&] { return extremes.twist(); }, std::string(body) + "/velocity");
    offer([&] { return extremes.odometry(); }, std::string(body) + "/odom");
  }
  offer([&] { return extremes.payout(); }, "payout");
  offer([&] { return extremes.current(); }, "current");
  offer([&] { return extremes.obstacles(); }, "obstacles");
  offer([&] { return extremes.thrust(); }, "vehicle/thrust");
  offer([&] { return extremes.scalar(); }, "seabed");
  offer([&] { return extremes.scalar(); }, "turns");
  offer([&] { return extremes.transforms(); }, "/tf");
  offer([&] { return extremes.transforms(); }, "/tf_static");

  const auto goodPoses = [&]
  {
    geometry_msgs::PoseStamped pose;
    pose.header.stamp = ros::Time::now();
    pose.header.frame_id = "map";
    pose.pose.orientation.w = 1.0;
    pose.pose.position.z = 1.0;
    out[0].publish(pose);
    pose.pose.position.x = 60.0;
    pose.pose.position.z = -70.0;
    out[3].publish(pose);
  };
  const auto run = [&](double seconds, bool with_extremes)
  {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
    for (int i = 0; ros::ok() && ros::WallTime::now() < end; ++i)
    {
      if (i % 10 == 0)
        goodPoses();
      if (with_extremes)
        send[extremes.pick(send.size())]();
      ros::spinOnce();
      ros::WallDuration(0.005).sleep();
    }
  };
  run(5.0, false);
  ASSERT_GT(watched.states, 0);
  ASSERT_EQ(watched.state.status, TetherState::STATUS_OK);
  const long memory_before = residentKilobytes("tether_monitor_node");
  run(duration, true);
  const long memory_after = residentKilobytes("tether_monitor_node");
  std::printf("longest gap between states %.3f s, longest cycle %.1f ms, memory %ld to %ld kB, %ld states\n",
              watched.longest_gap, 1e3 * watched.longest_step, memory_before, memory_after, watched.states);
  EXPECT_EQ(watched.lies, 0) << "numbers while INVALID, or none while not";
  EXPECT_LT(watched.longest_gap, 5.0) << "silence is a fault, lateness on a busy machine is none";
  EXPECT_LT(memory_after, memory_before + 100000);

  // Afterwards all is as before; what was said of the sea and of the length stays.
  const long before = watched.states;
  run(8.0, false);
  EXPECT_GT(watched.states, before + 50);
}

}  // namespace tether_monitor
