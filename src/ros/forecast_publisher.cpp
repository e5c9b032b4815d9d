#include "tether_monitor/ros/forecast_publisher.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tether_monitor/ros/geometry_conversions.h"

namespace tether_monitor
{
namespace
{
constexpr int OUTPUT_QUEUE = 10;
constexpr int SERVICE_THREADS = 1;
constexpr double LONGEST_VALID = 15.0;             // of what a forecast says [s]
constexpr double LONGEST_DRAWN = 5.0;              // [s]
constexpr double SHORTEST = 1.0, LONGEST = 300.0;  // horizons that can be asked for [s]
constexpr double LARGEST_SPEED = 50.0, LARGEST_TURN = 1.0, LARGEST_PAYOUT = 20.0;  // [m/s, rad/s, m/s]

bool isGiven(const geometry_msgs::Vector3& v)
{
  return !std::isnan(v.x) && !std::isnan(v.y) && !std::isnan(v.z);
}

core::Vector3 vectorOf(const geometry_msgs::Vector3& v)
{
  return {v.x, v.y, v.z};
}

// Why the request makes no sense; empty: it does.
std::string problemOf(const WhatIf::Request& request)
{
  const auto beyond = [](double x, double most) { return !std::isnan(x) && !(std::abs(x) <= most); };
  if (isGiven(request.vessel_velocity) && !(vectorOf(request.vessel_velocity).norm() <= LARGEST_SPEED))
    return "vessel_velocity is faster than any vessel";
  if (beyond(request.turn_rate, LARGEST_TURN))
    return "turn_rate is beyond 1 rad/s";
  if (beyond(request.payout_rate, LARGEST_PAYOUT))
    return "payout_rate is beyond 20 m/s";
  if (isGiven(request.thrust.force) && !(vectorOf(request.thrust.force).allFinite()))
    return "thrust is not finite";
  if (request.seconds > LONGEST || request.seconds < 0.0)
    return "seconds must be 0 to 300";
  return "";
}

monitor::ForecastActions actionsOf(const WhatIf::Request& request)
{
  monitor::ForecastActions actions;
  if (isGiven(request.vessel_velocity))
    actions.vessel.velocity = vectorOf(request.vessel_velocity);
  if (!std::isnan(request.turn_rate))
    actions.vessel.turn_rate = request.turn_rate;
  if (!std::isnan(request.payout_rate))
    actions.payout_rate = request.payout_rate;
  if (isGiven(request.thrust.force))
  {
    actions.thrust.emplace();
    actions.thrust->force = vectorOf(request.thrust.force);
    if (isGiven(request.thrust.torque))
      actions.thrust->torque = vectorOf(request.thrust.torque);
  }
  return actions;
}
}  // namespace

TetherForecast toMessage(const std_msgs::Header& header, const monitor::TetherForecast& f)
{
  TetherForecast m;
  m.header = header;
  m.time = f.time;
  m.max_tension = f.max_tension;
  m.max_tension_p05 = f.max_tension_p05;
  m.max_tension_p95 = f.max_tension_p95;
  m.vessel_tension = f.vessel_tension;
  m.vehicle_tension = f.vehicle_tension;
  m.min_tension = f.min_tension;
  m.horizon = f.horizon;
  m.probability_over_tension = f.probability_over_tension;
  m.probability_breaking = f.probability_breaking;
  m.probability_slack = f.probability_slack;
  m.time_to_warning = f.time_to_warning;
  m.time_to_limit = f.time_to_limit;
  m.time_to_slack = f.time_to_slack;
  m.time_to_limit_p05 = f.time_to_limit_p05;
  m.place_s = f.place_s;
  for (const core::Vector3& station : f.position)
    m.position.push_back(pointMessage(station));
  m.members = static_cast<std::uint8_t>(std::min(f.members, 255));
  m.from_plan = f.from_plan;
  m.computing_time = f.computing_time;
  m.recommended_vessel_speed = f.recommended_vessel_speed;
  m.recommended_payout_rate = f.recommended_payout_rate;
  return m;
}

ForecastPublisher::ForecastPublisher(const ros::NodeHandle& private_nh, const monitor::Config& config)
  : frame_(config.world_frame),
    horizon_(config.forecast.horizon),
    nh_(private_nh),
    thread_(config, [this](const monitor::TetherForecast& forecast) { publish(forecast); }),
    spinner_(SERVICE_THREADS, &queue_)
{
  nh_.setCallbackQueue(&queue_);
  publisher_ = nh_.advertise<TetherForecast>("forecast", OUTPUT_QUEUE);
  service_ = nh_.advertiseService("what_if", &ForecastPublisher::answer, this);
  spinner_.start();
}

ForecastPublisher::~ForecastPublisher()
{
  spinner_.stop();
}

std_msgs::Header ForecastPublisher::headerOf(double t) const
{
  const std::lock_guard<PriorityMutex> lock(mutex_);
  std_msgs::Header header;
  header.stamp = time_.stamp(t);
  header.frame_id = frame_;
  return header;
}

double ForecastPublisher::probability(double t) const
{
  const std::lock_guard<PriorityMutex> lock(mutex_);
  const bool is_of_now = t >= probability_t_ && t - probability_t_ < LONGEST_VALID;
  return is_of_now ? probability_ : std::nan("");
}

std::vector<core::Vector3> ForecastPublisher::position(const ros::Time& stamp) const
{
  const std::lock_guard<PriorityMutex> lock(mutex_);
  const double age = secondsBetween(stamp, time_.stamp(probability_t_));
  return age >= 0.0 && age < LONGEST_DRAWN ? position_ : std::vector<core::Vector3>();
}

void ForecastPublisher::publish(const monitor::TetherForecast& forecast)
{
  {
    const std::lock_guard<PriorityMutex> lock(mutex_);
    probability_t_ = forecast.t;
    position_ = forecast.position;
    probability_ = forecast.members > 0 ? forecast.probability_over_tension : std::nan("");
  }
  if (publisher_)
    publisher_.publish(toMessage(headerOf(forecast.t), forecast));
}

// Where there is no estimate there is no forecast, and that is said as often.
void ForecastPublisher::offer(const monitor::TetherEstimator& estimator, const TimeOrigin& time)
{
  const double t = estimator.estimate().time;
  if (!thread_.isDue(t))
    return;
  std::optional<monitor::ForecastStart> start = estimator.forecastStart();
  ForecastThread::Start shared;
  if (start)
    shared = std::make_shared<const monitor::ForecastStart>(std::move(*start));
  {
    const std::lock_guard<PriorityMutex> lock(mutex_);
    time_ = time;
    latest_ = shared;
  }
  if (shared)
    return thread_.submit(shared);
  if (t - last_empty_ < thread_.budget().interval() && t >= last_empty_)
    return;
  last_empty_ = t;
  monitor::TetherForecast none;
  none.t = t;
  publish(none);
}

bool ForecastPublisher::answer(WhatIf::Request& request, WhatIf::Response& response)
{
  ForecastThread::Start start;
  {
    const std::lock_guard<PriorityMutex> lock(mutex_);
    start = latest_;
  }
  response.message = problemOf(request);
  if (response.message.empty() && !start)
    response.message = "there is no valid estimate to begin with, or monitor.forecast.rate is 0";
  response.success = response.message.empty();
  if (!response.success)
    return true;
  const double horizon = request.seconds >= SHORTEST ? request.seconds : horizon_;
  const monitor::TetherForecast forecast = thread_.whatIf(start, horizon, actionsOf(request));
  response.forecast = toMessage(headerOf(forecast.t), forecast);
  response.success = forecast.members > 0;
  if (!response.success)
    response.message = "too many members could not be stepped";
  return true;
}

}  // namespace tether_monitor
