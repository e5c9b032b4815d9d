#pragma once

#include <string>

namespace tether_monitor::files
{
/// Holds a folder for one run: two that wrote into it would mix their rows. Given up with the object, or with the
/// process.
class FolderLock
{
 public:
  /// @throws std::runtime_error naming the folder: another run holds it, or it cannot be opened.
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace tether_monitor::files
