#include "compiler/text/similar_words.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "compiler/text/diagnostic.hpp"

namespace mbgen {

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

namespace {

/// The first few names with the word before, between or after underscores, as in names of instances.
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

}  // namespace

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& candidates) {
  constexpr std::size_t kMostSearched = 2000, kMostListed = 8, kLongest = 128;
  if (candidates.empty() || candidates.size() > kMostSearched || word.size() > kLongest) return {};
  const int size = static_cast<int>(word.size());
  const int near = std::min(std::max(1, size / 3), size - 1);  // single letters are never similar
  int best = near + 1;
  std::string_view nearest;
  for (const std::string_view candidate : candidates) {
    if (std::abs(static_cast<int>(candidate.size()) - size) > near) continue;
    const int distance = edit_distance(word, candidate);
    if (distance >= best) continue;
    best = distance;
    nearest = candidate;
  }
  if (best <= near) return "did you mean \"" + std::string(nearest) + "\"?";
  if (const std::string placed = placed_names(word, candidates); !placed.empty()) return "did you mean " + placed + "?";
  return candidates.size() > kMostListed ? std::string() : list_of(candidates);
}

}  // namespace mbgen
