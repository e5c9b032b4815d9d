#pragma once

#include <boost/program_options.hpp>
#include <functional>
#include <stdexcept>
#include <string>

namespace tether_monitor::apps
{
/// A command line that a program cannot work with; what() says why.
class CommandLineError : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

/// The options of a program, with --help added.
class CommandLine
{
 public:
  /// @param summary  a sentence about the program, for --help.
  CommandLine(const std::string& program, const std::string& summary);

  boost::program_options::options_description_easy_init add() { return options_.add_options(); }
  /// Reads the arguments into the variables of the options. @return false if --help was wanted, which is printed.
  /// @throws CommandLineError naming what is wrong.
  bool parse(int argc, const char* const* argv);
  /// True if an option was given, and not its default.
  bool has(const std::string& option) const;
  /// Two options that cannot stand together. @throws CommandLineError
  void exclude(const std::string& one, const std::string& other) const;

 private:
  std::string program_, summary_;
  boost::program_options::options_description options_;
  boost::program_options::variables_map values_;
};

/// @throws CommandLineError naming the option unless the value is > 0 (>= 0).
void checkPositive(const std::string& option, double value);
void checkNotNegative(const std::string& option, double value);

/// The numbers in "A,B", text of an option. @throws CommandLineError naming it.
std::pair<double, double> twoNumbers(const std::string& option, const std::string& text);

/// The text with a question mark for every byte that is no character: what came out of a damaged file must not
/// steer a terminal.
std::string printable(const std::string& text);

/// Calls parse() and then run(), and prints what goes wrong. @return the exit code: that of run(), 1 after an
/// error.
int runProgram(const std::string& program, CommandLine& line, int argc, const char* const* argv,
               const std::function<int()>& run);

}  // namespace tether_monitor::apps
