#include "tether_monitor/monitor/vessel/vessel_motion_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace tether_monitor::monitor
{
namespace
{
using core::Vector3;

// @param stddev  NaN: not told.
MeasuredVector positionOf(const Vector3& position, const Vector3& stddev)
{
  return stddev.array().isNaN().any() ? MeasuredVector(position) : MeasuredVector::withStddev(position, stddev);
}

// What a heave sensor measures.
MeasuredVector heightOf(double z, double stddev)
{
  MeasuredVector height = positionOf({0.0, 0.0, z}, Vector3::Constant(stddev));
  height.setNotMeasured(0);
  height.setNotMeasured(1);
  return height;
}

// A vessel under track in waves, with satellites at 5 Hz and a heave sensor at 20 Hz.
struct Passage
{
  explicit Passage(double wave_period = 8.0, unsigned seed = 1) : w(2.0 * M_PI / wave_period), generator(seed) {}

  core::EndMotion at(double t) const
  {
    return {{3.0 * t, 0.3 * std::sin(w * t), 2.0 + std::sin(w * t)},
            {3.0, 0.3 * w * std::cos(w * t), w * std::cos(w * t)}};
  }
  double noise(double stddev) { return stddev * normal(generator); }

  double w;
  std::mt19937 generator;
  std::normal_distribution<double> normal;
};

// The same in an irregular sea, significant height 1.6 m, as the stern feels it: short waves too.
struct IrregularPassage : Passage
{
  struct Component
  {
    double amplitude, frequency, phase;
  };

  IrregularPassage()
  {
    constexpr double PEAK = 2.0 * M_PI / 8.0, STEP = 0.04;
    std::uniform_real_distribution<double> phase(0.0, 2.0 * M_PI);
    double variance = 0.0;
    for (double f = 0.6 * PEAK; f < 2.8 * PEAK; f += STEP)
    {
      // Pierson and Moskowitz's spectrum about its peak.
      const double density = std::pow(PEAK / f, 5) * std::exp(-1.25 * std::pow(PEAK / f, 4));
      components.push_back(
          {std::sqrt(2.0 * density * STEP), f + 0.3 * STEP * std::sin(37.0 * f), phase(generator)});
      variance += density * STEP;
    }
    for (Component& c : components)
      c.amplitude *= 0.4 / std::sqrt(variance);
  }

  core::EndMotion at(double t) const
  {
    core::EndMotion end{{1.5 * t, 0.0, 2.0}, {1.5, 0.0, 0.0}};
    for (const auto& [a, f, phase] : components)
    {
      end.position +=
          a * Vector3(0.5 * std::cos(f * t + phase), 0.3 * std::cos(f * t + phase), std::sin(f * t + phase));
      end.velocity +=
          a * f * Vector3(-0.5 * std::sin(f * t + phase), -0.3 * std::sin(f * t + phase), std::cos(f * t + phase));
    }
    return end;
  }

  std::vector<Component> components;
};

struct Errors
{
  double place = 0.0, speed = 0.0, jump = 0.0, expected = 0.0;
};

template <class P>
Errors sail(P& passage, double stddev_told, VesselMotionFilter& filter)
{
  Errors e;
  core::EndMotion last;
  int n = 0;
  for (int i = 0; i < 4000; ++i)
  {
    const double t = 0.05 * i;
    const core::EndMotion truth = passage.at(t);
    if (i % 4 == 0)
      filter.addPosition(
          t, positionOf(truth.position + Vector3(passage.noise(0.02), passage.noise(0.02), passage.noise(0.02)),
                        Vector3::Constant(stddev_told)));
    filter.addPosition(t,
                       heightOf(truth.position.z() + passage.noise(0.03), stddev_told > 0.0 ? 0.03 : stddev_told));
    const VesselMotionFilter::Motion m = filter.blend(t);
    if (t > 60.0)
    {
      e.place += std::pow(m.end.position.z() - truth.position.z(), 2);
      e.speed += std::pow(m.end.velocity.z() - truth.velocity.z(), 2);
      e.expected += std::pow(m.position_stddev.z(), 2);
      e.jump = std::max(e.jump, std::abs(m.end.velocity.z() - last.velocity.z()) / 0.05);
      ++n;
    }
    last = m.end;
  }
  return {std::sqrt(e.place / n), std::sqrt(e.speed / n), e.jump, std::sqrt(e.expected / n)};
}
}  // namespace

TEST(VesselMotionFilter, SmoothsWavesOfAnyUsualPeriod)
{
  for (const double period : {5.0, 8.0, 12.0, 16.0})
  {
    Passage passage(period);
    VesselMotionFilter filter;
    const Errors e = sail(passage, 0.02, filter);
    EXPECT_LT(e.place, 0.025) << period;
    EXPECT_LT(e.speed, 0.06) << period;
    EXPECT_LT(e.jump, 1.5 * passage.w * passage.w + 0.1) << period << ": no shocks";
    EXPECT_NEAR(filter.axis(2).waveFrequency(), passage.w, 0.15 * passage.w);
    EXPECT_NEAR(filter.axis(2).waveStddev(), std::sqrt(0.5), 0.15);
    EXPECT_NEAR(e.expected, e.place, 0.7 * e.place) << period << ": it knows how good it is";
  }
}

TEST(VesselMotionFilter, FollowsAnIrregularSeaAndKnowsHowWell)
{
  IrregularPassage passage;
  VesselMotionFilter filter;
  const Errors e = sail(passage, 0.02, filter);
  EXPECT_LT(e.place, 0.04) << "of 0.4 m, measured to 0.03 m";
  EXPECT_LT(e.place, 1.4 * e.expected);
  EXPECT_GT(e.place, 0.5 * e.expected);
}

TEST(VesselMotionFilter, FindsOutHowMuchPositionsScatter)
{
  Passage told(8.0), unspecified(8.0);
  VesselMotionFilter a, b;
  const double known = sail(told, 0.02, a).place, found = sail(unspecified, std::nan(""), b).place;
  EXPECT_LT(found, 1.5 * known);
}

TEST(VesselMotionFilter, LateMeasurementsTakeTheirPlace)
{
  Passage passage;
  VesselMotionFilter in_order, shuffled;
  for (int i = 0; i < 600; i += 2)
  {
    const Vector3 a = passage.at(0.1 * i).position + Vector3::Constant(passage.noise(0.02));
    const Vector3 b = passage.at(0.1 * i + 0.1).position + Vector3::Constant(passage.noise(0.02));
    const Vector3 stddev = Vector3::Constant(0.02);
    EXPECT_EQ(in_order.addPosition(0.1 * i, positionOf(a, stddev)), Rejection::NONE);
    EXPECT_EQ(in_order.addPosition(0.1 * i + 0.1, positionOf(b, stddev)), Rejection::NONE);
    EXPECT_EQ(shuffled.addPosition(0.1 * i + 0.1, positionOf(b, stddev)), Rejection::NONE);
    const Rejection late = shuffled.addPosition(0.1 * i, positionOf(a, stddev));
    if (i > 16)
    {
      EXPECT_EQ(late, Rejection::NONE) << i;
    }
  }
  EXPECT_LT((in_order.at(60.0).end.position - shuffled.at(60.0).end.position).norm(), 1e-3);
  EXPECT_EQ(shuffled.addPosition(1.0, positionOf(Vector3::Zero(), Vector3::Constant(0.02))), Rejection::TOO_LATE)
      << "far too late";
  EXPECT_EQ(shuffled.addPosition(59.9, positionOf(passage.at(59.9).position, Vector3::Constant(0.02))),
            Rejection::NONE);
  EXPECT_EQ(shuffled.addPosition(59.9, positionOf(passage.at(59.9).position, Vector3::Constant(0.02))),
            Rejection::REPEATED)
      << "twice";
}

TEST(VesselMotionFilter, AMeasurementStampedAheadCountsAtItsOwnTime)
{
  VesselMotionFilter on_time, ahead;
  const auto at = [](double t) { return positionOf({3.0 * t, 0.0, 2.0}, Vector3::Constant(0.01)); };
  for (int i = 0; i < 400; ++i)
  {
    const double t = 0.0625 * i;
    on_time.addPosition(t, at(t));
    if (i == 0)
      ahead.addPosition(0.0, at(0.0));
    ahead.addPosition(t + 0.0625, at(t + 0.0625));
    if (t < 10.0)
      continue;
    EXPECT_NEAR(ahead.at(t).end.position.x(), 3.0 * t, 0.005) << t;
    EXPECT_EQ(ahead.at(t).end.position, on_time.at(t).end.position) << t;
    EXPECT_EQ(ahead.blend(t).end.velocity, on_time.blend(t).end.velocity) << t;
    EXPECT_EQ(ahead.age(t), 0.0);
  }
}

TEST(VesselMotionFilter, AnOutlierIsLeftOutAndALeapBelievedInTheEnd)
{
  VesselMotionFilter filter;
  const Vector3 stddev = Vector3::Constant(0.05);
  double t = 0.0;
  for (; t < 30.0; t += 0.2)
    filter.addPosition(t, positionOf(Vector3::Zero(), stddev));
  filter.addPosition(t, positionOf(Vector3(30.0, 0.0, 0.0), stddev));
  EXPECT_LT(filter.at(t).end.position.norm(), 0.1);
  EXPECT_EQ(filter.outliers(), 1);
  for (int i = 0; i < 10; ++i)
    filter.addPosition(t += 0.2, positionOf(Vector3(30.0, 0.0, 0.0), stddev));
  EXPECT_NEAR(filter.at(t).end.position.x(), 30.0, 0.5);
}

TEST(VesselMotionFilter, KnowsWhenItIsReadyAndHowOldItIs)
{
  VesselMotionFilter filter;
  EXPECT_FALSE(filter.hasPosition());
  EXPECT_TRUE(std::isinf(filter.age(0.0)));
  for (double t = 0.0; t < 4.0; t += 0.05)
    filter.addPosition(t, heightOf(1.0, 0.03));
  EXPECT_FALSE(filter.hasPosition()) << "a heave sensor alone is no position";
  for (double t = 4.0; t < 20.0; t += 0.2)
    filter.addPosition(t, positionOf({0.0, 0.0, 1.0}, Vector3::Constant(0.02)));
  EXPECT_TRUE(filter.isReady(20.0));
  for (double t = 20.0; t < 25.0; t += 0.05)
    filter.addPosition(t, heightOf(1.0, 0.03));
  EXPECT_NEAR(filter.age(25.0), 5.1, 0.15) << "heave goes on, the position has stopped";
  EXPECT_GT(filter.at(25.0).position_stddev.x(), filter.at(25.0).position_stddev.z());
  EXPECT_EQ(filter.estimateTrack(25.0).velocity.z(), 0.0);
}

TEST(VesselMotionFilter, TheWavesRiseFromTheWayWithoutAnExcursion)
{
  Passage passage(9.0);
  VesselMotionFilter filter;
  core::EndMotion begun;
  double t = 0.0, most = 0.0, last = 0.0, doubt = 0.0, jump = 0.0;
  Vector3 velocity = Vector3::Zero();
  for (int i = 0; t < 60.0; ++i, t = 0.05 * i)
  {
    const core::EndMotion truth = passage.at(t);
    if (i % 4 == 0)
      filter.addPosition(
          t, positionOf(truth.position + Vector3(passage.noise(0.02), passage.noise(0.02), passage.noise(0.02)),
                        Vector3::Constant(0.02)));
    if (t < 12.0)
      continue;
    if (begun.position.isZero())
    {
      begun = filter.estimateTrack(t);
      filter.startBlending(t, begun);
      velocity = begun.velocity;
      EXPECT_LT((begun.velocity - Vector3(3.0, 0.0, 0.0)).norm(), 0.1);
    }
    const VesselMotionFilter::Motion m = filter.blend(t);
    const double error = (m.end.position - truth.position).norm();
    jump = std::max(jump, (m.end.velocity - velocity).norm() / 0.05);
    velocity = m.end.velocity;
    most = std::max(most, error);
    doubt = t < 16.0 ? std::max(doubt, m.position_stddev.z()) : doubt;
    last = t > 40.0 ? std::max(last, error) : last;
  }
  EXPECT_LT(most, 1.3) << "never farther off than the waves are high";
  EXPECT_GT(doubt, 0.5) << "what is left out of the waves is known to be missing";
  EXPECT_LT(last, 0.15);
  EXPECT_LT(jump, 4.0 * passage.w * passage.w) << "while the filter learns what the waves are like";
}

TEST(VesselMotionFilter, IsReadyAsSoonHoweverFastPositionsCome)
{
  for (const double interval : {0.004, 0.01, 0.05, 0.2, 1.0, 4.0})
  {
    Passage passage(8.0);
    VesselMotionFilter filter;
    double ready = 0.0;
    for (int i = 0; ready == 0.0 && i * interval < 30.0; ++i)
    {
      const double t = i * interval;
      const core::EndMotion truth = passage.at(t);
      filter.addPosition(t, positionOf(truth.position, Vector3::Constant(0.02)));
      filter.addVelocity(t, MeasuredVector::withStddev(truth.velocity, Vector3::Constant(0.05)));
      if (filter.isReady(t))
        ready = t;
    }
    ASSERT_GE(ready, 9.5 - 1e-9) << interval;
    EXPECT_LE(ready, 12.0) << interval;
    const core::EndMotion track = filter.estimateTrack(ready);
    EXPECT_NEAR(track.velocity.x(), 3.0, 2.5 * filter.trackVelocityStddev().x()) << interval;
  }
}

TEST(VesselMotionFilter, AfterAGapItLooksAtTheWavesAnew)
{
  for (const double gap : {15.0, 30.0, 90.0})
  {
    Passage passage(8.0);
    VesselMotionFilter filter;
    double ready = 0.0;
    for (int i = 0; ready == 0.0 && i < 1600; ++i)
    {
      const double t = i < 200 ? 0.2 * i : gap + 0.2 * i;
      filter.addPosition(t, positionOf(passage.at(t).position +
                                           Vector3(passage.noise(0.02), passage.noise(0.02), passage.noise(0.02)),
                                       Vector3::Constant(0.02)));
      if (i >= 200 && filter.isReady(t))
        ready = t;
    }
    ASSERT_GT(ready, 0.0) << gap;
    if (gap > 20.0)
    {
      EXPECT_GT(ready, 40.0 + gap + 9.0) << gap;
    }
    EXPECT_LT(ready, 40.0 + gap + 25.0) << gap;
    const core::EndMotion track = filter.estimateTrack(ready);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_LT(std::abs(track.velocity[axis] - (axis == 0 ? 3.0 : 0.0)),
                2.5 * filter.trackVelocityStddev()[axis] + 0.01)
          << gap;
    EXPECT_LT(filter.trackVelocityStddev().norm(), 0.2) << gap;
  }
}

TEST(DifferenceNoiseEstimator, IsTheNoiseAndNotTheMotion)
{
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  DifferenceNoiseEstimator noisy, smooth, uneven;
  EXPECT_EQ(noisy.stddev(), DifferenceNoiseEstimator::UNKNOWN);
  for (int i = 0; i < 400; ++i)
  {
    const double t = 0.2 * i, motion = 3.0 * t + std::sin(0.785 * t);
    noisy.add(t, motion + 0.04 * normal(generator));
    smooth.add(t, motion);
    uneven.add(t * t, motion);
  }
  EXPECT_NEAR(noisy.stddev(), 0.04, 0.008);
  EXPECT_LT(smooth.stddev(), 0.001);
  EXPECT_GE(uneven.stddev(), DifferenceNoiseEstimator::LEAST);
  noisy.add(1e4, std::nan(""));
  noisy.add(0.0, 1.0);
  EXPECT_TRUE(std::isfinite(noisy.stddev()));
}
}  // namespace tether_monitor::monitor
