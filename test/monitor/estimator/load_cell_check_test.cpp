#include "tether_monitor/monitor/estimator/load_cell_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/navigation_fixture.h"

namespace tether_monitor::monitor
{
// A vessel that drifts off at 0.3 m/s from a vehicle that stays. The load cell hangs from a tether of its own.
class Drift
{
 public:
  Drift() : monitor_(testConfig()), truth_(testConfig()) { run(20.0); }

  // From now on the truth is a tether of the first `elements` of 20 elements, held where it is there.
  void snag(int elements)
  {
    Config piece = testConfig();
    piece.elements = elements;
    piece.tether.length = 5.0 * elements;
    truth_end_ = truth_.estimate().stations.position[2 * elements];
    truth_ = TetherEstimator(piece);
  }

  void run(double duration, double scale = 1.0, double offset = 0.0, double frozen = TetherEstimate::NONE)
  {
    for (int k = 0; k < std::lround(duration / 0.05); ++k)
    {
      t_ += 0.05;
      const core::Vector3 vessel(-drift_ * (t_ - drift_since_), 0.0, 1.0), vehicle(60.0, 0.0, -70.0);
      feed(monitor_, vessel, vehicle);
      feed(truth_, vessel, std::isnan(truth_end_.x()) ? vehicle : truth_end_);
      truth_.tick(t_);
      const double tension = truth_.estimate().vessel_tension;
      const double reading = std::isnan(frozen) ? scale * tension + offset + 1e-3 * std::sin(7.0 * t_) : frozen;
      if (k % 2 == 0 && std::isfinite(reading))
      {
        EXPECT_EQ(monitor_.addTension(t_, reading), Rejection::NONE);
      }
      monitor_.tick(t_);
    }
  }

  void drift(double speed)
  {
    drift_ = speed;
    drift_since_ = t_;
  }
  // Runs until a cause is found. @return how long it took [s].
  double untilCause(double most)
  {
    for (double t = 0.0; t < most; t += 0.5)
    {
      run(0.5);
      if (cell().cause() != MismatchCause::NONE)
        return t + 0.5;
    }
    return INFINITY;
  }
  const LoadCellCheck& cell() const { return monitor_.alarmInputs().loadCell(); }
  const TetherEstimator& monitor() const { return monitor_; }

 private:
  void feed(TetherEstimator& estimator, const core::Vector3& vessel, const core::Vector3& vehicle) const
  {
    const Eigen::Quaterniond level = Eigen::Quaterniond::Identity();
    const double speed = t_ > drift_since_ ? -drift_ : 0.0;
    estimator.addVessel(PoseMeasurement{t_, vessel, level},
                        TwistMeasurement{t_, core::Vector3(speed, 0.0, 0.0), core::Vector3(0.0, 0.0, 0.0)});
    estimator.addVehicle(PoseMeasurement{t_, vehicle, level},
                         TwistMeasurement{t_, core::Vector3(0.0, 0.0, 0.0), core::Vector3(0.0, 0.0, 0.0)});
  }

