#pragma once
// Names of the values of one program.

#include <map>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "compiler/program/program.hpp"

namespace mbgen {

/// Gives every name once.
class UniqueNames {
 public:
  /// Keeps a name for something else. Result: whether it was free.
  bool reserve(const std::string& name) { return taken_.insert(name).second; }
  /// `base`, or `base` with a number.
  std::string unique(const std::string& base);

 private:
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, int> next_number_;  ///< by base
};

/// Unique names for the values of a program.
class LocalNames : public UniqueNames {
 public:
  explicit LocalNames(const Program& program) : program_(program) {}
  /// By the label of the value, or by the number of its step and one of its own: s3_12.
  std::string of_value(ValueId value);

 private:
  const Program& program_;
  std::map<int, int> leftovers_;  ///< numbers given so far, by step
};

}  // namespace mbgen
