#include "tether_monitor/monitor/forecast/thrust_reaction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tether_monitor/monitor/forecast/thrust_course.h"

namespace tether_monitor::monitor
{
namespace
{
using core::Vector3;

// x: the stick is held. y: an autopilot that answers with a lag. z: one that answers half.
ThrustReaction watched(double seconds, double pull)
{
  ThrustReaction reaction;
  Vector3 answered = Vector3::Zero();
  const double dt = 0.1;
  for (double t = 0.0; t < seconds; t += dt)
  {
    const Vector3 force = pull * std::sin(0.3 * t) * Vector3(1.0, -0.5, 1.0);
    answered += dt / ThrustReaction::RESPONSE * (force - answered);
    reaction.observe(t, {150.0, -answered.y(), -0.5 * answered.z()}, force);
  }
  return reaction;
}

Vector3 meanAnswer(const ThrustReaction& reaction, const Vector3& more, double most)
{
  RandomNumbers random(3);
  Vector3 sum = Vector3::Zero();
  const int count = 200;
  for (int i = 0; i < count; ++i)
  {
    ThrustCourse course(reaction, reaction.tetherForce(), {150.0, 0.0, 0.0}, most, random);
    Vector3 answer = Vector3::Zero();
    for (int k = 0; k < 100; ++k)
      answer = course.advance(0.2, reaction.tetherForce() + reaction.lag() + more);
    sum += answer;
  }
  return sum / count;
}
}  // namespace

TEST(ThrustReaction, TellsAStickFromAnAutopilot)
{
  const ThrustReaction reaction = watched(60.0, 300.0);
  ASSERT_TRUE(reaction.isReady());
  EXPECT_TRUE(reaction.isValid());
  EXPECT_NEAR(reaction.share().mean.x(), 0.0, 0.05);
  EXPECT_NEAR(reaction.share().mean.y(), 1.0, 0.1);
  EXPECT_NEAR(reaction.share().mean.z(), 0.5, 0.1);
  EXPECT_LT(reaction.share().stddev.maxCoeff(), 0.15);
  EXPECT_NEAR(reaction.largestThrust(), 235.0, 40.0);
}

TEST(ThrustReaction, KnowsNothingOfATetherThatDoesNotPull)
{
  const ThrustReaction reaction = watched(60.0, 1.0);
  EXPECT_NEAR(reaction.share().mean.y(), 0.5, 0.05);
  EXPECT_NEAR(reaction.share().stddev.y(), std::sqrt(1.0 / 12.0), 0.01);
}

TEST(ThrustReaction, BeginsAnewAfterAGap)
{
  ThrustReaction reaction = watched(60.0, 300.0);
  reaction.observe(200.0, Vector3::Zero(), Vector3::Zero());
  EXPECT_FALSE(reaction.isReady());
  EXPECT_EQ(reaction.largestThrust(), 0.0);
}

TEST(ThrustCourse, AnswersWithWhatTheVehicleHas)
{
  const ThrustReaction reaction = watched(60.0, 300.0);
  const Vector3 answer = meanAnswer(reaction, {100.0, 200.0, 0.0}, 1e4);
  EXPECT_NEAR(answer.x(), 0.0, 10.0);
  EXPECT_NEAR(answer.y(), -200.0, 30.0);
  const Vector3 least = meanAnswer(reaction, {0.0, 2000.0, 0.0}, 300.0);
  EXPECT_LT((least + Vector3(150.0, 0.0, 0.0)).norm(), 300.1) << "no more than it has";
  EXPECT_LT(least.y(), -250.0);
}

}  // namespace tether_monitor::monitor