  TetherEstimator monitor_, truth_;
  core::Vector3 truth_end_ = core::Vector3::Constant(TetherEstimate::NONE);
  double t_ = 100.0, drift_ = 0.0, drift_since_ = 100.0;
};

const Alarm& mismatch(const TetherEstimator& estimator)
{
  for (const Alarm& alarm : estimator.alarms().alarms())
    if (alarm.definition().name == "mismatch")
      return alarm;
  throw std::out_of_range("mismatch");
}

TEST(LoadCellCheck, AgreesWithATetherThatIsAsConfigured)
{
  Drift drift;
  EXPECT_LT(drift.cell().mismatch(), 0.1);
  drift.drift(0.3);
  drift.run(10.0);
  EXPECT_LT(drift.cell().mismatch(), 0.1);
  EXPECT_EQ(drift.cell().cause(), MismatchCause::NONE);
  EXPECT_EQ(mismatch(drift.monitor()).state(), AlarmState::NORMAL);
}

TEST(LoadCellCheck, FindsASnagAndItsPlace)
{
  for (const int elements : {6, 10, 16})
  {
    Drift drift;
    drift.snag(elements);
    drift.run(2.0);
    EXPECT_LT(drift.cell().mismatch(), 1.0) << "held where it lies, it pulls as before";
    drift.drift(0.5);
    const double tension_before = drift.cell().residual().measured;
    drift.untilCause(30.0);
    ASSERT_EQ(drift.cell().cause(), MismatchCause::SNAG) << elements;
    drift.run(0.5);
    const SnagPlace& place = drift.monitor().alarmInputs().snag();
    std::cout << "held at " << 5 * elements << " m, found " << place.s << ", " << place.nearest << " to "
              << place.farthest << "\n";
    EXPECT_LE(place.nearest, 5.0 * elements);
    EXPECT_GE(place.farthest, 5.0 * elements);
    EXPECT_NEAR(place.s, 5.0 * elements, 15.0)
        << "measured " << drift.cell().residual().measured << ", before " << tension_before;
    EXPECT_TRUE(mismatch(drift.monitor()).isActive());
    EXPECT_EQ(mismatch(drift.monitor()).s(), place.s);
  }
}

// A tow in an irregular sea, two hours. The truth is not quite what is configured, and the cell is noisy.
TEST(LoadCellCheck, FindsNoSnagInTwoHoursOfAnIrregularSea)
{
  Config config = coarseConfig();
  config.tether.working_load = 3000.0;
  Config real = config;
  real.tether.drag_normal *= 1.2;
  real.tether.mass_per_length *= 1.02;
  real.tether.length *= 1.004;
  TetherEstimator monitor(config), truth(real);
  unsigned noise = 1;
  long readings = 0, mismatches = 0, snags = 0;
  for (long k = 0; k < 2 * 3600 * 10; ++k)
  {
    const double t = 100.0 + 0.1 * static_cast<double>(k);
    double z = 1.0, vz = 0.0;
    for (int wave = 0; wave < 12; ++wave)
    {
      const double w = 0.5 + 0.083 * wave, phase = w * t + 1.7 * wave * wave, amplitude = 0.3;
      z += amplitude * std::sin(phase);
      vz += amplitude * w * std::cos(phase);
    }
    const core::Vector3 way(1.5 * (t - 100.0), 0.0, 0.0), speed(1.5, 0.0, 0.0), still(0.0, 0.0, 0.0);
    const Eigen::Quaterniond level = Eigen::Quaterniond::Identity();
    for (TetherEstimator* estimator : {&truth, &monitor})
    {
      estimator->addVessel(PoseMeasurement{t, core::Vector3(way.x(), 0.0, z), level},
                           TwistMeasurement{t, core::Vector3(1.5, 0.0, vz), still});
      estimator->addVehicle(PoseMeasurement{t, core::Vector3(way.x() - 70.0, 0.0, -55.0), level},
                            TwistMeasurement{t, speed, still});
    }
    truth.tick(t);
    noise = noise * 1664525u + 1013904223u;
    const double tension = truth.estimate().vessel_tension * (1.0 + 0.04 * (noise / 4294967296.0 - 0.5));
    if (std::isfinite(tension))
      monitor.addTension(t, tension);
    monitor.tick(t);
    const LoadCellCheck& cell = monitor.alarmInputs().loadCell();
    readings += !std::isnan(cell.mismatch());
    mismatches += mismatch(monitor).isActive();
    snags += cell.cause() == MismatchCause::SNAG;
  }
  EXPECT_GT(readings, 70000);
  EXPECT_EQ(snags, 0);
  EXPECT_EQ(mismatches, 0);
}

// In mode observed, against the ensemble's own prediction: the cell pulls ever harder while the vehicle stays.
TEST(LoadCellCheck, FindsASnagInModeObservedWithinFiveSeconds)
{
  NavigationFixture sea;
  sea.run(20.0);
  const auto pull = [&](double extra)
  {
    sea.estimator.addTension(sea.t,
                             sea.estimator.estimate().vessel_tension * (1.0 + 0.01 * sea.noise().x()) + extra);
    sea.run(0.1);
  };
  for (int k = 0; k < 600; ++k)
  {
    pull(0.0);
    ASSERT_EQ(sea.estimator.alarmInputs().loadCell().cause(), MismatchCause::NONE) << "at " << sea.t;
  }
  const double caught = sea.t;
  while (sea.t < caught + 10.0 && !mismatch(sea.estimator).isActive())
    pull(200.0 * (sea.t - caught));
  std::cout << "found after " << sea.t - caught << " s\n";
  EXPECT_LT(sea.t - caught, 5.0);
  EXPECT_EQ(sea.estimator.alarmInputs().loadCell().cause(), MismatchCause::SNAG);
}

TEST(LoadCellCheck, AnOffsetThatCameSlowlyOrStandsStillIsTheSensors)
{
  Drift offset;
  offset.run(20.0, 1.0, -400.0);
  EXPECT_GT(offset.cell().mismatch(), 4.0);
  EXPECT_NE(offset.cell().cause(), MismatchCause::SNAG) << "less than predicted";
  Drift frozen;
  frozen.run(10.0, 1.0, 0.0, 900.0);
  EXPECT_EQ(frozen.cell().cause(), MismatchCause::SENSOR);
}

TEST(LoadCellCheck, IsUnknownWithoutReadings)
{
  EstimatorFixture fixture;
  fixture.run(5.0);
  const LoadCellCheck& cell = fixture.estimator.alarmInputs().loadCell();
  EXPECT_TRUE(std::isnan(cell.mismatch()));
  EXPECT_TRUE(cell.isQuiet());
  fixture.estimator.addTension(fixture.t, 1.0e4);
  fixture.run(1.0);
  EXPECT_GT(cell.mismatch(), 4.0);
  fixture.run(3.0);
  EXPECT_TRUE(std::isnan(cell.mismatch())) << "an old reading is none";
}

}  // namespace tether_monitor::monitor
