#pragma once
// Names of a model: which are allowed, which elements they refer to, and which name was probably meant.

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/expressions/expression.hpp"
#include "compiler/text/diagnostic.hpp"
#include "compiler/text/similar_words.hpp"

namespace mbgen::reading {

constexpr std::size_t kLongestName = 64;
constexpr const char* kNameRule =
    "a name has letters, digits and _, does not start with a digit, and is at most 64 long";

constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_valid_name(std::string_view name);

using mbgen::did_you_mean;
using mbgen::list_of;

template <class Target>
using NameMap = std::map<std::string, Target, std::less<>>;

template <class Target>
std::string did_you_mean(std::string_view word, const NameMap<Target>& names) {
  std::vector<std::string_view> candidates;
  for (const auto& [name, target] : names) candidates.push_back(name);
  return did_you_mean(word, candidates);
}

/// The file of the model with its includes, or an instance: where names are defined, and the texts that the model puts
/// before and after them.
struct Level {
  std::size_t scope = 0;  ///< index into Reader::scopes: the first with these two
  std::string before, after;
};

/// Where a name is looked for: in its own instance, then in the instance that places that one, last in the model
/// itself.
using Visibility = std::vector<Level>;

/// The name that the model gives to an element that is called `name` inside.
std::string full_name(const Level& level, std::string_view name);

/// The nearest element of that name.
template <class Target>
typename NameMap<Target>::const_iterator find_visible(const NameMap<Target>& names, std::string_view name,
                                                      const Visibility& visible) {
  for (const Level& level : visible) {
    if (const auto found = names.find(full_name(level, name)); found != names.end()) return found;
  }
  return names.end();
}

/// How a full name is written at the innermost level.
std::string_view name_from_inside(std::string_view full, const Visibility& visible);

template <class Target>
std::string did_you_mean(std::string_view word, const NameMap<Target>& names, const Visibility& visible) {
  std::vector<std::string_view> candidates;
  for (const auto& [name, target] : names) candidates.push_back(name_from_inside(name, visible));
  return did_you_mean(word, candidates);
}

/// Elements of one kind with a length, which expressions see as length.NAME and rate.NAME.
struct LengthNames {
  std::string kind;  ///< "a spring"
  NameMap<int> names = {};
};

/// Every name that an element may refer to, as the model knows it, with its index in the Model.
struct Names {
  NameMap<int> later_parameters;  ///< defined, but below the parameter that is being read
  NameMap<int> values;            ///< states, then sampled values
  NameMap<int> outputs;
  NameMap<int> named_values;                          ///< expressions under a name: index into Model::expressions
  NameMap<std::shared_ptr<const NamedTable>> tables;  ///< null: the table could not be read
  NameMap<int> parameters, inputs, bodies, joints, rods, couplings, tyre_data, motions, roads;
  std::vector<LengthNames> lengths;                       ///< kind by kind; rods follow them
  std::vector<NameMap<CoordinateReference>> coordinates;  ///< per Level::scope, as they are called there
  std::vector<std::size_t> body_scopes;                   ///< per body: the scope that defines it
  std::vector<NameMap<int>> points;                       ///< per body
  std::vector<bool> points_unreadable;                    ///< per body: no complaint about points that are not there
  std::vector<std::string>
      unreadable_joints;  ///< their coordinates are unknown: no complaint about names that start so
  /// coordinates of mirrored instances that kept their direction: names inside the instance mean the opposite one
  std::vector<CoordinateReference> reversed;
};

inline std::string reversed_message(std::string_view coordinate) {
  return "coordinate \"" + std::string(coordinate) + "\" counts the other way in this mirrored instance";
}
constexpr const char* kReversedHint =
    "move it to the model that places the instance, or leave out \"coordinates\": \"parallel\"";

/// The nearest coordinate of that name, or nullptr.
const CoordinateReference* find_coordinate(const Names& names, std::string_view name, const Visibility& visible);

/// True when the name may be a coordinate of a joint that could not be read.
bool may_be_unreadable(const Names& names, std::string_view coordinate);

}  // namespace mbgen::reading
