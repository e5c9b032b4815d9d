#include "tether_monitor/monitor/measurements/motion_plausibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tether_monitor::monitor
{
namespace
{
using Verdict = MotionPlausibility::Verdict;

// Poses that go through the check into the track, as TrackedBody does it.
struct Checked
{
  Verdict add(double t, const core::Vector3& position)
  {
    const Verdict verdict = plausibility.check(t, position, track);
    if (verdict == Verdict::REACQUIRED)
      track.clear();
    if (verdict != Verdict::DOUBTFUL)
      track.addPose(t, position, Eigen::Quaterniond::Identity());
    return verdict;
  }
  MotionBuffer track;
  MotionPlausibility plausibility;
};

core::Vector3 swell(double t, double period, double height)
{
  const double w = 2.0 * M_PI / period;
  return {3.0 * t, 0.5 * height * std::sin(w * t), height * std::cos(w * t)};
}
}  // namespace

TEST(MotionPlausibility, ASwellIsNoLeapAtAnyRate)
{
  for (const double dt : {0.01, 0.05, 0.2, 1.0})
    for (const double noise : {0.0, 0.02, 0.3})
    {
      Checked body;
      std::mt19937 generator(1);
      std::normal_distribution<double> normal;
      int doubtful = 0;
      for (int i = 0; i * dt < 120.0; ++i)
      {
        core::Vector3 p = swell(i * dt, 7.0, 2.0);
        for (int k = 0; k < 3; ++k)
          p[k] += noise * normal(generator);
        doubtful += body.add(i * dt, p) != Verdict::GOOD;
      }
      EXPECT_LE(doubtful, noise > 0.0 ? 3 : 0) << dt << " s, " << noise << " m";
    }
}

TEST(MotionPlausibility, AnOutlierIsLeftOutAndAPlaceThatLastsBelieved)
{
  Checked body;
  for (int i = 0; i < 100; ++i)
    ASSERT_EQ(body.add(0.05 * i, swell(0.05 * i, 7.0, 2.0)), Verdict::GOOD);
  const core::Vector3 away(0.0, 5.0, 0.0);
  EXPECT_EQ(body.add(5.0, swell(5.0, 7.0, 2.0) + away), Verdict::DOUBTFUL);
  EXPECT_EQ(body.add(5.05, swell(5.05, 7.0, 2.0)), Verdict::GOOD);
  EXPECT_EQ(body.plausibility.last(Implausibility::LEAP), 5.0);
  EXPECT_LT(body.plausibility.last(Implausibility::RELOCATION), 0.0);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(body.add(5.1 + 0.05 * i, swell(5.1 + 0.05 * i, 7.0, 2.0) + away), Verdict::DOUBTFUL);
  EXPECT_EQ(body.add(5.25, swell(5.25, 7.0, 2.0) + away), Verdict::REACQUIRED);
  EXPECT_EQ(body.plausibility.last(Implausibility::RELOCATION), 5.25);
}

TEST(MotionPlausibility, ARepeatedPositionIsFrozenOnlyAfterMotion)
{
  Checked moored, stopped;
  for (int i = 0; i < 100; ++i)
  {
    moored.add(0.1 * i, {1.0, 2.0, 3.0});
    stopped.add(0.1 * i, {std::min(0.1 * i, 5.0) * 0.5, 0.0, 0.0});
  }
  EXPECT_LT(moored.plausibility.last(Implausibility::FROZEN_POSITION), 0.0);
  EXPECT_NEAR(stopped.plausibility.last(Implausibility::FROZEN_POSITION), 9.9, 1e-9);
}

TEST(MotionPlausibility, AVelocityInOtherAxesIsNamed)
{
  // Heading north east, 2 m/s ahead.
  const Eigen::Quaterniond heading(Eigen::AngleAxisd(0.8, core::Vector3::UnitZ()));
  const core::Vector3 ahead(2.0, 0.0, 0.0), velocity = heading * ahead;
  const auto findings = [&](const core::Vector3& measured)
  {
    Checked body;
    for (int i = 0; i < 100; ++i)
    {
      body.add(0.05 * i, 0.05 * i * velocity);
      body.plausibility.compareVelocity(0.05 * i, body.track.at(0.05 * i).position, 0.0, measured, heading);
    }
    return body.plausibility;
  };
  EXPECT_TRUE(findings(velocity).trustsVelocity());
  const MotionPlausibility world = findings(heading * velocity);  // a world velocity that was taken for the body's
  EXPECT_FALSE(world.trustsVelocity());
  EXPECT_GT(world.last(Implausibility::VELOCITY_IN_WORLD_AXES), 0.0);
  const MotionPlausibility child = findings(ahead);  // a body's that was taken for the world's
  EXPECT_GT(child.last(Implausibility::VELOCITY_IN_BODY_AXES), 0.0);
  const MotionPlausibility zero = findings(core::Vector3::Zero());
  EXPECT_GT(zero.last(Implausibility::CONTRADICTORY_VELOCITY), 0.0);
}

TEST(MotionPlausibility, AVelocityThatLeapsIsNotTakenForALeapOfThePosition)
{
  Checked body;
  const core::Vector3 velocity(2.0, 0.0, 0.0);
  int doubtful = 0;
  for (int i = 0; i < 200; ++i)
  {
    const double t = 0.1 * i;
    doubtful += body.add(t, t * velocity) != Verdict::GOOD;
    if (!body.plausibility.trustsVelocity())
      body.track.clearRates();
    const core::Vector3 measured = velocity + core::Vector3(0.0, t < 10.0 ? 0.0 : 3.0, 0.0);
    body.plausibility.compareVelocity(t, body.track.at(t).position, 0.0, measured, Eigen::Quaterniond::Identity());
    if (body.plausibility.trustsVelocity())
      body.track.addTwist(t, measured, core::Vector3::Zero());
  }
  EXPECT_EQ(doubtful, 0);
  EXPECT_FALSE(body.plausibility.trustsVelocity());
  EXPECT_GT(body.plausibility.last(Implausibility::CONTRADICTORY_VELOCITY), 15.0);
}

// What came late comes in bursts, one topic after the other: for a while the positions are a second ahead of the
// velocities, or behind them.
TEST(MotionPlausibility, ABurstOfOneTopicBeforeTheOtherIsNoContradiction)
{
  for (const bool positions_first : {true, false})
  {
    Checked body;
    const double w = 2.0 * M_PI / 7.0;
    int doubtful = 0;
    const auto addPosition = [&](double t) { doubtful += body.add(t, swell(t, 7.0, 2.0)) != Verdict::GOOD; };
    const auto addVelocity = [&](double t)
    {
      const core::Vector3 velocity(3.0, w * std::cos(w * t), -2.0 * w * std::sin(w * t));
      body.plausibility.compareVelocity(t, body.track.at(t).position, body.track.extrapolation(t), velocity,
                                        Eigen::Quaterniond::Identity());
      body.track.addTwist(t, velocity, core::Vector3::Zero());
    };
    for (int i = 0; i < 2400;)
    {
      const int count = i % 200 == 100 ? 20 : 1;
      for (int k = 0; k < count; ++k)
        positions_first ? addPosition(0.05 * (i + k)) : i > 0 ? addVelocity(0.05 * (i + k)) : void();
      for (int k = 0; k < count; ++k)
        positions_first ? addVelocity(0.05 * (i + k)) : addPosition(0.05 * (i + k));
      i += count;
    }
    EXPECT_EQ(doubtful, 0) << positions_first;
    EXPECT_LT(body.plausibility.last(Implausibility::CONTRADICTORY_VELOCITY), 0.0) << positions_first;
  }
}

}  // namespace tether_monitor::monitor
