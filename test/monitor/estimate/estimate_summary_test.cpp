#include "tether_monitor/monitor/estimate/estimate_summary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/tethers.h"

namespace tether_monitor::monitor
{
namespace
{
// Two elements of 200 m; the one that begins at `weak_from` is weaker, and may be bent less.
core::DeployedCable twoElements(double weak_from = 200.0)
{
  core::CableProperties tether = core::towCable(), weak = core::towCable();
  tether.min_bend_radius = 1.0;
  weak.working_load = 1.0e4;
  weak.breaking_load = 1.5e4;
  weak.min_bend_radius = 4.0;
  core::CableLayout layout;
  layout.sections = {{weak_from, weak_from + 200.0, weak}};
  return core::DeployedCable(core::CableModel(tether, 2, core::Environment(), layout));
}

TetherEstimate measured()
{
  TetherEstimate e;
  e.time = 12.0;
  e.status = Status::OK;
  e.reason = Reason::NONE;
  e.has_stations = true;
  e.stations = core::StationProfile(2);
  e.stations.s = {0.0, 100.0, 200.0, 300.0, 400.0};
  e.stations.tension = {9000.0, 7000.0, 6000.0, -50.0, 3000.0};
  e.stations.bend_radius = {50.0, 20.0, 30.0, 40.0, INFINITY};
  e.stations.ends.vessel = {0.0, 3000.0, 4000.0};
  e.stations.ends.vehicle = {0.0, 0.0, -3000.0};
  e.stations.vessel_direction = {0.6, 0.0, -0.8};
  e.stations.vehicle_direction = {0.0, 1.0, 0.0};
  e.vessel_age = 0.5;
  e.payout_age = 2.0;
  return e;
}
}  // namespace

TEST(Summarize, FindsTheExtremesAndWhereTheyAre)
{
  TetherEstimate e = measured();
  summarize(twoElements(), e);
  EXPECT_EQ(e.length, 400.0);
  EXPECT_EQ(e.max_tension, 9000.0);
  EXPECT_EQ(e.max_tension_s, 0.0);
  EXPECT_EQ(e.min_tension, -50.0);
  EXPECT_EQ(e.min_tension_s, 300.0);
  EXPECT_EQ(e.min_bend_radius, 20.0);
  EXPECT_EQ(e.min_bend_radius_s, 100.0);
  EXPECT_EQ(e.vessel_tension, 5000.0);
  EXPECT_EQ(e.vehicle_tension, 3000.0);
  EXPECT_NEAR(e.vessel_end_angle, std::asin(0.8), 1e-14);
  EXPECT_NEAR(e.vehicle_end_angle, 0.0, 1e-14);
}

TEST(Summarize, TheShearOfAStiffTetherLoadsItsEndsAndAPushDoesNot)
{
  TetherEstimate e = measured();
  e.stations.tension = {3000.0, 1000.0, 1000.0, 1000.0, -6000.0};
  e.stations.ends.vehicle = {0.0, 8000.0, 6000.0};
  summarize(twoElements(), e);
  EXPECT_NEAR(e.max_tension, 8000.0, 1e-9);
  EXPECT_EQ(e.max_tension_s, 400.0);
  EXPECT_NEAR(e.breaking_utilisation, 8000.0 / 1.5e4, 1e-12);
  e.stations.ends.vehicle = {0.0, 0.0, 6000.0};
  summarize(twoElements(), e);
  EXPECT_NEAR(e.max_tension, 5000.0, 1e-9) << "3000 N along it and 4000 N across at the vessel end";
}

TEST(Summarize, TheWeakerSectionCountsAtABoundaryOnWhicheverSideItIs)
{
  for (const double weak_from : {200.0, 0.0})
  {
    TetherEstimate e = measured();
    if (weak_from == 0.0)
    {
      std::reverse(e.stations.tension.begin(), e.stations.tension.end());
      std::reverse(e.stations.bend_radius.begin(), e.stations.bend_radius.end());
    }
    summarize(twoElements(weak_from), e);
    EXPECT_DOUBLE_EQ(e.working_utilisation, 0.6) << "6000 of 10000 N, against 9000 of 20000 N";
    EXPECT_EQ(e.working_utilisation_s, 200.0);
    EXPECT_DOUBLE_EQ(e.breaking_utilisation, 0.4);
    EXPECT_DOUBLE_EQ(e.governing_bend_radius, 7.5) << "30 m where 4 m are allowed, as if 1 m were";
    EXPECT_EQ(e.governing_bend_radius_s, 200.0);
  }
}

TEST(ModelRange, NamesWhatLeavesIt)
{
  const core::DeployedCable cable = twoElements();
  TetherEstimate inside = measured();
  summarize(cable, inside);
  inside.stations.strain.assign(5, 0.099);
  inside.stations.max_element_rotation = 1.19;
  EXPECT_EQ(modelRange(cable, inside), Reason::NONE);
  TetherEstimate e = inside;
  e.stations.strain[3] = 0.101;
  EXPECT_EQ(modelRange(cable, e), Reason::OUT_OF_RANGE);
  e = inside;
  e.breaking_utilisation = 1.01;
  EXPECT_EQ(modelRange(cable, e), Reason::OUT_OF_RANGE);
  e = inside;
  e.stations.max_element_rotation = 1.21;
  EXPECT_EQ(modelRange(cable, e), Reason::MESH_COARSE);
  e = inside;
  e.stations.strain[0] = -0.101;
  EXPECT_EQ(modelRange(cable, e), Reason::MESH_COARSE);
}

TEST(Invalidate, TakesTheNumbersAndLeavesTimeAndAges)
{
  TetherEstimate e = measured();
  summarize(twoElements(), e);
  invalidate(Reason::VESSEL_STALE, e);
  EXPECT_EQ(e.status, Status::INVALID);
  EXPECT_EQ(e.reason, Reason::VESSEL_STALE);
  EXPECT_EQ(e.time, 12.0);
  EXPECT_EQ(e.vessel_age, 0.5);
  EXPECT_EQ(e.payout_age, 2.0);
  EXPECT_FALSE(e.has_stations);
  for (const double number : {e.length, e.max_tension, e.vessel_tension, e.working_utilisation, e.min_bend_radius,
                              e.governing_bend_radius, e.vessel_end_angle})
    EXPECT_TRUE(std::isnan(number));
}
}  // namespace tether_monitor::monitor
