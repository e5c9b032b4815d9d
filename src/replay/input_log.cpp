#include "tether_monitor/replay/input_log.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/files/csv_writer.h"

namespace tether_monitor::replay
{
void InputLog::add(double t, const std::string& topic, double delay, bool refused)
{
  if (!std::isfinite(t) || !std::isfinite(delay) || std::abs(t / PERIOD) > 1e9)
    return;
  Row& row = rows_[{std::lround(std::floor(t / PERIOD)), topic}];
  ++row.messages;
  row.refused += refused;
  row.delay_sum += delay;
  const auto [last, is_first] = last_.emplace(topic, t);
  if (!is_first)
  {
    row.longest_gap = std::max(row.longest_gap, t - last->second);
    last->second = std::max(last->second, t);
  }
}

void InputLog::write(const std::string& folder) const
{
  files::CsvWriter csv(folder + "/inputs.csv", "t,topic,messages,refused,delay,longest_gap");
  for (const auto& [key, row] : rows_)
  {
    csv.time(PERIOD * static_cast<double>(key.first)).text(key.second);
    csv.number(static_cast<double>(row.messages)).number(static_cast<double>(row.refused));
    csv.number(row.delay_sum / static_cast<double>(row.messages)).number(row.longest_gap);
    csv.endRow();
  }
  csv.close();
}

}  // namespace tether_monitor::replay
