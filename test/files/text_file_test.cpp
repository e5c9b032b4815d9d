#include "tether_monitor/files/text_file.h"

#include <gtest/gtest.h>

#include "tether_monitor/files/csv_table.h"
#include "tether_monitor/files/folder_lock.h"

namespace tether_monitor::files
{
namespace
{
std::string fileWith(const std::string& text)
{
  const std::string path = ::testing::TempDir() + "tether_monitor_text";
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

template <typename Work>
std::string faultOf(const Work& work)
{
  try
  {
    work();
    return "";
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
}
}  // namespace

TEST(TextFile, LeavesOutTheMarkOfItsEncoding)
{
  EXPECT_EQ(readCsv(fileWith("\xEF\xBB\xBFt,x\n0,1\n")).columns.front(), "t");
  TextFile text(fileWith("one\n\nthree"));
  std::string line;
  EXPECT_TRUE(text.readLine(line) && line == "one");
  EXPECT_TRUE(text.readLine(line) && line.empty());
  EXPECT_TRUE(text.readLine(line) && line == "three");
  EXPECT_EQ(text.lineNumber(), 3);
  EXPECT_FALSE(text.readLine(line));
}

TEST(TextFile, DevicesFoldersAndEndlessLinesAreRefused)
{
  for (const char* path : {"/dev/zero", "/dev/null", "/tmp", "/nowhere"})
    EXPECT_NE(faultOf([&] { readCsv(path); }).find(path), std::string::npos) << path;
  EXPECT_NE(faultOf([] { readCsv(fileWith(std::string(3 << 20, 'x'))); }).find("line 1: longer than"),
            std::string::npos);
  std::string wide = "a0";
  for (int i = 1; i < 100000; ++i)
    wide += ",a" + std::to_string(i);
  EXPECT_NE(faultOf([&] { readCsv(fileWith(wide + "\n")); }).find("100000 columns"), std::string::npos);
  EXPECT_NE(faultOf([] { readSmallFile(fileWith(std::string(101, 'x')), 100); }).find("larger than"),
            std::string::npos);
  EXPECT_NE(faultOf([] { readSmallFile("/dev/zero", 100); }).find("no file"), std::string::npos);
}

TEST(CsvTable, WhatItQuotesIsShortAndReadable)
{
  const std::string fault = faultOf([] { readCsv(fileWith("a\n" + std::string(500, '\x07') + "\n")); });
  EXPECT_LT(fault.size(), 150u);
  EXPECT_EQ(fault.find('\x07'), std::string::npos);
}

TEST(FolderLock, OneRunAtATime)
{
  const std::string folder = ::testing::TempDir();
  {
    const FolderLock first(folder);
    EXPECT_NE(faultOf([&] { FolderLock second(folder); }).find("another run"), std::string::npos);
  }
  EXPECT_EQ(faultOf([&] { FolderLock third(folder); }), "");
}

}  // namespace tether_monitor::files
