#pragma once

#include <array>

namespace tether_monitor
{
/// While it lives, what would kill the process (an assertion of rosbag on a damaged bag, say) ends it with a word
/// on the standard error and exit code 1. One at a time.
class CrashGuard
{
 public:
  /// @param text  that is printed; must outlive the object.
  explicit CrashGuard(const char* text);
  ~CrashGuard();
  CrashGuard(const CrashGuard&) = delete;
  CrashGuard& operator=(const CrashGuard&) = delete;

 private:
  std::array<void (*)(int), 4> before_{};
};

}  // namespace tether_monitor
