#include "compiler/expressions/names.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace mbgen::reading {

bool is_valid_name(std::string_view name) {
  return !name.empty() && name.size() <= kLongestName && is_letter(name[0]) &&
         std::all_of(name.begin(), name.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

int edit_distance(std::string_view a, std::string_view b) {
  const std::size_t columns = b.size() + 1;
  std::vector<int> before_last(columns), last(columns), row(columns);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string list_of(const std::vector<std::string_view>& candidates) {
  std::string known = "known: ";
  for (std::size_t i = 0; i < candidates.size(); ++i) known += (i ? ", " : "") + std::string(candidates[i]);
  return known;
}

bool may_be_unreadable(const Names& names, std::string_view coordinate) {
  return std::any_of(names.unreadable_joints.begin(), names.unreadable_joints.end(),
                     [&](const std::string& joint) { return coordinate.starts_with(joint); });
}

}  // namespace mbgen::reading

namespace mbgen {

/// The first few names that have the word between or beside underscores, as the parts of an instance have its prefix.
std::string placed_names(std::string_view word, const std::vector<std::string_view>& candidates) {
  constexpr std::size_t kShortest = 3, kMostNamed = 3;
  if (word.size() < kShortest) return {};
  const std::string within = "_" + std::string(word) + "_";
  std::vector<std::string_view> found;
  for (const std::string_view candidate : candidates) {
    if (("_" + std::string(candidate) + "_").find(within) != std::string::npos) found.push_back(candidate);
  }
  const bool are_more = found.size() > kMostNamed;
  std::string text;
  for (std::size_t i = 0; i < std::min(found.size(), kMostNamed); ++i) {
    const bool is_last = !are_more && i > 0 && i + 1 == found.size();
    text += (i == 0 ? "\"" : is_last ? " or \"" : ", \"") + std::string(found[i]) + "\"";
  }
  return are_more ? text + " ..." : text;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& candidates) {
  constexpr std::size_t kMostSearched = 2000, kMostListed = 8;
  if (candidates.empty() || candidates.size() > kMostSearched || word.size() > 2 * reading::kLongestName) return {};
  const int size = static_cast<int>(word.size());
  const int near = std::min(std::max(1, size / 3), size - 1);  // one letter is not like another
  int best = near + 1;
  std::string_view nearest;
  for (const std::string_view candidate : candidates) {
    if (std::abs(static_cast<int>(candidate.size()) - size) > near) continue;
    const int distance = reading::edit_distance(word, candidate);
    if (distance >= best) continue;
    best = distance;
    nearest = candidate;
  }
  if (best <= near) return "did you mean \"" + std::string(nearest) + "\"?";
  if (const std::string placed = placed_names(word, candidates); !placed.empty()) return "did you mean " + placed + "?";
  return candidates.size() > kMostListed ? std::string() : reading::list_of(candidates);
}

}  // namespace mbgen

namespace mbgen::reading {

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
