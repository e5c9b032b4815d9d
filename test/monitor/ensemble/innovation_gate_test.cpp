#include "tether_monitor/monitor/ensemble/innovation_gate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tether_monitor/core/base/binary_archive.h"

namespace tether_monitor::monitor
{
using core::Vector3;
using Verdict = InnovationGate::Verdict;

namespace
{
constexpr double STDDEV = 0.3;

// Evaluates a position `offset` from where it is predicted at time t.
Verdict evaluate(InnovationGate& gate, double t, const Vector3& offset, const Vector3& predicted = Vector3::Zero())
{
  const VehicleMeasurement fix{t, VehicleMeasurement::Kind::POSITION,
                               MeasuredVector::withStddev(predicted + offset, Vector3::Constant(STDDEV))};
  return gate.evaluate(fix, offset, 1.1 * STDDEV * STDDEV * core::Matrix3::Identity(), core::Matrix3::Zero());
}

// A gate that has believed a minute of good positions.
InnovationGate trusting()
{
  InnovationGate gate;
  gate.start(0.0, 0.0);
  for (int t = 1; t <= 60; ++t)
    evaluate(gate, t, Vector3::Zero());
  return gate;
}
}  // namespace

TEST(InnovationGate, RefusesOutliersAndNotWhatIsGood)
{
  InnovationGate gate;
  gate.start(0.0, 0.0);
  std::mt19937 generator(3);
  std::normal_distribution<double> normal(0.0, STDDEV);
  int t = 1;
  for (; t <= 200; ++t)
    evaluate(
        gate, t,
        t % 20 == 0 ? Vector3(8.0, -5.0, 3.0) : Vector3(normal(generator), normal(generator), normal(generator)));
  EXPECT_NEAR(gate.report().refused, 10, 2);
  EXPECT_EQ(gate.report().accepted + gate.report().refused, 200);
  EXPECT_EQ(gate.report().reacquired, 0);
  EXPECT_NEAR(gate.report().noise_scale, 1.0, 0.3);
  EXPECT_FALSE(gate.isInconsistent(t));
}

TEST(InnovationGate, GivesWayAfterAGapAndStaysInQuestionOtherwise)
{
  InnovationGate gate = trusting(), other = gate;
  Verdict verdict = Verdict::REJECT;
  for (int t = 160; t < 165; ++t)
    verdict = evaluate(gate, t, Vector3(0.0, 40.0, 0.0));
  EXPECT_EQ(verdict, Verdict::REACQUIRE) << "after a gap";
  EXPECT_FALSE(gate.isInconsistent(165.0));

  int t = 61;
  for (verdict = Verdict::REJECT; verdict == Verdict::REJECT && t < 200; ++t)
  {
    verdict = evaluate(other, t, Vector3(0.0, 40.0, 0.0));
    if (t > 63)
    {
      ASSERT_TRUE(other.isInconsistent(t));
    }
  }
  EXPECT_EQ(verdict, Verdict::RESET);
  EXPECT_GT(t - 61, 25) << "against positions that were good a moment ago";
  for (int k = 0; k < 60; ++k)
    evaluate(other, t + k, Vector3::Constant(0.1 * (k % 2)));
  EXPECT_TRUE(other.isInconsistent(t + 60.0)) << "it stays in question which were right";
}

TEST(InnovationGate, PositionsThatAgreeAreBelievedHoweverTheModelDrifts)
{
  InnovationGate gate;
  gate.start(0.0, 0.0);
  Verdict verdict = Verdict::REJECT;
  int t = 1;
  for (; t <= 30 && verdict == Verdict::REJECT; ++t)
  {
    const Vector3 measured(1.5 * t, 0.0, -50.0), predicted(20.0, -4.0 * t, -50.0 + 3.0 * t);
    verdict = evaluate(gate, t, measured - predicted, predicted);
  }
  EXPECT_EQ(verdict, Verdict::REACQUIRE);
  EXPECT_LE(t, 8);
}

TEST(InnovationGate, ADepthThatFitsDoesNotHideALostPlace)
{
  InnovationGate gate;
  gate.start(0.0, 0.0);
  const core::Matrix3 covariance = 1.1 * STDDEV * STDDEV * core::Matrix3::Identity();
  Verdict verdict = Verdict::REJECT;
  int t = 1;
  for (; t <= 30 && verdict == Verdict::REJECT; ++t)
  {
    MeasuredVector place = MeasuredVector::withStddev({0.0, 40.0, 0.0}, Vector3::Constant(STDDEV)), depth = place;
    place.setNotMeasured(2);
    depth.setNotMeasured(0);
    depth.setNotMeasured(1);
    verdict = gate.evaluate({1.0 * t, VehicleMeasurement::Kind::POSITION, place}, {0.0, 40.0, 0.0}, covariance,
                            core::Matrix3::Zero());
    EXPECT_EQ(gate.evaluate({t + 0.5, VehicleMeasurement::Kind::POSITION, depth}, Vector3::Zero(), covariance,
                            core::Matrix3::Zero()),
              Verdict::ACCEPT);
  }
  EXPECT_EQ(verdict, Verdict::REACQUIRE);
  EXPECT_LE(t, 8);
}

TEST(InnovationGate, GoesOnAfterASaveAmongRejections)
{
  InnovationGate gate;
  gate.start(0.0, 0.0);
  for (int t = 1; t <= 3; ++t)
    ASSERT_EQ(evaluate(gate, t, Vector3(0.0, 40.0, 0.0)), Verdict::REJECT);
  core::BinaryWriter writer;
  writer(gate);
  InnovationGate restored;
  core::BinaryReader reader(writer.bytes());
  reader(restored);
  for (int t = 4; t <= 6; ++t)
    EXPECT_EQ(evaluate(restored, t, Vector3(0.0, 40.0, 0.0)), evaluate(gate, t, Vector3(0.0, 40.0, 0.0))) << t;
}

TEST(InnovationGate, JumpsAreNeverFollowed)
{
  InnovationGate gate = trusting();
  for (int t = 61; t < 400; ++t)
    EXPECT_EQ(evaluate(gate, t, 50.0 * Vector3(std::sin(t / 5), std::cos(2 * (t / 5)), 0.0)), Verdict::REJECT);
  EXPECT_EQ(gate.report().reacquired, 0);
}

TEST(InnovationGate, ADriftToOneSideIsNoticed)
{
  InnovationGate gate;
  gate.start(0.0, 0.0);
  for (int t = 1; t <= 60; ++t)
    evaluate(gate, t, Vector3(0.0, 0.0, 0.9));
  EXPECT_TRUE(gate.isInconsistent(60.0));
  EXPECT_GT(gate.noiseVarianceScale(), 1.0);
}

// What the members do not know yet puts all innovations on one side, and contradicts nothing.
TEST(InnovationGate, WhatIsUncertainAndLastsIsNoContradiction)
{
  const core::Matrix3 lasting = 0.9 * core::Matrix3::Identity();
  InnovationGate gate;
  gate.start(0.0, 0.0);
  int t = 1;
  const auto run = [&](double offset)
  {
    for (const int until = t + 60; t < until; ++t)
      gate.evaluate({1.0 * t, VehicleMeasurement::Kind::POSITION,
                     MeasuredVector::withStddev(Vector3::Zero(), Vector3::Constant(STDDEV))},
                    {0.0, 0.0, offset}, lasting + STDDEV * STDDEV * core::Matrix3::Identity(), lasting);
  };
  run(1.5);
  EXPECT_FALSE(gate.isInconsistent(t));
  EXPECT_NEAR(gate.report().normalized_innovation_mean, 1.5 / 0.95, 0.1) << "standard deviations of what lasts";
}

TEST(InnovationGate, ALoadCellThatIsOffForLongMeansThatTheParametersAre)
{
  InnovationGate gate = trusting();
  MeasuredVector reading = MeasuredVector::withStddev({500.0, 0.0, 0.0}, Vector3::Ones());
  reading.setNotMeasured(1);
  reading.setNotMeasured(2);
  int readings = 0;
  for (Verdict verdict = Verdict::REJECT; verdict == Verdict::REJECT && readings < 1000; ++readings)
    verdict = gate.evaluate({61.0 + 0.1 * readings, VehicleMeasurement::Kind::TENSION, reading}, {400.0, 0.0, 0.0},
                            100.0 * core::Matrix3::Identity(), core::Matrix3::Zero());
  EXPECT_NEAR(readings, 60, 1);
}
}  // namespace tether_monitor::monitor
