#include "tether_monitor/monitor/ensemble/motion_error_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tether_monitor::monitor
{
using core::Matrix3;
using core::Vector3;

namespace
{
constexpr double MASS = 600.0, STIFFNESS = 30.0, DAMPING = 60.0;

TetherLinearization spring(double stiffness = STIFFNESS)
{
  TetherLinearization tether;
  tether.mass = MASS * Matrix3::Identity();
  tether.stiffness = stiffness * Matrix3::Identity();
  tether.damping = DAMPING * Matrix3::Identity();
  tether.vessel.position = {stiffness, 0.0, 0.0};
  return tether;
}

MotionErrorFilter started(const UnknownForce& force, double stiffness = STIFFNESS)
{
  MotionErrorFilter filter(2);
  filter.start(force, 0.09 * Matrix3::Identity(), 0.1, 10.0, spring(stiffness));
  return filter;
}
}  // namespace

// A mass on a spring under forces as told, measured with noise as told: errors are what the covariance says.
TEST(MotionErrorFilter, KnowsHowWrongItIs)
{
  UnknownForce force;
  force.slow_stddev = 60.0;
  force.fast_stddev = 40.0;
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  double nees = 0.0, force_nees = 0.0;
  int n = 0;
  for (int run = 0; run < 400; ++run)
  {
    MotionErrorFilter filter = started(force);
    double slow = force.slow_stddev * normal(generator), fast = force.fast_stddev * normal(generator);
    double x = (slow + fast + 10.0 * normal(generator)) / STIFFNESS, v = 0.1 * normal(generator);
    // The start knows the place to 0.3 m.
    const double measured = x + 0.3 * normal(generator);
    const double x0 = measured;
    const double slow_share = 60.0 * 60.0 / (60.0 * 60.0 + 40.0 * 40.0);
    filter.means().row(MotionErrorFilter::SLOW).setConstant(slow_share * STIFFNESS * x0);
    filter.means().row(MotionErrorFilter::FAST).setConstant((1.0 - slow_share) * STIFFNESS * x0);
    for (int i = 1; i <= 1200; ++i)
    {
      constexpr double DT = 0.05;
      const auto walk = [&](double& f, double stddev, double memory)
      {
        const double phi = std::exp(-DT / memory);
        f = phi * f + stddev * std::sqrt(1.0 - phi * phi) * normal(generator);
      };
      walk(fast, force.fast_stddev, force.fast_memory);
      walk(slow, force.slow_stddev, force.slow_memory);
      v += DT * (slow + fast - STIFFNESS * x - DAMPING * v) / MASS;
      x += DT * v;
      MemberVectors applied = MemberVectors::Zero(3, 2);
      applied.row(0).setConstant(STIFFNESS * x0);  // the nominal vehicle is held at x0
      filter.predict(DT, applied);
      if (i % 20 != 0)
        continue;
      MemberVectors innovations(3, 2);
      for (int k = 0; k < 2; ++k)
        innovations.col(k) =
            Vector3(x - x0 + 0.3 * normal(generator), 0.3 * normal(generator), 0.3 * normal(generator)) -
            filter.means().col(k).head<3>();
      filter.correct(MotionErrorFilter::positionJacobian(), innovations, 0.09 * Matrix3::Identity());
    }
    const double error = filter.means()(0, 0) - (x - x0);
    nees += error * error / filter.covariance()(0, 0);
    const double force_error =
        filter.means()(MotionErrorFilter::FAST, 0) + filter.means()(MotionErrorFilter::SLOW, 0) - (slow + fast);
    force_nees += force_error * force_error /
                  (filter.covariance()(6, 6) + filter.covariance()(9, 9) + 2.0 * filter.covariance()(6, 9));
    ++n;
  }
  EXPECT_NEAR(nees / n, 1.0, 0.45);
  EXPECT_NEAR(force_nees / n, 1.0, 0.45);
}

TEST(MotionErrorFilter, AStiffTetherHoldsThePlaceAndTheForceMakesTheTension)
{
  UnknownForce force;
  force.slow_stddev = 100.0;
  force.fast_stddev = 1e-3;
  MotionErrorFilter filter = started(force, 1e4);
  EXPECT_LT(std::sqrt(filter.covariance()(0, 0)), 0.03) << "0.3 m of noise are not believed";
  EXPECT_NEAR(filter.tensionStddev(spring(1e4).vessel), 100.0, 5.0);
}

TEST(MotionErrorFilter, LongCoastingAndStiffSpringsStayFinite)
{
  UnknownForce force;
  force.slow_stddev = 300.0;
  force.fast_stddev = 100.0;
  for (const double stiffness : {0.0, 30.0, 1e6})
  {
    MotionErrorFilter filter = started(force, stiffness);
    for (int i = 0; i < 6000; ++i)
      filter.predict(0.1, MemberVectors::Zero(3, 2));
    EXPECT_TRUE(filter.isValid()) << stiffness;
    EXPECT_GE(filter.covariance().diagonal().minCoeff(), 0.0) << stiffness;
  }
}

TEST(MotionErrorFilter, WhatWasSavedComesBack)
{
  MotionErrorFilter filter = started(UnknownForce());
  MotionErrorFilter::Belief belief;
  filter.save(belief);
  filter.predict(1.0, MemberVectors::Ones(3, 2));
  EXPECT_NE(filter.means(), belief.means);
  filter.restore(belief);
  EXPECT_EQ(filter.means(), belief.means);
  EXPECT_EQ(filter.covariance(), belief.covariance);
}
}  // namespace tether_monitor::monitor
