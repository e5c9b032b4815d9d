#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

/// Path of a file that the running test case has for itself.
inline std::string ownFile(const std::string& name)
{
  const ::testing::TestInfo* test_case = ::testing::UnitTest::GetInstance()->current_test_info();
  return ::testing::TempDir() + "tether_monitor_" + test_case->test_suite_name() + "_" + test_case->name() + "_" +
         name;
}

/// The same, with a text in it.
inline std::string ownFile(const std::string& name, const std::string& text)
{
  const std::string path = ownFile(name);
  std::ofstream(path) << text;
  return path;
}

inline std::string textOf(const std::string& path)
{
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// What a std::runtime_error of `act` says; empty if there is none.
template <class Act>
std::string errorOf(const Act& act)
{
  try
  {
    act();
    return "";
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
}
