#include "tether_monitor/monitor/vehicle/innovation_gate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/started_filter.h"

namespace tether_monitor::monitor
{
using core::Vector3;

namespace
{
// Judges a fix `offset` off at time t.
void gate(InnovationGate& gate, VehicleErrorStateFilter& filter, double t, const Vector3& offset)
{
  filter.predict(1.0, Vector3::Zero(), gate.processNoiseScale());
  const VehicleMeasurement fix{t, VehicleMeasurement::Kind::POSITION,
                               MeasuredVector::withStddev(Vector3::Zero(), Vector3::Constant(0.3))};
  gate.evaluate(fix, offset, fix.noise(), filter);
}

// A gate that has believed a minute of good positions.
InnovationGate trusting(VehicleErrorStateFilter& filter)
{
  InnovationGate j;
  j.start(0.0, 0.0);
  for (int t = 1; t <= 60; ++t)
    gate(j, filter, t, Vector3::Zero());
  return j;
}
}  // namespace

TEST(InnovationGate, RefusesOutliersAndNotWhatIsGood)
{
  VehicleErrorStateFilter filter = started();
  InnovationGate j;
  j.start(0.0, 0.0);
  std::mt19937 generator(3);
  std::normal_distribution<double> normal(0.0, 0.3);
  int t = 1;
  for (; t <= 200; ++t)
    gate(j, filter, t,
         t % 20 == 0 ? Vector3(8.0, -5.0, 3.0) : Vector3(normal(generator), normal(generator), normal(generator)));
  EXPECT_NEAR(j.report().refused, 10, 2);
  EXPECT_EQ(j.report().accepted + j.report().refused, 200);
  EXPECT_EQ(j.report().reacquired, 0);
  EXPECT_NEAR(j.report().noise_scale, 1.0, 0.3);
  EXPECT_FALSE(j.isInconsistent(t));
}

TEST(InnovationGate, GivesWayAfterAGapAndStaysInQuestionOtherwise)
{
  VehicleErrorStateFilter filter = started();
  InnovationGate j = trusting(filter);
  VehicleErrorStateFilter other_filter = filter;
  InnovationGate other = j;

  for (int t = 160; t < 165; ++t)
    gate(j, filter, t, Vector3(0.0, 40.0, 0.0));
  EXPECT_EQ(j.report().reacquired, 1) << "after a gap";
  EXPECT_NEAR(filter.positionError().y(), 40.0, 3.0);

  int t = 61;
  for (; other.report().reacquired == 0 && t < 200; ++t)
  {
    gate(other, other_filter, t, Vector3(0.0, 40.0, 0.0));
    if (t > 63)
    {
      ASSERT_TRUE(other.isInconsistent(t));
    }
  }
  EXPECT_GT(t - 61, 25) << "against positions that were good a moment ago";
  for (int k = 0; k < 60; ++k)
    gate(other, other_filter, t + k, Vector3(0.0, 40.0, 0.0) + Vector3::Constant(0.1 * (k % 2)));
  EXPECT_TRUE(other.isInconsistent(t + 60.0));
}

TEST(InnovationGate, JumpsAreNeverFollowed)
{
  VehicleErrorStateFilter filter = started();
  InnovationGate j = trusting(filter);
  for (int t = 61; t < 400; ++t)
    gate(j, filter, t, 50.0 * Vector3(std::sin(t / 5), std::cos(2 * (t / 5)), 0.0));
  EXPECT_EQ(j.report().reacquired, 0);
}

TEST(InnovationGate, ADriftToOneSideMakesItRestless)
{
  VehicleErrorStateFilter filter = started();
  InnovationGate j;
  j.start(0.0, 0.0);
  for (int t = 1; t <= 30; ++t)
    gate(j, filter, t, Vector3(0.0, 0.0, 0.25 * t));
  EXPECT_GT(j.processNoiseScale(), 1.0);
}
}  // namespace tether_monitor::monitor
