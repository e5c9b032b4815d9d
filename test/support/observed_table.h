#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tether_monitor/replay/recorded_measurements.h"

namespace tether_monitor::replay
{
inline const std::string HEADER = "t,vessel_x,vessel_y,vessel_z,vehicle_x,vehicle_y,vehicle_z";

/// The rows of a file of recorded measurements, read back; each test case has a file of its own.
inline files::CsvTable observedTable(const std::string& rows)
{
  const std::string test_case = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::string path = ::testing::TempDir() + "tether_monitor_" + test_case + ".csv";
  std::ofstream(path) << rows;
  return files::readCsv(path, mayBeEmpty);
}
}  // namespace tether_monitor::replay
