#include "tether_monitor/replay/csv_replay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "support/estimator_fixture.h"
#include "support/observed_table.h"

namespace tether_monitor::replay
{
namespace
{
// A vehicle that circles slowly, in rows of `dt` seconds.
std::string motionFile(double dt)
{
  const std::string path = ::testing::TempDir() + "tether_monitor_circle.csv";
  std::ofstream out(path);
  out.precision(12);
  out << "t,vessel_x,vessel_y,vessel_z,vehicle_x,vehicle_y,vehicle_z\n";
  for (int i = 0; i * dt <= 20.0 + 1e-9; ++i)
  {
    const double a = 0.1 * i * dt;
    out << i * dt << ",0,0,1," << 60 + 4 * std::cos(a) << "," << 4 * std::sin(a) << ",-60\n";
  }
  return path;
}

files::CsvTable run(double dt, double rate, const std::string& folder)
{
  const Motion motion(files::readCsv(motionFile(dt)));
  monitor::TetherEstimator estimator(monitor::testConfig());
  ResultRecorder recorder(folder, 1.0);
  ReplayOptions options;
  options.rate = rate;
  replayMotion(motion, options, estimator, recorder);
  recorder.finish(estimator);
  // The status column is a word: check it and drop it to read the rest as numbers.
  std::ifstream in(folder + "/ends.csv");
  const std::string numbers = folder + "/ends_numbers.csv";
  std::ofstream out(numbers);
  std::string line;
  while (std::getline(in, line))
  {
    const std::string word = line.substr(line.rfind(',') + 1);
    EXPECT_TRUE(word == "status" || word == "OK") << line;
    out << line.substr(0, line.rfind(',')) << "\n";
  }
  out.close();
  return files::readCsv(numbers);
}
}  // namespace

TEST(ReplayRun, WritesARowForEachRowOfTheMotionAndTheFirstOne)
{
  const std::string folder = ::testing::TempDir() + "tether_monitor_replay";
  std::filesystem::remove_all(folder);
  const files::CsvTable ends = run(0.5, 0.0, folder);
  ASSERT_EQ(ends.rows.size(), 41u);
  EXPECT_EQ(ends.rows[0][0], 0.0);
  EXPECT_EQ(ends.rows[40][0], 20.0);
  EXPECT_EQ(ends.columns[1], "vessel_fx");
  for (const char* file : {"shape.csv", "alarms.csv", "summary.json"})
    EXPECT_TRUE(std::filesystem::exists(folder + "/" + file)) << file;
  const files::CsvTable shape = files::readCsv(folder + "/shape.csv");
  EXPECT_EQ(shape.rows.size(), 21u * 41u);
}

TEST(ReplayRun, TheOutputRateDoesNotChangeTheMotion)
{
  const std::string folder = ::testing::TempDir() + "tether_monitor_replay_rate";
  const files::CsvTable often = run(0.5, 20.0, folder), seldom = run(0.5, 1.0, folder);
  ASSERT_EQ(often.rows.size(), 401u);
  ASSERT_EQ(seldom.rows.size(), 21u);
  for (int column = 1; column <= 6; ++column)
    EXPECT_NEAR(often.rows[400][column], seldom.rows[20][column], 1e-6 * 200.0);
}

TEST(ReplayRun, APartedTetherPullsNoMoreThanItsPiecesWeigh)
{
  const Motion motion(files::readCsv(motionFile(0.5)));
  const Parting parting{10.0, 40.0};
  monitor::TetherEstimator estimator(preparedToPart(monitor::testConfig(), parting));
  ResultRecorder recorder(::testing::TempDir() + "tether_monitor_parting", 1.0);
  ReplayOptions options;
  options.parting = parting;
  replayMotion(motion, options, estimator, recorder);
  const monitor::TetherEstimate& e = estimator.estimate();
  EXPECT_NE(e.status, monitor::Status::INVALID) << describe(e.reason);
  const monitor::Config& c = estimator.config();
  const double weight = 9.81 * (c.tether.mass_per_length - 1025.0 * c.tether.displacedArea());
  EXPECT_LT(e.vessel_tension, 1.5 * 40.0 * weight);
  EXPECT_LT(e.stations.stretched_length, 1.001 * c.tether.length);
  EXPECT_GT((e.stations.position.back() - e.stations.position.front()).norm(), 60.0)
      << "the vehicle is still held";
}

TEST(ReplayRun, APartingThatCannotBeIsRefused)
{
  EXPECT_THROW(preparedToPart(monitor::testConfig(), {1.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(preparedToPart(monitor::testConfig(), {1.0, 1e4}), std::invalid_argument);
  const Motion motion(files::readCsv(motionFile(0.5)));
  ReplayOptions options;
  options.parting = Parting{20.0, 40.0};
  monitor::TetherEstimator estimator(preparedToPart(monitor::testConfig(), *options.parting));
  ResultRecorder recorder(::testing::TempDir() + "tether_monitor_parting", 1.0);
  EXPECT_THROW(replayMotion(motion, options, estimator, recorder), std::runtime_error);
}

TEST(ReplayRun, SaysWhichFilesThereAreAndWhatTheyAreWorth)
{
  const Motion motion(files::readCsv(motionFile(0.5)));
  monitor::TetherEstimator estimator(monitor::testConfig());
  ResultRecorder recorder(::testing::TempDir() + "tether_monitor_worth", 0.0);
  EXPECT_EQ(recorder.shareOf(monitor::Status::OK), 0.0);
  EXPECT_EQ(recorder.statusText(), "");
  replayMotion(motion, {}, estimator, recorder);
  recorder.finish(estimator);
  EXPECT_EQ(recorder.files(), (std::vector<std::string>{"summary.json", "ends.csv", "alarms.csv"}));
  EXPECT_EQ(recorder.shareOf(monitor::Status::OK), 1.0);
  EXPECT_EQ(recorder.statusText(), "OK 100.0 %");
  for (double t = 20.5; t <= 60.0; t += 0.5)
    estimator.tick(t);
  for (int i = 0; i < 41; ++i)
    recorder.writeRow(estimator);
  EXPECT_EQ(recorder.statusText(), "OK 50.0 %, INVALID 50.0 % (NO_INPUT 50.0 %)");
}

TEST(ReplayRun, ARunWithoutAnEstimateLeavesTheResultsOfAnother)
{
  const std::string folder = ::testing::TempDir() + "tether_monitor_kept";
  std::filesystem::remove_all(folder);
  const std::size_t rows = run(0.5, 0.0, folder).rows.size();
  {
    const ResultRecorder recorder(folder, 1.0);
  }
  EXPECT_EQ(files::readCsv(folder + "/ends_numbers.csv").rows.size(), rows);
  EXPECT_GT(std::filesystem::file_size(folder + "/ends.csv"), 1000u);
  EXPECT_GT(std::filesystem::file_size(folder + "/shape.csv"), 1000u);
}

TEST(ReplayRun, AFolderThatCannotBeMadeIsNamed)
{
  const std::string file = ::testing::TempDir() + "tether_monitor_a_file";
  std::ofstream(file) << "x";
  try
  {
    ResultRecorder recorder(file + "/out", 1.0);
    FAIL() << "accepted";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find(file), std::string::npos);
  }
}

namespace
{
monitor::Config observedConfig()
{
  monitor::Config c = monitor::testConfig();
  c.vehicle_mode = monitor::VehicleMode::OBSERVED;
  c.vehicle_body.mass = 400.0;
  c.vehicle_body.volume = 0.35;
  c.vehicle_body.inertia = core::Vector3::Constant(50.0);
  c.vehicle_body.drag_area = core::Vector3::Constant(0.6);
  c.invalid_timeout = 10.0;
  return c;
}

}  // namespace

TEST(ReplayRun, AnObservedVehicleStartsWhenItsVesselIsKnown)
{
  std::string rows = HEADER + "\n";
  for (int i = 0; i <= 600; ++i)
  {
    rows += std::to_string(0.1 * i) + ",0,0," + std::to_string(1.0 + 0.2 * std::sin(0.08 * i));
    rows += i % 10 == 0 && i >= 20 ? ",0." + std::to_string(i % 7) + ",0.1,-98.9\n" : ",,,\n";
  }
  const files::CsvTable table = observedTable(rows);
  const std::string folder = ::testing::TempDir() + "tether_monitor_replay_observed";
  monitor::TetherEstimator estimator(observedConfig());
  {
    ResultRecorder recorder(folder, 0.0, VehicleColumns::OBSERVED);
    replayMeasurements(RecordedMeasurements(table), Motion(table, monitor::VehicleMode::OBSERVED), ReplayOptions(),
                       estimator, recorder);
    recorder.finish(estimator);
  }
  std::ifstream in(folder + "/ends.csv");
  std::string line;
  std::getline(in, line);
  EXPECT_NE(line.find(",status,vehicle_x,vehicle_y,vehicle_z,"), std::string::npos);
  EXPECT_NE(line.find(",vessel_tension_stddev,vehicle_tension_stddev"), std::string::npos);
  int invalid = 0, valid = 0;
  while (std::getline(in, line))
  {
    const bool is_invalid = line.find("INVALID") != std::string::npos;
    EXPECT_EQ(is_invalid, line.find("nan") != std::string::npos) << line;
    (is_invalid ? invalid : valid) += 1;
  }
  EXPECT_GE(invalid, 90) << "until the vessel's velocity is known, ...";
  EXPECT_LE(invalid, 240) << "... and while most of the heave is missing at the end of a taut tether";
  EXPECT_EQ(invalid + valid, 601);
  EXPECT_NEAR(estimator.estimate().vehicle.position.z(), -98.9, 0.5);
}

// A velocity in the first row is one noisy sample, and no tow is begun on it.
TEST(ReplayRun, ATowBeginsWhenItsSpeedIsKnown)
{
  std::string rows = "t,vessel_x,vessel_y,vessel_z,vessel_vx,vessel_vy,vessel_vz,vehicle_x,vehicle_y,vehicle_z\n";
  for (int i = 0; i <= 300; ++i)
  {
    const double x = 0.15 * i;
    rows += std::to_string(0.1 * i) + "," + std::to_string(x) + ",0,0,1.5,0,0";
    rows += i % 10 == 0 ? "," + std::to_string(x - 40.0 - 0.05 * (i % 3)) + ",0,-91\n" : ",,,\n";
  }
  const files::CsvTable table = observedTable(rows);
  monitor::TetherEstimator estimator(observedConfig());
  ResultRecorder recorder(::testing::TempDir() + "tether_monitor_replay_tow", 0.0, VehicleColumns::OBSERVED);
  ReplayOptions options;
  double started = NAN, largest = 0.0;
  options.is_interrupted = [&]
  {
    const monitor::TetherEstimate& e = estimator.estimate();
    if (estimator.isRunning() && std::isnan(started))
      started = e.time;
    if (estimator.isRunning())
      largest = std::max(largest, estimator.vehicle().ensemble()->members().motion().vessel_tension.maxCoeff());
    return false;
  };
  replayMeasurements(RecordedMeasurements(table), Motion(table, monitor::VehicleMode::OBSERVED), options,
                     estimator, recorder);
  EXPECT_GT(started, 5.0);
  EXPECT_LT(started, 15.0);
  EXPECT_LT(largest, estimator.config().tether.breaking_load) << "no member was begun at another speed";
}

}  // namespace tether_monitor::replay
