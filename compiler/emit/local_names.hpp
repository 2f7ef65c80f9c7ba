#pragma once
// Names of the values of one program.

#include <map>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "compiler/program/program.hpp"

namespace mbgen {

/// Gives every name once.
class LocalNames {
 public:
  explicit LocalNames(const Program& program) : program_(program) {}

  /// Keeps a name for something else.
  void reserve(const std::string& name) { taken_.insert(name); }
  /// `base`, or `base` with a number.
  std::string unique(const std::string& base);
  /// By the label of the value, or by its section and a number: s3_12.
  std::string of_value(ValueId value);

 private:
  const Program& program_;
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, int> next_number_;  ///< by base
  std::map<std::string, int> leftovers_;              ///< numbers given so far, by section
};

}  // namespace mbgen
