#pragma once

#include <string>
#include <vector>

namespace tether_monitor::core
{
/// Collects violated bounds as sentences "NAME = VALUE (must be ...)". NaN violates every bound.
class BoundsCheck
{
 public:
  /// @param prefix  put before every name, for example "tether.".
  explicit BoundsCheck(std::string prefix = "") : prefix_(std::move(prefix)) {}

  void positive(const char* name, double value, const char* unit);
  void notNegative(const char* name, double value, const char* unit);
  void finite(const char* name, double value, const char* unit);
  /// low <= value <= high.
  void within(const char* name, double value, double low, double high, const char* unit);
  /// A bound that the caller tested: reports NAME = VALUE (must be RULE) unless `ok`.
  void check(bool ok, const char* name, double value, const std::string& rule);

  const std::vector<std::string>& problems() const { return problems_; }

 private:
  std::string prefix_;
  std::vector<std::string> problems_;
};

/// Shortest text that reads back as the same number: "0.03", "6.75e+07", "nan".
std::string formatNumber(double value);

/// @throws std::invalid_argument listing all problems after `what`, if there are any.
void throwIfInvalid(const std::string& what, const std::vector<std::string>& problems);

}  // namespace tether_monitor::core
