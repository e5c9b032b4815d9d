#include "tether_monitor/params/identified_configuration.h"

#include <yaml-cpp/yaml.h>

#include <cstdio>
#include <stdexcept>

namespace tether_monitor::params
{
namespace
{
std::string text(double x)
{
  char digits[32];
  std::snprintf(digits, sizeof(digits), "%.4g", x);
  return digits;
}

// A number that YAML takes for one, not for a text: with a point.
YAML::Node number(double x)
{
  std::string digits = text(x);
  const std::size_t exponent = digits.find('e');
  if (digits.find('.') == std::string::npos)
    digits.insert(exponent == std::string::npos ? digits.size() : exponent, ".0");
  return YAML::Node(digits);
}

void put(const monitor::Identification& found, const char* key, YAML::Node tether)
{
  const monitor::ParameterEstimate* p = found.find(std::string("tether.") + key);
  if (!p || !p->isTold())
    return;
  tether[key] = number(p->mean);
  tether["uncertainty"][key] = number(p->stddev / p->mean);
}

void putVehicleDrag(const monitor::Config& config, const monitor::Identification& found, YAML::Node root)
{
  const monitor::ParameterEstimate* p = found.find("vehicle.drag");
  if (!p || !p->isTold())
    return;
  YAML::Node areas(YAML::NodeType::Sequence);
  areas.SetStyle(YAML::EmitterStyle::Flow);
  for (int axis = 0; axis < 3; ++axis)
    areas.push_back(number(config.vehicle_body.drag_area[axis] * p->mean));
  root["vehicle"]["drag_area"] = areas;
  root["vehicle"]["drag_stddev"] = number(p->stddev / p->mean);
}
}  // namespace

std::string identifiedConfiguration(const std::string& path, const monitor::Config& config,
                                    const monitor::Identification& identification, bool length_is_counted)
{
  try
  {
    YAML::Node root = YAML::LoadFile(path);
    put(identification, "drag_normal", root["tether"]);
    put(identification, "drag_tangential", root["tether"]);
    put(identification, "mass_per_length", root["tether"]);
    if (!length_is_counted)
      put(identification, "length", root["tether"]);
    putVehicleDrag(config, identification, root);
    YAML::Emitter out;
    out << root;
    std::string head = "# Written by tether_identify: what a record told of tether and vehicle is in its place.\n";
    for (const char* axis : {"environment.current.x", "environment.current.y"})
      if (const monitor::ParameterEstimate* p = identification.find(axis))
        head += std::string("# ") + axis + " was " + text(p->mean) + " +- " + text(p->stddev) +
                " m/s in that record; it is of the day, and stays as it was configured.\n";
    return head + out.c_str() + "\n";
  }
  catch (const YAML::Exception& error)
  {
    throw std::runtime_error("configuration file " + path + ": " + error.what());
  }
}

}  // namespace tether_monitor::params
