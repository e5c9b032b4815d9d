#include "tether_monitor/params/reader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace tether_monitor::params
{
namespace
{
const Value EMPTY{Value::Map{}};

std::string joined(const std::string& where, const std::vector<std::string>& faults)
{
  std::string text = std::to_string(faults.size()) + " problem(s) with the parameters in " + where + ":";
  for (const std::string& fault : faults)
    text += "\n  - " + fault;
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

ParamError::ParamError(const std::string& where, const std::vector<std::string>& faults)
  : std::runtime_error(joined(where, faults)), faults_(faults)
{
}

Reader::Reader(const Value& tree) : Reader(&tree, "", std::make_shared<std::vector<std::string>>())
{
}

Reader::Reader(const Value* level, std::string path, std::shared_ptr<std::vector<std::string>> faults)
  : level_(level), path_(std::move(path)), faults_(std::move(faults))
{
  if (level_->get<Value::Map>())
    return;
  if (!level_->isNull())
    faults_->push_back((path_.empty() ? "the tree" : path_) + " = " + level_->show() + " is not a map of keys");
  level_ = &EMPTY;
}

void Reader::fault(const char* key, const std::string& what)
{
  faults_->push_back((path_.empty() ? "" : path_ + ".") + key + what);
}

bool Reader::has(const char* key) const
{
  return level_->get<Value::Map>()->count(key) > 0;
}

const Value* Reader::find(const char* key)
{
  wanted_.insert(key);
  const Value::Map& map = *level_->get<Value::Map>();
  const auto it = map.find(key);
  return it == map.end() ? nullptr : &it->second;
}

const Value* Reader::require(const char* key)
{
  const Value* value = find(key);
  if (!value)
    fault(key, " is missing");
  return value;
}

std::optional<double> Reader::toNumber(const char* key, const Value& value)
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
    fault(key, " = " + value.show() + " is not a number");
  return number;
}

double Reader::number(const char* key)
{
  const Value* value = require(key);
  return value ? toNumber(key, *value).value_or(std::numeric_limits<double>::quiet_NaN())
               : std::numeric_limits<double>::quiet_NaN();
}

double Reader::number(const char* key, double fallback)
{
  const Value* value = find(key);
  return value ? toNumber(key, *value).value_or(fallback) : fallback;
}

std::optional<double> Reader::optionalNumber(const char* key)
{
  const Value* value = find(key);
  return value ? toNumber(key, *value) : std::nullopt;
}

int Reader::integer(const char* key)
{
  return require(key) ? integer(key, 1) : 1;
}

int Reader::integer(const char* key, int fallback)
{
  const Value* value = find(key);
  if (!value)
    return fallback;
  const std::optional<double> number = toNumber(key, *value);
  if (!number)
    return fallback;
  if (*number != std::floor(*number) || std::abs(*number) > 1e9)
  {
    fault(key, " = " + value->show() + " is not a whole number");
    return fallback;
  }
  return static_cast<int>(*number);
}

bool Reader::flag(const char* key, bool fallback)
{
  const Value* value = find(key);
  if (!value)
    return fallback;
  if (const auto* flag = value->get<bool>())
    return *flag;
  fault(key, " = " + value->show() + " is not true or false");
  return fallback;
}

std::string Reader::text(const char* key, const std::string& fallback)
{
  const Value* value = find(key);
  if (!value)
    return fallback;
  if (const auto* text = value->get<std::string>())
    return *text;
  fault(key, " = " + value->show() + " is not a text");
  return fallback;
}

core::Vector3 Reader::vector(const char* key)
{
  const core::Vector3 none = core::Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
  return require(key) ? vector(key, none) : none;
}

core::Vector3 Reader::vector(const char* key, const core::Vector3& fallback)
{
  const std::vector<double> x = numbers(key, {fallback.x(), fallback.y(), fallback.z()}, 3, 3);
  return {x[0], x[1], x[2]};
}

core::Vector3 Reader::pair(const char* key)
{
  const core::Vector3 none = core::Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
  return require(key) ? pair(key, none) : none;
}

core::Vector3 Reader::pair(const char* key, const core::Vector3& fallback)
{
  const std::vector<double> x = numbers(key, {fallback.x(), fallback.y()}, 2, 2);
  return {x[0], x[1], 0.0};
}

std::vector<double> Reader::numbers(const char* key, const std::vector<double>& fallback, std::size_t least,
                                    std::size_t most)
{
  const Value* value = fallback.empty() ? require(key) : find(key);
  if (!value)
    return fallback;
  const Value named = inOrder(*value);
  const auto* list = named.get<Value::List>();
  if (!list || list->size() < least || list->size() > most)
  {
    static const char* const COUNT[] = {"no", "one", "two", "three", "four"};
    fault(key, " = " + value->show() + " is not a list of " + COUNT[std::min<std::size_t>(most, 4)] +
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

std::string Reader::word(const char* key)
{
  const Value* value = require(key);
  if (!value)
    return "";
  if (const auto* text = value->get<std::string>())
    return *text;
  if (const auto* number = value->get<long>())
    return std::to_string(*number);
  fault(key, " = " + value->show() + " is not a word");
  return "";
}

bool Reader::says(const char* key, const std::string& word)
{
  const Value* value = find(key);
  const std::string* text = value ? value->get<std::string>() : nullptr;
  return text && *text == word;
}

Reader Reader::child(const char* key)
{
  const Value* value = find(key);
  return Reader(value ? value : &EMPTY, (path_.empty() ? "" : path_ + ".") + key, faults_);
}

std::vector<Reader> Reader::children(const char* key)
{
  std::vector<Reader> readers;
  const Value* value = find(key);
  if (!value)
    return readers;
  const auto* list = value->get<Value::List>();
  if (!list)
  {
    fault(key, " = " + value->show() + " is not a list");
    return readers;
  }
  for (std::size_t i = 0; i < list->size(); ++i)
    readers.push_back(
        Reader(&(*list)[i], (path_.empty() ? "" : path_ + ".") + key + "[" + std::to_string(i) + "]", faults_));
  return readers;
}

void Reader::report(const std::vector<std::string>& faults)
{
  faults_->insert(faults_->end(), faults.begin(), faults.end());
}

void Reader::finish()
{
  for (const auto& [key, value] : *level_->get<Value::Map>())
    if (wanted_.count(key) == 0)
      fault(key.c_str(), " is not a known parameter");
}

}  // namespace tether_monitor::params
