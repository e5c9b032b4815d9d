#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace tether_monitor::params
{
/// A parameter or a subtree, as a YAML file or the parameter server hold it.
class Value
{
 public:
  using List = std::vector<Value>;
  using Map = std::map<std::string, Value>;

  Value() = default;
  Value(bool x) : data_(x) {}                    // NOLINT: a value is what it holds
  Value(double x) : data_(x) {}                  // NOLINT
  Value(long x) : data_(x) {}                    // NOLINT
  Value(std::string x) : data_(std::move(x)) {}  // NOLINT
  Value(List x) : data_(std::move(x)) {}         // NOLINT
  Value(Map x) : data_(std::move(x)) {}          // NOLINT

  template <typename T>
  const T* get() const
  {
    return std::get_if<T>(&data_);
  }
  bool isNull() const { return std::holds_alternative<std::monostate>(data_); }

  /// The value as a fault text shows it: 'stiff', 3.5, true, a list, a map, nothing.
  std::string show() const;

 private:
  std::variant<std::monostate, bool, long, double, std::string, List, Map> data_;
};

}  // namespace tether_monitor::params
