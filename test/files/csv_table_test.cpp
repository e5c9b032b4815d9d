#include "tether_monitor/files/csv_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/text_files.h"

namespace tether_monitor::files
{
namespace
{
std::string faultOf(const std::string& text)
{
  const std::string path = ownFile("in.csv", text);
  const std::string error = errorOf([&] { readCsv(path); });
  EXPECT_NE(error.find(path), std::string::npos) << error;
  return error.substr(error.find(path) + path.size());
}
}  // namespace

TEST(CsvTable, KeepsColumnsRowsAndTheirLines)
{
  const CsvTable table = readCsv(ownFile("in.csv", "# made by hand\n\nt, depth\r\n0, 1e3\n# pause\n 2.5 ,-4\n"));
  EXPECT_EQ(table.columns, (std::vector<std::string>{"t", "depth"}));
  EXPECT_EQ(table.header_line, 3);
  EXPECT_EQ(table.rows, (std::vector<std::vector<double>>{{0.0, 1000.0}, {2.5, -4.0}}));
  EXPECT_EQ(table.lines, (std::vector<int>{4, 6}));
  EXPECT_EQ(table.find("depth"), 1u);
  EXPECT_FALSE(table.find("Depth"));
}

TEST(CsvTable, AnEmptyFieldIsNaNWhereItMayBe)
{
  const std::string path = ownFile("in.csv", "a,b\n1,\n");
  const CsvTable table = readCsv(path, [](const std::string& column) { return column == "b"; });
  EXPECT_EQ(table.rows[0][0], 1.0);
  EXPECT_TRUE(std::isnan(table.rows[0][1]));
  EXPECT_NE(errorOf([&] { readCsv(path, [](const std::string& column) { return column == "a"; }); })
                .find("line 2: column b is empty"),
            std::string::npos);
}

TEST(CsvTable, FaultsAreNamedWithFileAndLine)
{
  EXPECT_EQ(faultOf("# only this\n"), " is empty: no header line");
  EXPECT_EQ(faultOf("a,b,a\n"), ", line 1: column 'a' stands twice");
  EXPECT_EQ(faultOf("a,b\n1,2\n1,2,3\n"), ", line 3: 3 fields where the header names 2");
  EXPECT_EQ(faultOf("a,b\n1,2m\n"), ", line 2: column b = '2m' is not a number");
  EXPECT_EQ(faultOf("a,b\n1,inf\n"), ", line 2: column b = 'inf' is not finite");
  EXPECT_EQ(faultOf("a,b\n,2\n"), ", line 2: column a is empty");
  EXPECT_EQ(faultOf("a;b\n1;2\n"), ", line 1: its columns are separated by semicolons or tabs; commas are needed");
  const std::string nowhere = ownFile("nowhere.csv");
  EXPECT_NE(errorOf([&] { readCsv(nowhere); }).find(nowhere), std::string::npos);
}
}  // namespace tether_monitor::files
