#pragma once

#include <fstream>
#include <string>

namespace tether_monitor::files
{
constexpr std::size_t LONGEST_LINE = 1u << 20;  ///< [bytes] of a text file that is read line by line.

/// A text file line by line, whatever stands in it: no device, no endless line; the mark of its encoding at the
/// beginning is left out.
class TextFile
{
 public:
  /// @throws std::runtime_error naming the path: it cannot be read, or is no file.
  explicit TextFile(const std::string& path);
  /// @return false at the end. @throws std::runtime_error naming path and line: longer than LONGEST_LINE.
  bool readLine(std::string& line);
  /// Of the last line, from 1.
  int lineNumber() const { return number_; }

 private:
  std::string path_;
  std::ifstream in_;
  int number_ = 0;
};

/// A whole file of at most `most` bytes. @throws std::runtime_error as TextFile, or if it is larger.
std::string readSmallFile(const std::string& path, std::size_t most);

}  // namespace tether_monitor::files
