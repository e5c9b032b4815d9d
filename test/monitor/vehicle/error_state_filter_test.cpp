#include "tether_monitor/monitor/vehicle/error_state_filter.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "support/started_filter.h"

namespace tether_monitor::monitor
{
namespace
{
using core::Matrix3;
using core::Vector3;

// Of a measurement with independent axes.
Matrix3 covarianceOf(const Vector3& stddev)
{
  return stddev.cwiseAbs2().asDiagonal();
}

// A vehicle that obeys the filter's own model, under a force; the nominal one feels what the filter tells it.
struct World
{
  Vector3 truth = Vector3::Zero(), truth_rate = Vector3::Zero(), nominal = Vector3::Zero(),
          nominal_rate = Vector3::Zero();
  TetherLinearization s = springs();

  void move(double dt, const Vector3& force, const Vector3& told)
  {
    const auto go = [&](Vector3& x, Vector3& v, const Vector3& f)
    {
      const int parts = 50;
      for (int i = 0; i < parts; ++i)
      {
        const double h = dt / parts;
        v = (s.mass + h * s.damping + h * h * s.stiffness).inverse() * (s.mass * v + h * (f - s.stiffness * x));
        x += h * v;
      }
    };
    go(truth, truth_rate, force);
    go(nominal, nominal_rate, told);
  }
};
}  // namespace

TEST(VehicleErrorStateFilter, LearnsAForceThroughTheTether)
{
  World world;
  VehicleErrorStateFilter filter = started();
  std::mt19937 generator(1);
  std::normal_distribution<double> normal(0.0, 0.3);
  const Vector3 force(0.0, 150.0, -60.0);
  const Matrix3 covariance = covarianceOf(Vector3::Constant(0.3));
  for (int k = 1; k <= 300 * 10; ++k)
  {
    world.move(0.1, force, filter.appliedForce());
    filter.predict(0.1, Vector3(-100, 0, 0), 1.0);
    if (k % 10 == 0)
      filter.correctPosition(
          world.truth - world.nominal + Vector3(normal(generator), normal(generator), normal(generator)),
          covariance);
  }
  EXPECT_NEAR(filter.disturbance().y(), 150.0, 3.0 * filter.forceStddev().y());
  EXPECT_NEAR(filter.disturbance().z(), -60.0, 3.0 * filter.forceStddev().z());
  EXPECT_LT(filter.forceStddev().y(), 30.0);
  EXPECT_LT((world.nominal - world.truth).norm(), 0.5) << "the nominal vehicle has come along";
  EXPECT_LT(filter.feedbackForce().norm(), 30.0);
}

TEST(VehicleErrorStateFilter, ADoubtfulStartIsForgottenAndKeptInMindAsLong)
{
  // The force of the start is wrong by 200 N, and the doubt about it is told or not.
  double error[2], early[2], late[2];
  for (const int told : {0, 1})
  {
    World world;
    VehicleErrorStateFilter filter;
    filter.start(ProcessNoiseModel(), 0.01 * Matrix3::Identity(), 0.02, Vector3(0.0, 200.0, 0.0),
                 told * 200.0 * 200.0 * Matrix3::Identity(), Vector3(-100, 0, 0), springs());
    for (int k = 1; k <= 400 * 10; ++k)
    {
      // What the tether still does of itself fades.
      world.move(0.1, Vector3(0.0, 200.0 * std::exp(-0.1 * k / 20.0), 0.0), filter.appliedForce());
      filter.predict(0.1, Vector3(-100, 0, 0), 1.0);
      if (k % 10 == 0)
        filter.correctPosition(world.truth - world.nominal, covarianceOf(Vector3::Constant(0.3)));
      if (k == 200)
      {
        error[told] = filter.disturbance().y() - 200.0 * std::exp(-1.0);
        early[told] = filter.forceStddev().y();
      }
    }
    late[told] = filter.forceStddev().y();
  }
  EXPECT_LT(std::abs(error[1]), 2.0 * early[1]);
  EXPECT_LT(std::abs(error[1]), 0.7 * std::abs(error[0]));
  EXPECT_GT(early[1], 1.5 * early[0]);
  EXPECT_NEAR(late[1], late[0], 0.1 * late[0]);
}

TEST(VehicleErrorStateFilter, CoversWhatItDoesNotKnow)
{
  // Its own model, its own disturbances: squared errors over variances must be one.
  double ratio = 0.0;
  int n = 0;
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    World world;
    VehicleErrorStateFilter filter = started();
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    const ProcessNoiseModel model;
    Vector3 force(0.0, 0.2 * model.force * normal(generator), 0.0);
    world.truth.y() = 0.3 * normal(generator);
    force.y() += 20.0 * world.truth.y();
    world.truth_rate.y() = 0.2 * normal(generator);
    for (int k = 1; k <= 100 * 10; ++k)
    {
      force.y() += model.force_random_walk * std::sqrt(0.1) * normal(generator);
      world.move(0.1, force, filter.appliedForce());
      filter.predict(0.1, Vector3(-100, 0, 0), 1.0);
      if (k % 10 == 0)
        filter.correctPosition(
            world.truth - world.nominal + 0.3 * Vector3(normal(generator), normal(generator), normal(generator)),
            covarianceOf(Vector3::Constant(0.3)));
    }
    const double error = world.truth.y() - world.nominal.y() - filter.positionError().y();
    ratio += error * error / std::pow(filter.positionCovariance().diagonal().cwiseSqrt().y(), 2);
    ++n;
  }
  EXPECT_NEAR(ratio / n, 1.0, 0.5);
}

