#include "tether_monitor/monitor/forecast/winch_reaction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tether_monitor/monitor/forecast/winch_course.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double DT = 0.05;

double waves(double t)
{
  return 0.8 * std::sin(1.05 * t) + 0.5 * std::sin(0.8 * t + 1.0);
}

// A winch that pays out at a rate and follows a share of the waves.
WinchReaction watched(double seconds, double rate, double share)
{
  WinchReaction reaction;
  for (double t = 0.0; t < seconds; t += DT)
    reaction.observe(t, rate + share * waves(t), 0.2 + waves(t));
  return reaction;
}
}  // namespace

TEST(WinchReaction, TellsTheWavesFromTheRate)
{
  for (const double share : {0.0, 0.5, 1.0})
  {
    const WinchReaction reaction = watched(60.0, 0.6, share);
    ASSERT_TRUE(reaction.isReady());
    EXPECT_TRUE(reaction.isValid());
    EXPECT_NEAR(reaction.share(), share, 0.05);
    EXPECT_NEAR(reaction.slowRate(), 0.6, 0.1) << share;
  }
}

TEST(WinchReaction, AWinchThatStopsHasStopped)
{
  WinchReaction reaction = watched(60.0, 0.6, 0.0);
  reaction.observe(60.0, 0.0, 0.2 + waves(60.0));
  EXPECT_NEAR(reaction.slowRate(), 0.0, 0.1);
}

// It works against the tension: what it does has nothing to do with the vessel's motion of the moment.
TEST(WinchReaction, GoesOnAtTheMeanOfWhatItDoesAnyhow)
{
  WinchReaction reaction;
  double least = 1.0, largest = 0.0;
  for (double t = 0.0; t < 120.0; t += DT)
  {
    reaction.observe(t, 0.6 + std::sin(1.3 * t), waves(t));
    if (t < 40.0)
      continue;
    least = std::min(least, reaction.slowRate());
    largest = std::max(largest, reaction.slowRate());
  }
  EXPECT_GT(least, 0.3);
  EXPECT_LT(largest, 0.9);
  EXPECT_LT(reaction.share(), 0.3);
}

TEST(WinchReaction, BeginsAnewAfterAGap)
{
  WinchReaction reaction = watched(60.0, 0.6, 1.0);
  reaction.observe(200.0, 0.0, 0.0);
  EXPECT_FALSE(reaction.isReady());
  EXPECT_EQ(reaction.share(), 0.0);
}

TEST(WinchCourse, FollowsTheWavesThatComeAndGetsToWhatIsWanted)
{
  const WinchReaction reaction = watched(60.0, 0.6, 1.0);
  WinchCourse course(reaction, 1.5, 0.2);
  EXPECT_NEAR(course.usualRate(), 0.6, 0.1);
  EXPECT_NEAR(course.advance(0.01, course.usualRate(), 0.2), 1.5, 0.02) << "begins where it is";
  double now = 0.0;
  for (double t = 0.0; t < 20.0; t += 0.2)
    now = course.advance(0.2, 1.0, 0.2);
  EXPECT_NEAR(now, 1.0, 0.02);
  EXPECT_NEAR(course.advance(0.2, 1.0, 1.2) - now, 1.0, 0.05);
}

TEST(WinchCourse, OneThatWasNotWatchedGoesOn)
{
  WinchCourse course(watched(5.0, 0.6, 1.0), 0.3, 0.0);
  EXPECT_EQ(course.advance(0.2, course.usualRate(), 2.0), 0.3);
}

}  // namespace tether_monitor::monitor
