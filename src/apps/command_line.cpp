#include "command_line.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace tether_monitor::apps
{
namespace options = boost::program_options;

CommandLine::CommandLine(const std::string& program, const std::string& summary)
  : program_(program), summary_(summary), options_("Options", 110)
{
  add()("help,h", "print this and exit");
}

bool CommandLine::parse(int argc, const char* const* argv)
{
  namespace style = options::command_line_style;
  try
  {
    options::store(options::command_line_parser(argc, argv)
                       .options(options_)
                       .style(style::unix_style & ~style::allow_guessing)
                       .positional(options::positional_options_description())
                       .run(),
                   values_);
    if (values_.count("help") > 0)
    {
      std::cout << summary_ << "\nUsage: " << program_ << " [OPTIONS]\n" << options_;
      return false;
    }
    options::notify(values_);
    return true;
  }
  catch (const options::error& error)
  {
    throw CommandLineError(error.what());
  }
}

bool CommandLine::has(const std::string& option) const
{
  return values_.count(option) > 0 && !values_[option].defaulted();
}

void CommandLine::exclude(const std::string& one, const std::string& other) const
{
  if (has(one) && has(other))
    throw CommandLineError("--" + one + " and --" + other + " cannot be given together");
}

void checkPositive(const std::string& option, double value)
{
  if (!(std::isfinite(value) && value > 0.0))
    throw CommandLineError("--" + option + " must be > 0");
}

void checkNotNegative(const std::string& option, double value)
{
  if (!(std::isfinite(value) && value >= 0.0))
    throw CommandLineError("--" + option + " must be >= 0");
}

std::pair<double, double> twoNumbers(const std::string& option, const std::string& text)
{
  double a = NAN, b = NAN;
  int used = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf%n", &a, &b, &used) != 2 || used != static_cast<int>(text.size()) ||
      !std::isfinite(a) || !std::isfinite(b))
    throw CommandLineError("--" + option + " must be two numbers with a comma between them, not '" + text + "'");
  return {a, b};
}

namespace
{
// Bytes of the character that begins at `at`, 0 if it is none that a terminal shows.
std::size_t characterLength(const std::string& text, std::size_t at)
{
  const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
  const unsigned first = byte(at);
  if (first < 0x80)
    return (first >= ' ' && first != 0x7f) || first == '\n' ? 1 : 0;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4)
    return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(at + k) & 0xc0) != 0x80)
      return 0;
  return length;
}
}  // namespace

std::string printable(const std::string& text)
{
  std::string shown;
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t length = characterLength(text, at);
    shown += length > 0 ? text.substr(at, length) : "?";
    at += std::max<std::size_t>(length, 1);
  }
  return shown;
}

int runProgram(const std::string& program, CommandLine& line, int argc, const char* const* argv,
               const std::function<int()>& run)
{
  try
  {
    return line.parse(argc, argv) ? run() : 0;
  }
  catch (const CommandLineError& error)
  {
    std::cerr << program << ": " << error.what() << "\nRun with --help for more information.\n";
  }
  catch (const std::exception& error)
  {
    std::cerr << program << ": " << printable(error.what()) << "\n";
  }
  return 1;
}

}  // namespace tether_monitor::apps
