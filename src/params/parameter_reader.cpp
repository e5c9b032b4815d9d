#include "tether_monitor/params/parameter_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace tether_monitor::params
{
namespace
{
const Value EMPTY{Value::Map{}};

std::string joined(const std::string& where, const std::vector<std::string>& errors)
{
  std::string text = std::to_string(errors.size()) + " problem(s) with the parameters in " + where + ":";
  for (const std::string& addError : errors)
    text += "\n  - " + addError;
  return text;
}

// Whole text as a number, else nothing. Hexadecimal, "inf" and "nan" are no numbers for a parameter.
std::optional<double> parseNumber(const std::string& text)
{
  if (text.empty() || text.find_first_not_of("0123456789+-.eE") != std::string::npos)
    return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return end == text.c_str() + text.size() ? std::optional<double>(value) : std::nullopt;
}

// A map of x, y, z and w as the list of its numbers, as messages are written; anything else as it is.
Value inOrder(const Value& value)
{
  const auto* map = value.get<Value::Map>();
  if (!map)
    return value;
  Value::List list;
  for (const char* key : {"x", "y", "z", "w"})
    if (const auto at = map->find(key); at != map->end())
      list.push_back(at->second);
  return list.size() == map->size() ? Value(list) : value;
}
}  // namespace

ParameterError::ParameterError(const std::string& where, const std::vector<std::string>& errors)
  : std::runtime_error(joined(where, errors)), errors_(errors)
{
}

ParameterReader::ParameterReader(const Value& tree)
  : ParameterReader(&tree, "", std::make_shared<std::vector<std::string>>())
{
}

ParameterReader::ParameterReader(const Value* level, std::string path,
                                 std::shared_ptr<std::vector<std::string>> errors)
  : level_(level), path_(std::move(path)), errors_(std::move(errors))
{
  if (level_->get<Value::Map>())
    return;
  if (!level_->isNull())
    errors_->push_back((path_.empty() ? "the tree" : path_) + " = " + level_->show() + " is not a map of keys");
  level_ = &EMPTY;
}

void ParameterReader::addError(const char* key, const std::string& what)
{
  errors_->push_back((path_.empty() ? "" : path_ + ".") + key + what);
}

bool ParameterReader::has(const char* key) const
{
  return level_->get<Value::Map>()->count(key) > 0;
}

const Value* ParameterReader::find(const char* key)
{
  known_.insert(key);
  const Value::Map& map = *level_->get<Value::Map>();
  const auto it = map.find(key);
  return it == map.end() ? nullptr : &it->second;
}

const Value* ParameterReader::require(const char* key)
{
  const Value* value = find(key);
  if (!value)
    addError(key, " is missing");
  return value;
}

std::optional<double> ParameterReader::toNumber(const char* key, const Value& value)
{
  std::optional<double> number;
  if (const auto* real = value.get<double>())
    number = *real;
  else if (const auto* whole = value.get<long>())
    number = static_cast<double>(*whole);
  else if (const auto* text = value.get<std::string>())
    number = parseNumber(*text);
  if (number && !std::isfinite(*number))
    number.reset();
  if (!number)
    addError(key, " = " + value.show() + " is not a number");
  return number;
}

double ParameterReader::number(const char* key)
{
  const Value* value = require(key);
  return value ? toNumber(key, *value).value_or(std::numeric_limits<double>::quiet_NaN())
               : std::numeric_limits<double>::quiet_NaN();
}

double ParameterReader::number(const char* key, double fallback)
{
  const Value* value = find(key);
  return value ? toNumber(key, *value).value_or(fallback) : fallback;
}

std::optional<double> ParameterReader::optionalNumber(const char* key)
{
  const Value* value = find(key);
  return value ? toNumber(key, *value) : std::nullopt;
}

int ParameterReader::integer(const char* key)
{
  return require(key) ? integer(key, 1) : 1;
}

int ParameterReader::integer(const char* key, int fallback)
{
  const Value* value = find(key);
  if (!value)
    return fallback;
  const std::optional<double> number = toNumber(key, *value);
  if (!number)
    return fallback;
  if (*number != std::floor(*number) || std::abs(*number) > 1e9)
  {
    addError(key, " = " + value->show() + " is not a whole number");
    return fallback;
  }
  return static_cast<int>(*number);
}

bool ParameterReader::boolean(const char* key, bool fallback)
{
  const Value* value = find(key);
  if (!value)
    return fallback;
  if (const auto* boolean = value->get<bool>())
    return *boolean;
  addError(key, " = " + value->show() + " is not true or false");
  return fallback;
}

std::string ParameterReader::text(const char* key, const std::string& fallback)
{
  const Value* value = find(key);
  if (!value)
    return fallback;
  if (const auto* text = value->get<std::string>())
    return *text;
  addError(key, " = " + value->show() + " is not a text");
  return fallback;
}

core::Vector3 ParameterReader::vector(const char* key)
{
  const core::Vector3 none = core::Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
  return require(key) ? vector(key, none) : none;
}

core::Vector3 ParameterReader::vector(const char* key, const core::Vector3& fallback)
{
  const std::vector<double> x = numbers(key, {fallback.x(), fallback.y(), fallback.z()}, 3, 3);
  return {x[0], x[1], x[2]};
}

core::Vector3 ParameterReader::vector2(const char* key)
{
  const core::Vector3 none = core::Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
  return require(key) ? vector2(key, none) : none;
}

core::Vector3 ParameterReader::vector2(const char* key, const core::Vector3& fallback)
{
  const std::vector<double> x = numbers(key, {fallback.x(), fallback.y()}, 2, 2);
  return {x[0], x[1], 0.0};
}

std::vector<double> ParameterReader::numbers(const char* key, const std::vector<double>& fallback,
                                             std::size_t least, std::size_t most)
{
  const Value* value = fallback.empty() ? require(key) : find(key);
  if (!value)
    return fallback;
  const Value named = inOrder(*value);
  const auto* list = named.get<Value::List>();
  if (!list || list->size() < least || list->size() > most)
  {
    static const char* const COUNT[] = {"no", "one", "two", "three", "four"};
    addError(key, " = " + value->show() + " is not a list of " + COUNT[std::min<std::size_t>(most, 4)] +
                      (most == 1 ? " number" : " numbers"));
    return fallback;
  }
  std::vector<double> all;
  for (std::size_t i = 0; i < list->size(); ++i)
  {
    const std::string name = std::string(key) + "[" + std::to_string(i) + "]";
    const std::optional<double> number = toNumber(name.c_str(), (*list)[i]);
    if (!number)
      return fallback;
    all.push_back(*number);
  }
  return all;
}

std::string ParameterReader::textOrInteger(const char* key)
{
  const Value* value = require(key);
  if (!value)
    return "";
  if (const auto* text = value->get<std::string>())
    return *text;
  if (const auto* number = value->get<long>())
    return std::to_string(*number);
  addError(key, " = " + value->show() + " is neither a text nor a whole number");
  return "";
}

bool ParameterReader::isText(const char* key, const std::string& textOrInteger)
{
  const Value* value = find(key);
  const std::string* text = value ? value->get<std::string>() : nullptr;
  return text && *text == textOrInteger;
}

bool ParameterReader::isText(const char* key)
{
  const Value* value = find(key);
  return value && value->get<std::string>();
}

bool ParameterReader::isList(const char* key)
{
  const Value* value = find(key);
  return value && value->get<Value::List>();
}

ParameterReader ParameterReader::child(const char* key)
{
  const Value* value = find(key);
  return ParameterReader(value ? value : &EMPTY, (path_.empty() ? "" : path_ + ".") + key, errors_);
}

std::vector<ParameterReader> ParameterReader::list(const char* key)
{
  std::vector<ParameterReader> readers;
  const Value* value = find(key);
  if (!value)
    return readers;
  const auto* list = value->get<Value::List>();
  if (!list)
  {
    addError(key, " = " + value->show() + " is not a list");
    return readers;
  }
  for (std::size_t i = 0; i < list->size(); ++i)
  {
    const Value& entry = (*list)[i];
    const std::string name = std::string(key) + "[" + std::to_string(i) + "]";
    if (!entry.get<Value::Map>() && !entry.isNull())
    {
      addError(name.c_str(),
               " = " + entry.show() + " is not a map of keys, as every entry of this list has to be");
      continue;
    }
    readers.push_back(ParameterReader(&entry, (path_.empty() ? "" : path_ + ".") + name, errors_));
  }
  return readers;
}

void ParameterReader::addErrors(const std::vector<std::string>& errors)
{
  errors_->insert(errors_->end(), errors.begin(), errors.end());
}

void ParameterReader::ignoreAll()
{
  for (const auto& [key, value] : *level_->get<Value::Map>())
    known_.insert(key);
}

void ParameterReader::finish()
{
  for (const auto& [key, value] : *level_->get<Value::Map>())
    if (known_.count(key) == 0)
      addError(key.c_str(), " is not a known parameter");
}

}  // namespace tether_monitor::params
