#include "tether_monitor/files/csv_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "support/text_files.h"

namespace tether_monitor::files
{
TEST(CsvWriter, WritesHeaderFieldsAndRows)
{
  const std::string path = ownFile("out.csv");
  CsvWriter out(path, "t,a,word");
  out.time(0.5).number(-2.0).text("OK").endRow();
  out.time(1.0).number(1e-20).text("").endRow();
  out.close();
  EXPECT_EQ(textOf(path), "t,a,word\n0.5,-2,OK\n1,1e-20,\n");
}

TEST(CsvWriter, NumbersKeepTenDigitsAndTimesTheirMicroseconds)
{
  const std::string path = ownFile("out.csv");
  CsvWriter out(path, "t,a,b");
  out.time(1700000000.123457).number(1.0 / 3.0).number(NAN).endRow();
  out.close();
  EXPECT_EQ(textOf(path), "t,a,b\n1700000000.12346,0.3333333333,nan\n");
}

TEST(CsvWriter, NamesAFileThatCannotBeMade)
{
  const std::string path = ownFile("no_folder") + "/out.csv";
  EXPECT_NE(errorOf([&] { CsvWriter(path, "t"); }).find(path), std::string::npos);
}

TEST(MakeFolder, MakesParentsTooAndNamesWhatIsInTheWay)
{
  const std::string folder = ownFile("folder");
  std::filesystem::remove_all(folder);
  makeFolder(folder + "/a/b");
  EXPECT_TRUE(std::filesystem::is_directory(folder + "/a/b"));
  EXPECT_NO_THROW(makeFolder(folder + "/a/b")) << "it may be there";
  const std::string file = ownFile("file", "x");
  EXPECT_NE(errorOf([&] { makeFolder(file); }).find(file), std::string::npos);
  EXPECT_NE(errorOf([&] { makeFolder(file + "/a"); }).find(file + "/a"), std::string::npos);
}
}  // namespace tether_monitor::files
