#pragma once

#include <map>
#include <string>
#include <utility>

namespace tether_monitor::replay
{
/// inputs.csv: what came on every topic, a row a topic and ten seconds in which something came.
class InputLog
{
 public:
  static constexpr double PERIOD = 10.0;  ///< [s]

  /// A message. @param t  when it arrived [s]. @param delay  arrival less stamp [s]. @param refused  it was not
  /// used.
  void add(double t, const std::string& topic, double delay, bool refused);
  bool empty() const { return rows_.empty(); }
  /// @throws std::runtime_error naming what cannot be written.
  void write(const std::string& folder) const;

 private:
  struct Row
  {
    long messages = 0, refused = 0;
    double delay_sum = 0.0, longest_gap = 0.0;  // [s]
  };
  std::map<std::pair<long, std::string>, Row> rows_;
  std::map<std::string, double> last_;  // arrival on each topic [s]
};

}  // namespace tether_monitor::replay
