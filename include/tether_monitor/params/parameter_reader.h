#pragma once

#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tether_monitor/core/base/types.h"
#include "tether_monitor/params/parameter_value.h"

namespace tether_monitor::params
{
/// All errors of a parameter tree in one message.
class ParameterError : public std::runtime_error
{
 public:
  ParameterError(const std::string& where, const std::vector<std::string>& errors);
  const std::vector<std::string>& errors() const { return errors_; }

 private:
  std::vector<std::string> errors_;
};

/**
 * Strict reader of one level of a parameter tree.
 *
 * Every key has to be asked for: finish() reports those that were not asked for. Errors are collected, with the
 * path of the key, in the list that all readers of a tree share. A number written as a string ("1e6") is a number.
 */
class ParameterReader
{
 public:
  /// Reader of a whole tree. @param tree  must outlive the reader.
  explicit ParameterReader(const Value& tree);

  bool has(const char* key) const;
  /// The number at `key`; an error and `fallback` if it is missing (and no default is given) or not a number.
  double number(const char* key);
  double number(const char* key, double fallback);
  std::optional<double> optionalNumber(const char* key);
  /// A whole number; an error and 1 if it is missing.
  int integer(const char* key);
  int integer(const char* key, int fallback);
  bool boolean(const char* key, bool fallback);
  std::string text(const char* key, const std::string& fallback);
  /// Three numbers; NaN and an error if they are missing.
  core::Vector3 vector(const char* key);
  core::Vector3 vector(const char* key, const core::Vector3& fallback);
  /// The text or whole number at `key`, as a text; an error and "" if it is missing or anything else.
  std::string textOrInteger(const char* key);
  /// True if the value at `key` is this text; says nothing of any other value.
  bool isText(const char* key, const std::string& text);
  bool isText(const char* key);
  /// True if the value at `key` is a list; says nothing of any other value.
  bool isList(const char* key);
  /// Two numbers (z zero); NaN and an error if they are missing and there is no fallback.
  core::Vector3 vector2(const char* key);
  core::Vector3 vector2(const char* key, const core::Vector3& fallback);
  /// A list of `least` to `most` numbers, or a map of x, y, z, w; the fallback if the key is missing, with an
  /// error if the fallback is empty.
  std::vector<double> numbers(const char* key, const std::vector<double>& fallback, std::size_t least,
                              std::size_t most);
  /// Reader of the map at `key`; of an empty one if it is missing.
  ParameterReader child(const char* key);
  /// Readers of the maps in the list at `key`; none if it is missing.
  std::vector<ParameterReader> list(const char* key);
  /// Accepts a key without looking at it.
  void ignore(const char* key) { known_.insert(key); }

  /// Adds an error about the value at `key`.
  void addError(const char* key, const std::string& what);
  /// Adds errors found elsewhere, for example in problems().
  void addErrors(const std::vector<std::string>& errors);
  /// Errors so far, of this reader and all that came from it or share its tree.
  const std::vector<std::string>& errors() const { return *errors_; }
  /// For a level that cannot be understood: no key of it is reported by finish().
  void ignoreAll();
  /// Reports every key of this level that was not asked for.
  void finish();

 private:
  ParameterReader(const Value* level, std::string path, std::shared_ptr<std::vector<std::string>> errors);

  const Value* find(const char* key);
  const Value* require(const char* key);
  std::optional<double> toNumber(const char* key, const Value& value);

  const Value* level_;
  std::string path_;
  std::shared_ptr<std::vector<std::string>> errors_;
  std::set<std::string> known_;
};

}  // namespace tether_monitor::params
