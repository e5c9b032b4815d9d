#include "tether_monitor/files/text_file.h"

#include <filesystem>
#include <iterator>
#include <stdexcept>

namespace tether_monitor::files
{
namespace
{
const char BYTE_ORDER_MARK[] = "\xEF\xBB\xBF";

const std::string& checked(const std::string& path)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (error || !std::filesystem::exists(status))
    throw std::runtime_error("cannot read " + path);
  if (!std::filesystem::is_regular_file(status) && !std::filesystem::is_fifo(status))
    throw std::runtime_error("cannot read " + path + ": it is no file");
  return path;
}
}  // namespace

TextFile::TextFile(const std::string& path) : path_(checked(path)), in_(path)
{
  if (!in_)
    throw std::runtime_error("cannot read " + path);
}

bool TextFile::readLine(std::string& line)
{
  line.clear();
  ++number_;
  std::streambuf& buffer = *in_.rdbuf();
  int c = buffer.sbumpc();
  if (c == std::char_traits<char>::eof())
    return false;
  for (; c != std::char_traits<char>::eof() && c != '\n'; c = buffer.sbumpc())
  {
    if (line.size() == LONGEST_LINE)
      throw std::runtime_error(path_ + ", line " + std::to_string(number_) + ": longer than " +
                               std::to_string(LONGEST_LINE) + " bytes, so it is no table");
    line.push_back(static_cast<char>(c));
  }
  if (number_ == 1 && line.compare(0, 3, BYTE_ORDER_MARK) == 0)
    line.erase(0, 3);
  return true;
}

std::string readSmallFile(const std::string& path, std::size_t most)
{
  std::ifstream in(checked(path), std::ios::binary);
  if (!in)
    throw std::runtime_error("cannot read " + path);
  std::string text(most + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > most)
    throw std::runtime_error(path + " is larger than " + std::to_string(most) + " bytes");
  return text;
}

}  // namespace tether_monitor::files
