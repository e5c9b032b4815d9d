#include "tether_monitor/files/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <stdexcept>

namespace tether_monitor::files
{
FolderLock::FolderLock(const std::string& folder)
  : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
  if (descriptor_ < 0)
    throw std::runtime_error("cannot open the folder " + folder);
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0)
    return;
  close(descriptor_);
  throw std::runtime_error("another run is writing into " + folder);
}

FolderLock::~FolderLock()
{
  close(descriptor_);
}

}  // namespace tether_monitor::files
