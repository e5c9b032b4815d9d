#include "tether_monitor/ros/force_text.h"

#include <cmath>
#include <cstdio>

namespace tether_monitor
{
std::string forceText(double newtons)
{
  struct Unit
  {
    double size;
    const char* name;
  };
  constexpr Unit UNITS[] = {{1e6, "MN"}, {1e3, "kN"}};
  constexpr double ROUNDS_UP = 0.9995;  // 999.6 N are 1 kN in three figures
  if (!std::isfinite(newtons))
    return "unknown";
  Unit unit{1.0, "N"};
  for (const Unit& larger : UNITS)
    if (unit.size == 1.0 && std::abs(newtons) >= ROUNDS_UP * larger.size)
      unit = larger;
  char text[40];
  std::snprintf(text, sizeof(text), "%.3g %s", newtons / unit.size, unit.name);
  return text;
}
}  // namespace tether_monitor
