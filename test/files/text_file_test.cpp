#include "tether_monitor/files/text_file.h"

#include <gtest/gtest.h>

#include "support/text_files.h"
#include "tether_monitor/files/csv_table.h"
#include "tether_monitor/files/folder_lock.h"

namespace tether_monitor::files
{
TEST(TextFile, LeavesOutTheMarkOfItsEncoding)
{
  EXPECT_EQ(readCsv(ownFile("text", "\xEF\xBB\xBFt,x\n0,1\n")).columns.front(), "t");
  TextFile text(ownFile("text", "one\n\nthree"));
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
    EXPECT_NE(errorOf([&] { readCsv(path); }).find(path), std::string::npos) << path;
  EXPECT_NE(errorOf([] { readCsv(ownFile("text", std::string(3 << 20, 'x'))); }).find("line 1: longer than"),
            std::string::npos);
  std::string wide = "a0";
  for (int i = 1; i < 100000; ++i)
    wide += ",a" + std::to_string(i);
  EXPECT_NE(errorOf([&] { readCsv(ownFile("text", wide + "\n")); }).find("100000 columns"), std::string::npos);
  EXPECT_NE(errorOf([] { readSmallFile(ownFile("text", std::string(101, 'x')), 100); }).find("larger than"),
            std::string::npos);
  EXPECT_NE(errorOf([] { readSmallFile("/dev/zero", 100); }).find("no file"), std::string::npos);
}

TEST(CsvTable, WhatItQuotesIsShortAndReadable)
{
  const std::string fault = errorOf([] { readCsv(ownFile("text", "a\n" + std::string(500, '\x07') + "\n")); });
  EXPECT_LT(fault.size(), 150u);
  EXPECT_EQ(fault.find('\x07'), std::string::npos);
}

TEST(FolderLock, OneRunAtATime)
{
  const std::string folder = ::testing::TempDir();
  {
    const FolderLock first(folder);
    EXPECT_NE(errorOf([&] { FolderLock second(folder); }).find("another run"), std::string::npos);
  }
  EXPECT_EQ(errorOf([&] { FolderLock third(folder); }), "");
}

}  // namespace tether_monitor::files
