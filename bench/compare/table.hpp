#pragma once
// Comparisons as tables for people and as JSON for machines.

#include <string>
#include <vector>

#include "bench/compare/comparison.hpp"

namespace mbgen::compare {

/// Description of the machine: processor, caches, compiler.
std::string machine_text();

/// The table of one comparison: contestants, targets, code.
std::string table_text(const Comparison& comparison);

/// {"machine": "...", "comparisons": [...]}
std::string json_text(const std::vector<Comparison>& comparisons);

}  // namespace mbgen::compare
