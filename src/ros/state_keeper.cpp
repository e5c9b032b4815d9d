#include "tether_monitor/ros/state_keeper.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace tether_monitor
{
namespace
{
const std::string MAGIC = "tether_monitor kept state 1\n";
constexpr std::size_t LARGEST = 256u << 20;  // [B]
}  // namespace

StateKeeper::StateKeeper(const std::string& path) : path_(path)
{
  if (!isOn())
    return;
  std::ofstream probe(path_ + ".new", std::ios::binary);
  if (!probe)
    throw std::runtime_error("monitor.state_file = '" + path_ + "' cannot be written: " + std::strerror(errno));
  probe.close();
  std::remove((path_ + ".new").c_str());
  thread_ = std::thread([this] { run(); });
}

StateKeeper::~StateKeeper()
{
  if (!thread_.joinable())
    return;
  {
    const std::lock_guard<PriorityMutex> lock(mutex_);
    is_over_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

std::optional<KeptState> StateKeeper::read() const
{
  std::ifstream file(path_, std::ios::binary);
  std::string magic(MAGIC.size(), '\0');
  std::uint32_t epoch = 0;
  file.read(magic.data(), static_cast<std::streamsize>(magic.size()));
  file.read(reinterpret_cast<char*>(&epoch), sizeof(epoch));
  if (!file || magic != MAGIC)
    return std::nullopt;
  KeptState state;
  state.time = TimeOrigin(ros::Time(epoch, 0));
  for (std::istreambuf_iterator<char> it(file), end; it != end && state.bytes.size() < LARGEST; ++it)
    state.bytes.push_back(static_cast<std::uint8_t>(*it));
  return state;
}

void StateKeeper::submit(double t, KeptState state)
{
  submitted_ = t;
  {
    const std::lock_guard<PriorityMutex> lock(mutex_);
    waiting_ = std::move(state);
  }
  wake_.notify_one();
}

std::string StateKeeper::problem() const
{
  const std::lock_guard<PriorityMutex> lock(mutex_);
  return problem_;
}

std::string StateKeeper::write(const KeptState& state) const
{
  const std::string fresh = path_ + ".new";
  {
    std::ofstream file(fresh, std::ios::binary | std::ios::trunc);
    const auto epoch = static_cast<std::uint32_t>(state.time.epoch());
    file.write(MAGIC.data(), static_cast<std::streamsize>(MAGIC.size()));
    file.write(reinterpret_cast<const char*>(&epoch), sizeof(epoch));
    file.write(reinterpret_cast<const char*>(state.bytes.data()),
               static_cast<std::streamsize>(state.bytes.size()));
    if (!file.flush())
      return "'" + fresh + "' cannot be written: " + std::strerror(errno);
  }
  if (std::rename(fresh.c_str(), path_.c_str()) != 0)
    return "'" + path_ + "' cannot be replaced: " + std::strerror(errno);
  return "";
}

void StateKeeper::run()
{
  std::unique_lock<PriorityMutex> lock(mutex_);
  for (;;)
  {
    wake_.wait(lock, [this] { return waiting_ || is_over_; });
    if (!waiting_)
      return;
    const KeptState state = std::move(*waiting_);
    waiting_.reset();
    lock.unlock();
    const std::string problem = write(state);
    lock.lock();
    problem_ = problem;
  }
}

}  // namespace tether_monitor
