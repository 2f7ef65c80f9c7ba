#pragma once
// Names of a model: what is allowed, what they refer to, and which one was probably meant.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/model/diagnostic.hpp"
#include "compiler/model/expression.hpp"

namespace mbgen::reading {

constexpr std::size_t kLongestName = 64;
constexpr const char* kNameRule =
    "a name has letters, digits and _, does not start with a digit, and is at most 64 long";

constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_valid_name(std::string_view name);

/// Insertions, deletions, replacements and swaps of neighbours between two words. Cost: product of the lengths.
int edit_distance(std::string_view a, std::string_view b);

using mbgen::did_you_mean;

template <class Target>
using NameMap = std::map<std::string, Target, std::less<>>;

template <class Target>
std::string did_you_mean(std::string_view word, const NameMap<Target>& names) {
  std::vector<std::string_view> candidates;
  for (const auto& [name, target] : names) candidates.push_back(name);
  return did_you_mean(word, candidates);
}

/// Every name that an element may refer to, with its index in the Model.
struct Names {
  NameMap<int> later_parameters;  ///< defined, but further below than what is being read
  NameMap<int> parameters, inputs, bodies, joints, rods, springs, air_springs, tyre_data, tyres, motions;
  NameMap<CoordinateReference> coordinates;
  std::vector<NameMap<int>> points;     ///< per body
  std::vector<bool> points_unreadable;  ///< per body: no complaint about points that are not there
  std::vector<std::string>
      unreadable_joints;  ///< their coordinates are unknown: no complaint about names that start so
};

/// True when the name may be a coordinate of a joint that could not be read.
bool may_be_unreadable(const Names& names, std::string_view coordinate);

}  // namespace mbgen::reading
