#include "compiler/expressions/names.hpp"

#include <algorithm>

namespace mbgen::reading {

bool is_valid_name(std::string_view name) {
  return !name.empty() && name.size() <= kLongestName && is_letter(name[0]) &&
         std::all_of(name.begin(), name.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

bool may_be_unreadable(const Names& names, std::string_view coordinate) {
  return std::any_of(names.unreadable_joints.begin(), names.unreadable_joints.end(),
                     [&](const std::string& joint) { return coordinate.starts_with(joint); });
}

std::string full_name(const Level& level, std::string_view name) {
  return level.before + std::string(name) + level.after;
}

std::string_view name_from_inside(std::string_view full, const Visibility& visible) {
  for (const Level& level : visible) {
    const std::size_t affixes = level.before.size() + level.after.size();
    if (full.size() > affixes && full.starts_with(level.before) && full.ends_with(level.after))
      return full.substr(level.before.size(), full.size() - affixes);
  }
  return full;
}

const CoordinateReference* find_coordinate(const Names& names, std::string_view name, const Visibility& visible) {
  for (const Level& level : visible) {
    if (level.scope >= names.coordinates.size()) continue;
    const auto& coordinates = names.coordinates[level.scope];
    if (const auto found = coordinates.find(name); found != coordinates.end()) return &found->second;
  }
  return nullptr;
}

}  // namespace mbgen::reading
