#pragma once
// Differences between slices of a loop: linear functions of the slice `k`, and tables.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "compiler/emit/local_names.hpp"

namespace mbgen {

/// Common part of the labels of one value in two slices: "R_up_xx" of "R_up1_xx" and "R_up2_xx".
std::string common_label(const std::string& a, const std::string& b);

/// Name of a pair: "R_up_left_and_right_xx" of "R_up_left_xx" and "R_up_right_xx".
std::string label_of_both(const std::string& first, const std::string& second);

/// The tables of one function.
class SliceTables {
 public:
  explicit SliceTables(UniqueNames& names) : names_(names) {}
  /// Forgets the tables before another function.
  void start_part() { tables_.clear(); }
  /// An index for each slice: a linear function of k, or a table.
  std::string index(const std::vector<int>& indices);
  /// `name[k]` of a table with these items.
  std::string item(const std::string& type, const std::string& base, const std::vector<std::string>& items);
  /// Declarations of the tables used since the last call, to be placed before the loop.
  std::string declarations() { return std::exchange(declarations_, ""); }

 private:
  UniqueNames& names_;
  std::map<std::pair<std::string, std::vector<std::string>>, std::string> tables_;  ///< names
  std::string declarations_;
};

}  // namespace mbgen
