#include <tether_monitor/TetherForecast.h>
#include <tether_monitor/WhatIf.h>

#include <cmath>
#include <limits>

#include "common/last_message.h"
#include "common/main.h"
#include "common/ros_test_bench.h"

using namespace tether_monitor;

namespace
{
constexpr double NOT_GIVEN = std::numeric_limits<double>::quiet_NaN();

const std::string FORECAST = "/rov1/tether_monitor/forecast";

WhatIf asItIs()
{
  WhatIf call;
  geometry_msgs::Vector3 none;
  none.x = none.y = none.z = NOT_GIVEN;
  call.request.vessel_velocity = call.request.thrust.force = call.request.thrust.torque = none;
  call.request.turn_rate = call.request.payout_rate = NOT_GIVEN;
  return call;
}

bool ask(WhatIf& call)
{
  return ros::service::call("/rov1/tether_monitor/what_if", call);
}
}  // namespace

TEST(Forecast, ComesBeforeTheAlarm)
{
  RosTestBench scenario;
  LastMessage<TetherForecast> forecasts(FORECAST);
  WhatIf call = asItIs();
  ASSERT_TRUE(ask(call));
  EXPECT_FALSE(call.response.success) << "nothing to begin with";
  EXPECT_NE(call.response.message, "");

  scenario.run(12.0);
  ASSERT_EQ(scenario.state.status, TetherState::STATUS_OK) << "precondition";
  ASSERT_TRUE(scenario.waitFor([&] { return forecasts.count > 0 && forecasts.value.members > 0; }, 10.0));
  EXPECT_EQ(forecasts.value.probability_over_tension, 0.0);
  EXPECT_EQ(forecasts.value.time.size(), forecasts.value.max_tension_p95.size());
  EXPECT_EQ(forecasts.value.horizon, 30.0);
  EXPECT_GT(forecasts.value.computing_time, 0.0);

  EXPECT_TRUE(scenario.diagnosticsSay("members every"));

  // The vehicle drives away until the tether is taut.
  scenario.vehicle_velocity = {0.4, 0.0, -0.25};
  double warned = NOT_GIVEN, expected = NOT_GIVEN;
  const double set_off = scenario.time;
  while (!scenario.over_tension && scenario.time < set_off + 60.0)
  {
    scenario.run(0.05);
    ros::WallDuration(0.03).sleep();  // a forecast takes its time, however fast that passes here
    if (std::isnan(warned) && forecasts.value.probability_over_tension > 0.5)
    {
      warned = scenario.time;
      expected = forecasts.value.header.stamp.toSec() + forecasts.value.time_to_limit;
    }
  }
  ASSERT_TRUE(scenario.over_tension);
  EXPECT_GT(scenario.time - warned, 5.0) << "seconds ahead of the alarm";
  EXPECT_NEAR(expected, scenario.time, 4.0);
}

TEST(Forecast, WhatIfThereWereMoreTether)
{
  RosTestBench scenario;
  LastMessage<TetherForecast> forecasts(FORECAST);
  scenario.run(12.0);
  scenario.vehicle_velocity = {0.4, 0.0, -0.25};
  scenario.run(7.0);
  ASSERT_TRUE(scenario.waitFor([&] { return forecasts.value.probability_over_tension > 0.5; }, 10.0));
  WhatIf as_now = asItIs(), paying_out = asItIs(), foolish = asItIs();
  paying_out.request.payout_rate = 1.0;
  const ros::WallTime began = ros::WallTime::now();
  ASSERT_TRUE(ask(as_now));
  RecordProperty("seconds_to_answer", std::to_string((ros::WallTime::now() - began).toSec()));
  ASSERT_TRUE(as_now.response.success) << as_now.response.message;
  ASSERT_TRUE(ask(paying_out));
  ASSERT_TRUE(paying_out.response.success) << paying_out.response.message;
  EXPECT_GT(as_now.response.forecast.probability_over_tension, 0.5);
  EXPECT_LT(paying_out.response.forecast.probability_over_tension, 0.1);
  foolish.request.payout_rate = 1000.0;
  ASSERT_TRUE(ask(foolish));
  EXPECT_FALSE(foolish.response.success);
}

// A number that is old is none: nothing is forecast from it.
TEST(Forecast, AnInvalidEstimateHasNone)
{
  RosTestBench scenario;
  LastMessage<TetherForecast> forecasts(FORECAST);
  scenario.run(12.0);
  ASSERT_TRUE(scenario.waitFor([&] { return forecasts.value.members > 0; }, 10.0));
  scenario.vehicle_alive = false;
  scenario.run(8.0);
  ASSERT_EQ(scenario.state.status, TetherState::STATUS_INVALID) << "precondition";
  EXPECT_TRUE(scenario.waitFor([&] { return forecasts.value.members == 0; }, 10.0));
  EXPECT_TRUE(forecasts.value.time.empty());
  EXPECT_TRUE(std::isnan(forecasts.value.probability_over_tension));
}
