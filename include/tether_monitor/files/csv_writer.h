#pragma once

#include <cstdio>
#include <memory>
#include <string>

namespace tether_monitor::files
{
/// A CSV file that is being written. Numbers keep 10 digits; NaN is "nan".
class CsvWriter
{
 public:
  /// @throws std::runtime_error naming the file if it cannot be made.
  CsvWriter(const std::string& path, const std::string& header);

  CsvWriter& number(double value);
  /// A time [s] with 15 digits, so that seconds since 1970 keep their microseconds.
  CsvWriter& time(double t);
  CsvWriter& text(const std::string& value);
  /// Ends the row. @throws std::runtime_error naming the file if writing failed.
  void endRow();
  /// Writes what is buffered. @throws as endRow().
  void close();

 private:
  struct Closer
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void separate();

  std::string path_;
  std::unique_ptr<std::FILE, Closer> file_;
  bool row_has_fields_ = false;
};

/// Makes a folder with its parents. @throws std::runtime_error naming it if that is impossible.
void makeFolder(const std::string& path);

}  // namespace tether_monitor::files
