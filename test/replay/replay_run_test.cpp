#include "tether_monitor/replay/replay_run.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "monitor/support.h"

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

params::CsvTable run(double dt, double rate, const std::string& folder)
{
  const Motion motion(params::readCsv(motionFile(dt)));
  monitor::TetherEstimator estimator(monitor::testConfig());
  Recorder recorder(folder, 1.0);
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
  return params::readCsv(numbers);
}
}  // namespace

TEST(ReplayRun, WritesARowForEachRowOfTheMotionAndTheFirstOne)
{
  const std::string folder = ::testing::TempDir() + "tether_monitor_replay";
  std::filesystem::remove_all(folder);
  const params::CsvTable ends = run(0.5, 0.0, folder);
  ASSERT_EQ(ends.rows.size(), 41u);
  EXPECT_EQ(ends.rows[0][0], 0.0);
  EXPECT_EQ(ends.rows[40][0], 20.0);
  EXPECT_EQ(ends.columns[1], "vessel_fx");
  for (const char* file : {"shape.csv", "alarms.csv", "summary.json"})
    EXPECT_TRUE(std::filesystem::exists(folder + "/" + file)) << file;
  const params::CsvTable shape = params::readCsv(folder + "/shape.csv");
  EXPECT_EQ(shape.rows.size(), 21u * 41u);
}

TEST(ReplayRun, TheOutputRateDoesNotChangeTheMotion)
{
  const std::string folder = ::testing::TempDir() + "tether_monitor_replay_rate";
  const params::CsvTable often = run(0.5, 20.0, folder), seldom = run(0.5, 1.0, folder);
  ASSERT_EQ(often.rows.size(), 401u);
  ASSERT_EQ(seldom.rows.size(), 21u);
  for (int column = 1; column <= 6; ++column)
    EXPECT_NEAR(often.rows[400][column], seldom.rows[20][column], 1e-6 * 200.0);
}

TEST(ReplayRun, AFolderThatCannotBeMadeIsNamed)
{
  const std::string file = ::testing::TempDir() + "tether_monitor_a_file";
  std::ofstream(file) << "x";
  try
  {
    Recorder recorder(file + "/out", 1.0);
    FAIL() << "accepted";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find(file), std::string::npos);
  }
}

}  // namespace tether_monitor::replay
