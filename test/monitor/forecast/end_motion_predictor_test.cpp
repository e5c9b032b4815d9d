#include "tether_monitor/monitor/forecast/end_motion_predictor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tether_monitor::monitor
{
namespace
{
constexpr double STEP = 0.2;

template <class Way>
EndMotionPredictor watch(const Way& way, double until)
{
  EndMotionPredictor predictor;
  for (double t = 0.0; t <= until + 1e-9; t += 0.05)
    predictor.observe(t, way(t));
  return predictor;
}

// Mean and standard deviation of where many courses are after some time.
struct Spread
{
  core::Vector3 mean = core::Vector3::Zero(), stddev = core::Vector3::Zero();
};

Spread after(const EndMotionPredictor& predictor, const core::EndMotion& now, double time,
             const MotionCommand& command = MotionCommand())
{
  constexpr int COURSES = 400;
  const EndMotionSampler sampler(predictor, now, STEP, command);
  RandomNumbers random(3);
  core::Vector3 sum = core::Vector3::Zero(), square = core::Vector3::Zero();
  for (int i = 0; i < COURSES; ++i)
  {
    EndMotionSampler::Course course = sampler.begin(random);
    core::EndMotion end;
    for (int k = 0; k < std::lround(time / STEP); ++k)
      end = sampler.advance(course, random);
    sum += end.position;
    square += end.position.cwiseAbs2();
  }
  Spread s;
  s.mean = sum / COURSES;
  s.stddev = (square / COURSES - s.mean.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
  return s;
}

core::EndMotion heaving(double t)
{
  constexpr double W = 0.8;
  return {{1.5 * t, 0.0, std::sin(W * t)}, {1.5, 0.0, W * std::cos(W * t)}};
}

core::EndMotion turning(double t)
{
  constexpr double R = 100.0, W = 0.015;
  return {R * core::Vector3(std::sin(W * t), 1.0 - std::cos(W * t), 0.0),
          R * W * core::Vector3(std::cos(W * t), std::sin(W * t), 0.0)};
}
}  // namespace

TEST(EndMotionPredictor, AStraightCourseGoesOnAndItsUncertaintyGrows)
{
  const EndMotionPredictor predictor = watch(heaving, 120.0);
  const core::EndMotion now = heaving(120.0);
  const Spread early = after(predictor, now, 5.0), late = after(predictor, now, 30.0);
  EXPECT_NEAR(late.mean.x(), now.position.x() + 45.0, 3.0);
  EXPECT_GT(late.stddev.x(), 2.0 * early.stddev.x());
  EXPECT_LT(late.stddev.x(), 10.0);
}

// Half a period on the phase is still known, after many the waves are as high as they were.
TEST(EndMotionPredictor, WavesGoOnAndLoseTheirPhase)
{
  const EndMotionPredictor predictor = watch(heaving, 120.0);
  const core::EndMotion now = heaving(120.0);
  const Spread soon = after(predictor, now, 4.0), late = after(predictor, now, 60.0);
  EXPECT_NEAR(soon.mean.z(), heaving(124.0).position.z(), 0.3);
  EXPECT_LT(soon.stddev.z(), 0.5);
  EXPECT_NEAR(late.stddev.z(), std::sqrt(0.5), 0.25);
}

TEST(EndMotionPredictor, ATurnGoesOn)
{
  const EndMotionPredictor predictor = watch(turning, 120.0);
  const Spread s = after(predictor, turning(120.0), 30.0);
  const core::Vector3 straight = turning(120.0).position + 30.0 * turning(120.0).velocity;
  EXPECT_LT((s.mean - turning(150.0).position).norm(), 4.0);
  EXPECT_GT((straight - turning(150.0).position).norm(), 9.0);
}

TEST(EndMotionPredictor, DoesWhatItIsCommanded)
{
  const EndMotionPredictor predictor = watch(heaving, 120.0);
  const core::EndMotion now = heaving(120.0);
  MotionCommand stop;
  stop.velocity = core::Vector3::Zero();
  EXPECT_NEAR(after(predictor, now, 30.0, stop).mean.x(), now.position.x() + 1.5 * 4.0, 3.0);
  MotionCommand left;
  left.turn_rate = 0.05;
  const Spread s = after(predictor, now, 30.0, left);
  EXPECT_NEAR(s.mean.y(), 1.5 / 0.05 * (1.0 - std::cos(1.5)), 3.0);
}

// The first step starts where the end is, however wrong the filter may be.
TEST(EndMotionPredictor, NothingJumpsAtTheBeginning)
{
  const EndMotionPredictor predictor = watch(heaving, 60.0);
  core::EndMotion now = heaving(60.0);
  now.position += core::Vector3(0.3, -0.2, 0.1);
  const EndMotionSampler sampler(predictor, now, STEP);
  RandomNumbers random(3);
  for (int i = 0; i < 50; ++i)
  {
    EndMotionSampler::Course course = sampler.begin(random);
    const core::EndMotion next = sampler.advance(course, random);
    EXPECT_LT((next.position - now.position - STEP * now.velocity).norm(), 0.05);
    EXPECT_LT((next.velocity - now.velocity).norm(), 0.5);
  }
}

TEST(EndMotionPredictor, BeginsAnewAfterAClockThatWentBack)
{
  EndMotionPredictor predictor = watch(heaving, 60.0);
  predictor.observe(10.0, turning(10.0));
  EXPECT_NEAR(predictor.time(), 10.0, 1e-12);
  EXPECT_NEAR(predictor.axis(0).mean()[0] + predictor.axis(0).mean()[5], turning(10.0).position.x(), 0.5);
}
}  // namespace tether_monitor::monitor
