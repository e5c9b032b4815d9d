#include "tether_monitor/params/yaml_file.h"

#include <yaml-cpp/yaml.h>

#include <stdexcept>

namespace tether_monitor::params
{
namespace
{
Value scalar(const YAML::Node& node)
{
  if (node.Tag() == "!")  // quoted
    return Value(node.Scalar());
  const std::string& text = node.Scalar();
  if (text == "true" || text == "false")
    return Value(text == "true");
  return Value(text);
}

Value convert(const YAML::Node& node)
{
  switch (node.Type())
  {
    case YAML::NodeType::Scalar:
      return scalar(node);
    case YAML::NodeType::Sequence:
    {
      Value::List list;
      for (const YAML::Node& item : node)
        list.push_back(convert(item));
      return Value(std::move(list));
    }
    case YAML::NodeType::Map:
    {
      Value::Map map;
      for (const auto& entry : node)
      {
        const std::string name = entry.first.as<std::string>();
        if (!map.emplace(name, convert(entry.second)).second)
          throw std::runtime_error("line " + std::to_string(entry.first.Mark().line + 1) + ": key '" + name +
                                   "' stands twice");
      }
      return Value(std::move(map));
    }
    default:
      return Value();
  }
}
}  // namespace

Value readYamlFile(const std::string& path)
{
  try
  {
    return convert(YAML::LoadFile(path));
  }
  catch (const YAML::BadFile&)
  {
    throw std::runtime_error("cannot read the configuration file " + path);
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error("configuration file " + path + ": " + error.what());
  }
}

}  // namespace tether_monitor::params
