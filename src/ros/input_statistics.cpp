#include "tether_monitor/ros/input_statistics.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor
{
void InputStatistics::add(double t, double offset, const std::string& publisher)
{
  ++count_;
  if (last_heard_.size() >= MOST_PUBLISHERS && last_heard_.count(publisher) == 0)
    last_heard_.clear();
  last_heard_[publisher] = t;
  if (std::isnan(window_.began) || t < window_.began)
    window_ = Window();
  if (std::isnan(window_.began))
    window_.began = t;
  if (t - window_.began >= WINDOW)
  {
    rate_ = window_.count / (t - window_.began);
    has_offset_ = window_.stamped > 0;
    if (has_offset_)
      offset_ = {window_.sum / window_.stamped, window_.least, window_.most};
    window_ = Window();
    window_.began = t;
  }
  ++window_.count;
  if (std::isnan(offset))
    return;
  ++window_.stamped;
  window_.sum += offset;
  window_.least = std::min(window_.least, offset);
  window_.most = std::max(window_.most, offset);
}

bool InputStatistics::isWithoutTime(double t, double offset)
{
  const bool is_without = std::isnan(offset) && t == last_received_;
  last_received_ = t;
  without_time_ += is_without;
  return is_without;
}

std::vector<std::string> InputStatistics::publishers(double t) const
{
  std::vector<std::string> names;
  for (const auto& [name, heard] : last_heard_)
    if (t - heard <= WINDOW)
      names.push_back(name);
  return names;
}

std::size_t InputStatistics::publisherCount(double t) const
{
  return std::count_if(last_heard_.begin(), last_heard_.end(),
                       [t](const auto& heard) { return t - heard.second <= WINDOW; });
}

}  // namespace tether_monitor
