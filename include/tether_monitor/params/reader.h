#pragma once

#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tether_monitor/core/types.h"
#include "tether_monitor/params/value.h"

namespace tether_monitor::params
{
/// All faults of a parameter tree in one message.
class ParamError : public std::runtime_error
{
 public:
  ParamError(const std::string& where, const std::vector<std::string>& faults);
  const std::vector<std::string>& faults() const { return faults_; }

 private:
  std::vector<std::string> faults_;
};

/**
 * Strict reader of one level of a parameter tree.
 *
 * Every key has to be asked for: finish() reports those that nobody wanted. Faults are collected, with the path of
 * the key, in the list that all readers of a tree share. A number written as a string ("1e6") is a number.
 */
class Reader
{
 public:
  /// Reader of a whole tree. @param tree  must outlive the reader.
  explicit Reader(const Value& tree);

  bool has(const char* key) const;
  /// The number at `key`; a fault and `fallback` if it is missing (and no default is given) or not a number.
  double number(const char* key);
  double number(const char* key, double fallback);
  std::optional<double> optionalNumber(const char* key);
  /// A whole number; a fault and 1 if it is missing.
  int integer(const char* key);
  int integer(const char* key, int fallback);
  bool flag(const char* key, bool fallback);
  std::string text(const char* key, const std::string& fallback);
  /// Three numbers; NaN and a fault if they are missing.
  core::Vector3 vector(const char* key);
  core::Vector3 vector(const char* key, const core::Vector3& fallback);
  /// The text or whole number at `key`, as a text; a fault and "" if it is missing or anything else.
  std::string word(const char* key);
  /// True if the value at `key` is this text; says nothing of any other value.
  bool says(const char* key, const std::string& word);
  /// Two numbers (z zero); NaN and a fault if they are missing and there is no fallback.
  core::Vector3 pair(const char* key);
  core::Vector3 pair(const char* key, const core::Vector3& fallback);
  /// A list of `least` to `most` numbers, or a map of x, y, z, w; the fallback if the key is missing, with a fault
  /// if the fallback is empty.
  std::vector<double> numbers(const char* key, const std::vector<double>& fallback, std::size_t least,
                              std::size_t most);
  /// Reader of the map at `key`; of an empty one if it is missing.
  Reader child(const char* key);
  /// Readers of the maps in the list at `key`; none if it is missing.
  std::vector<Reader> children(const char* key);
  /// Accepts a key without looking at it.
  void ignore(const char* key) { wanted_.insert(key); }

  /// Adds a fault of the value at `key`.
  void fault(const char* key, const std::string& what);
  /// Adds faults found elsewhere, for example in problems().
  void report(const std::vector<std::string>& faults);
  /// Faults so far, of this reader and all that came from it or share its tree.
  const std::vector<std::string>& faults() const { return *faults_; }
  /// Reports every key of this level that was not asked for.
  void finish();

 private:
  Reader(const Value* level, std::string path, std::shared_ptr<std::vector<std::string>> faults);

  const Value* find(const char* key);
  const Value* require(const char* key);
  std::optional<double> toNumber(const char* key, const Value& value);

  const Value* level_;
  std::string path_;
  std::shared_ptr<std::vector<std::string>> faults_;
  std::set<std::string> wanted_;
};

}  // namespace tether_monitor::params