TEST(VehicleErrorStateFilter, HasNoUseForPositionsAlongATautTether)
{
  VehicleErrorStateFilter taut = started();
  TetherLinearization slack = springs();
  slack.stiffness = 20.0 * Matrix3::Identity();
  slack.damping = 300.0 * Matrix3::Identity();
  VehicleErrorStateFilter loose = started(slack);
  for (VehicleErrorStateFilter* filter : {&taut, &loose})
  {
    filter->predict(1.0, Vector3::Zero(), 1.0);
    filter->correctPosition(Vector3(1.0, 0.0, 0.0), covarianceOf(Vector3::Constant(0.3)));
  }
  EXPECT_LT(taut.positionCovariance().diagonal().cwiseSqrt().x(), 0.3);
  EXPECT_GT(loose.disturbance().x() / loose.positionError().x(), -1e3);
  EXPECT_LT(taut.tensionStddev(springs().vessel), 5000.0 * 0.3) << "less than the position alone would say";
}

TEST(VehicleErrorStateFilter, ThePullIsBoundedHoweverWrongThePosition)
{
  VehicleErrorStateFilter filter = started();
  filter.inflatePositionCovariance(1000.0);
  filter.correctPosition(Vector3(0.0, 500.0, 0.0), covarianceOf(Vector3::Constant(0.3)));
  EXPECT_NEAR(filter.positionError().y(), 500.0, 1.0);
  EXPECT_LE(filter.feedbackForce().norm(), 2.0 * ProcessNoiseModel().force + 1e-6);
}

TEST(VehicleErrorStateFilter, StaysSoundForHours)
{
  VehicleErrorStateFilter filter = started();
  for (int k = 1; k < 36000; ++k)
  {
    filter.predict(0.1, Vector3(-100, 0, 0), k % 1000 == 0 ? 100.0 : 1.0);
    if (k % 3000 > 1500 && k % 10 == 0)
      filter.correctPosition(Vector3::Zero(), covarianceOf(Vector3(0.3, 0.3, 1e6)));
  }
  EXPECT_TRUE(filter.isValid());
  const Eigen::SelfAdjointEigenSolver<VehicleErrorStateFilter::Matrix> eigen(filter.covariance());
  EXPECT_GT(eigen.eigenvalues().minCoeff(), -1e-9 * eigen.eigenvalues().maxCoeff());
}
}  // namespace tether_monitor::monitor
