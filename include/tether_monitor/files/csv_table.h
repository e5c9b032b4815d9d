#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tether_monitor::files
{
/// A table of numbers read from a CSV file.
struct CsvTable
{
  std::string path;
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;  ///< empty fields are NaN where allowed.
  int header_line = 0;                    ///< line number of the header.
  std::vector<int> lines;                 ///< line number in the file, one for each row.

  /// Index of a column, or nothing.
  std::optional<std::size_t> find(const std::string& column) const;
};

/// Whether the fields of a column, known by its name, may be empty.
using MayBeEmpty = std::function<bool(const std::string&)>;

/// Whether the names of columns are those of the table that is wanted.
using IsHeader = std::function<bool(const std::vector<std::string>&)>;

/**
 * Reads a CSV file: the first line that is neither empty nor a comment (#) names the columns, the others hold
 * numbers.
 *
 * @param may_be_empty  names the columns whose fields may be empty (NaN then); null: none.
 * @param expected  looks at the header before anything else is read or quoted; null: any will do.
 * @throws std::runtime_error naming file and line: unreadable or empty file, another header, duplicate column,
 * wrong number of fields, a field that is empty, not a number, or not finite.
 */
CsvTable readCsv(const std::string& path, const MayBeEmpty& may_be_empty = nullptr,
                 const IsHeader& expected = nullptr);

}  // namespace tether_monitor::files
