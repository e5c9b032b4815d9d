#include "tether_monitor/monitor/measurements/measurement_history.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::monitor
{
VehicleMeasurement fixAt(double t, double x = 0.0)
{
  return {t, VehicleMeasurement::Kind::POSITION,
          MeasuredVector::withStddev({x, t, 0.0}, core::Vector3::Constant(0.5))};
}

TEST(MeasurementHistory, KeepsTheOrderOfTime)
{
  MeasurementHistory history;
  for (const double t : {3.0, 1.0, 2.0})
    EXPECT_EQ(history.add(fixAt(t), 0.0), Rejection::NONE);
  ASSERT_EQ(history.fixes().size(), 3u);
  EXPECT_EQ(history.fixes()[1].t, 2.0);
  EXPECT_EQ(history.earliestUnprocessed(), 1.0);
  EXPECT_EQ(history.add(fixAt(2.0), 0.0), Rejection::REPEATED);
  EXPECT_EQ(history.add(fixAt(0.5), 0.6), Rejection::TOO_LATE);
}

TEST(MeasurementHistory, ChecksWithoutATrace)
{
  MeasurementHistory history;
  VehicleMeasurement frozen = fixAt(1.0);
  for (int i = 0; i < 10; ++i)
    EXPECT_EQ(history.check(frozen, 0.0), Rejection::NONE);
  EXPECT_TRUE(history.fixes().empty());
  const MeasuredVector value = frozen.value;
  for (const double t : {1.0, 2.0, 3.0, 4.0})
  {
    frozen.t = t;
    frozen.value = value;
    EXPECT_EQ(history.add(frozen, 0.0), t < 2.5 ? Rejection::NONE : Rejection::FROZEN) << t;
  }
}

TEST(MeasurementHistory, ADepthAndAPlaceOfOneMomentAreTwoMeasurements)
{
  MeasurementHistory history;
  VehicleMeasurement place = fixAt(1.0), depth = fixAt(1.0);
  place.value.setNotMeasured(2);
  depth.value.setNotMeasured(0);
  depth.value.setNotMeasured(1);
  EXPECT_EQ(history.add(place, 0.0), Rejection::NONE);
  EXPECT_EQ(history.add(depth, 0.0), Rejection::NONE);
  EXPECT_EQ(history.add(depth, 0.0), Rejection::REPEATED);
  for (const double t : {2.0, 3.0, 4.0, 5.0})
  {
    depth.t = t;
    EXPECT_EQ(history.add(depth, 0.0), Rejection::NONE) << "a depth to the centimetre is not frozen";
  }
}

TEST(MeasurementHistory, TwoSourcesMayMeasureAtOneMoment)
{
  MeasurementHistory history;
  VehicleMeasurement depth = fixAt(1.0);
  depth.value.setNotMeasured(0);
  depth.value.setNotMeasured(1);
  EXPECT_EQ(history.add(depth, 0.0), Rejection::NONE);
  EXPECT_EQ(history.add(fixAt(1.0), 0.0), Rejection::NONE) << "a place with a depth of its own";
  EXPECT_EQ(history.add(fixAt(1.0, 0.3), 0.0), Rejection::NONE) << "another source";
  EXPECT_EQ(history.add(fixAt(1.0, 0.3), 0.0), Rejection::REPEATED);
  EXPECT_EQ(history.add(depth, 0.0), Rejection::REPEATED);
}

TEST(MeasurementHistory, WhatWasNotMeasuredHasALargeVariance)
{
  VehicleMeasurement height = fixAt(1.0);
  height.value.setNotMeasured(0);
  EXPECT_FALSE(height.measuresPosition(0));
  EXPECT_TRUE(std::isinf(height.stddev()[0]));
  EXPECT_EQ(height.noise()(0, 0), 1e12);
  EXPECT_EQ(height.noise()(1, 1), 0.25);
}

TEST(MeasurementHistory, RefusesWhatIsNoMeasurement)
{
  MeasurementHistory history;
  EXPECT_EQ(history.add(fixAt(NAN), 0.0), Rejection::NOT_FINITE);
  EXPECT_EQ(history.add(fixAt(1.0, INFINITY), 0.0), Rejection::NOT_FINITE);
  VehicleMeasurement none = fixAt(1.0);
  none.value = MeasuredVector::withStddev(core::Vector3::Zero(), core::Vector3::Zero());
  EXPECT_EQ(history.add(none, 0.0), Rejection::NOT_FINITE);
}

}  // namespace tether_monitor::monitor
