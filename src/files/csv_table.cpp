#include "tether_monitor/files/csv_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "tether_monitor/files/text_file.h"

namespace tether_monitor::files
{
namespace
{
constexpr std::size_t MOST_COLUMNS = 1000;
constexpr std::size_t LONGEST_QUOTE = 40;

// A field for a message: short, and of characters that a terminal shows.
std::string quoted(const std::string& text)
{
  std::string shown = text.substr(0, LONGEST_QUOTE);
  for (char& c : shown)
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f)
      c = '?';
  return "'" + shown + (text.size() > LONGEST_QUOTE ? "...'" : "'");
}

std::string trimmed(const std::string& text)
{
  const char* const SPACE = " \t\r\n\"";
  const std::size_t first = text.find_first_not_of(SPACE);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(SPACE) - first + 1);
}

std::vector<std::string> split(const std::string& line)
{
  std::vector<std::string> fields;
  std::size_t begin = 0;
  for (;;)
  {
    const std::size_t comma = line.find(',', begin);
    fields.push_back(trimmed(line.substr(begin, comma - begin)));
    if (comma == std::string::npos)
      return fields;
    begin = comma + 1;
  }
}

[[noreturn]] void fail(const std::string& path, int line, const std::string& what)
{
  throw std::runtime_error(path + ", line " + std::to_string(line) + ": " + what);
}

double parseField(const CsvTable& table, int line, std::size_t column, const std::string& text,
                  const MayBeEmpty& may_be_empty)
{
  const std::string name = "column " + table.columns[column];
  if (text.empty() && may_be_empty && may_be_empty(table.columns[column]))
    return std::numeric_limits<double>::quiet_NaN();
  if (text.empty())
    fail(table.path, line, name + " is empty");
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end != text.c_str() + text.size())
    fail(table.path, line, name + " = " + quoted(text) + " is not a number");
  if (!std::isfinite(value))
    fail(table.path, line, name + " = " + quoted(text) + " is not finite");
  return value;
}
}  // namespace

std::optional<std::size_t> CsvTable::find(const std::string& column) const
{
  const auto it = std::find(columns.begin(), columns.end(), column);
  return it == columns.end() ? std::nullopt : std::optional<std::size_t>(it - columns.begin());
}

CsvTable readCsv(const std::string& path, const MayBeEmpty& may_be_empty, const IsHeader& expected)
{
  TextFile in(path);
  CsvTable table;
  table.path = path;
  std::string line;
  while (in.readLine(line))
  {
    const int number = in.lineNumber();
    const std::string content = trimmed(line);
    if (content.empty() || content[0] == '#')
      continue;
    const std::vector<std::string> fields = split(content);
    if (table.columns.empty())
    {
      if (fields.size() > MOST_COLUMNS)
        fail(path, number,
             std::to_string(fields.size()) + " columns, at most " + std::to_string(MOST_COLUMNS) + " can be");
      if (fields.size() == 1 && content.find_first_of(";\t") != std::string::npos)
        fail(path, number, "its columns are separated by semicolons or tabs; commas are needed");
      if (expected && !expected(fields))
        fail(path, number, "the header does not name the columns that are expected");
      table.columns = fields;
      table.header_line = number;
      for (std::size_t i = 0; i < fields.size(); ++i)
        if (std::count(fields.begin(), fields.end(), fields[i]) > 1)
          fail(path, number, "column " + quoted(fields[i]) + " stands twice");
      continue;
    }
    if (fields.size() != table.columns.size())
      fail(path, number,
           std::to_string(fields.size()) + " fields where the header names " +
               std::to_string(table.columns.size()));
    std::vector<double> row(fields.size());
    for (std::size_t i = 0; i < fields.size(); ++i)
      row[i] = parseField(table, number, i, fields[i], may_be_empty);
    table.rows.push_back(std::move(row));
    table.lines.push_back(number);
  }
  if (table.columns.empty())
    throw std::runtime_error(path + " is empty: no header line");
  return table;
}

}  // namespace tether_monitor::files
