#pragma once
// Similar words, for hints.

#include <string>
#include <string_view>
#include <vector>

namespace mbgen {

/// Insertions, deletions, replacements and swaps of neighbours between two words. Cost: product of the lengths.
int edit_distance(std::string_view a, std::string_view b);

/// "known: a, b, c".
std::string list_of(const std::vector<std::string_view>& candidates);

}  // namespace mbgen
