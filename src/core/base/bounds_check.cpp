#include "tether_monitor/core/base/bounds_check.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace tether_monitor::core
{
std::string formatNumber(double value)
{
  char text[40];
  for (int digits = 6; digits <= 17; ++digits)
  {
    std::snprintf(text, sizeof(text), "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value)
      break;
  }
  return text;
}

void BoundsCheck::check(bool ok, const char* name, double value, const std::string& rule)
{
  if (!ok)
    problems_.push_back(prefix_ + name + " = " + formatNumber(value) + " (must be " + rule + ")");
}

void BoundsCheck::positive(const char* name, double value, const char* unit)
{
  check(std::isfinite(value) && value > 0.0, name, value, std::string("> 0 ") + unit);
}

void BoundsCheck::notNegative(const char* name, double value, const char* unit)
{
  check(std::isfinite(value) && value >= 0.0, name, value, std::string(">= 0 ") + unit);
}

void BoundsCheck::finite(const char* name, double value, const char* unit)
{
  check(std::isfinite(value), name, value, std::string("finite, in ") + unit);
}

void BoundsCheck::within(const char* name, double value, double low, double high, const char* unit)
{
  check(value >= low && value <= high, name, value,
        ">= " + formatNumber(low) + " and <= " + formatNumber(high) + " " + unit);
}

void throwIfInvalid(const std::string& what, const std::vector<std::string>& problems)
{
  if (problems.empty())
    return;
  std::string text = what + ":";
  for (const std::string& problem : problems)
    text += "\n  - " + problem;
  throw std::invalid_argument(text);
}

}  // namespace tether_monitor::core
