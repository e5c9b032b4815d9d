#include "tether_monitor/params/yaml_file.h"

#include <yaml-cpp/yaml.h>

#include <stdexcept>
#include <string>

#include "tether_monitor/files/text_file.h"

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

// Nodes that may be, aliases counted as often as they are used, and how deep they may lie: a file can refer to
// itself.
constexpr int MOST_NODES = 100000, DEEPEST = 50;
constexpr std::size_t LARGEST_FILE = 1u << 20;  // [bytes]

// The parser calls itself for every bracket and dash within another.
void checkNesting(const std::string& text)
{
  int brackets = 0, dashes = 0;
  bool is_comment = false;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const char c = text[i], before = i > 0 ? text[i - 1] : '\n', after = i + 1 < text.size() ? text[i + 1] : '\n';
    is_comment = c != '\n' && (is_comment || (c == '#' && (before == ' ' || before == '\n')));
    if (is_comment)
      continue;
    brackets += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
    if (c == '-' && after == ' ')
      ++dashes;
    else if (c != ' ')
      dashes = 0;
    if (brackets > DEEPEST || dashes > DEEPEST)
      throw std::runtime_error("lists within lists, deeper than " + std::to_string(DEEPEST));
  }
}

Value convert(const YAML::Node& node, int depth, int& nodes)
{
  if (++nodes > MOST_NODES)
    throw std::runtime_error("more than " + std::to_string(MOST_NODES) + " entries");
  if (depth > DEEPEST)
    throw std::runtime_error("entries within entries, deeper than " + std::to_string(DEEPEST) +
                             ": one may refer to itself");
  switch (node.Type())
  {
    case YAML::NodeType::Scalar:
      return scalar(node);
    case YAML::NodeType::Sequence:
    {
      Value::List list;
      for (const YAML::Node& item : node)
        list.push_back(convert(item, depth + 1, nodes));
      return Value(std::move(list));
    }
    case YAML::NodeType::Map:
    {
      Value::Map map;
      for (const auto& entry : node)
      {
        const std::string name = entry.first.as<std::string>();
        if (!map.emplace(name, convert(entry.second, depth + 1, nodes)).second)
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
  std::string text;
  try
  {
    text = files::readSmallFile(path, LARGEST_FILE);
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error(std::string("configuration file: ") + error.what());
  }
  try
  {
    checkNesting(text);
    int nodes = 0;
    return convert(YAML::Load(text), 0, nodes);
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error("configuration file " + path + ": " + error.what());
  }
}

}  // namespace tether_monitor::params
