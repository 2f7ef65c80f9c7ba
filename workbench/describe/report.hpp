#pragma once
// The report of `inspect`.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "workbench/describe/counts.hpp"

namespace mbgen {

/// Counts, loop blocks, path matrix, coordinates and operations. Bodies and joints are counted as in the paper: a joint
/// of several freedoms is a chain of single-freedom joints with massless bodies between them; ground is a body.
nlohmann::ordered_json make_report(const Compilation& compilation, const Counts& counts);

/// Words after a title, wrapped; empty without words.
std::string wrapped(const std::string& title, const std::vector<std::string>& words);

/// The redundancy certificates of a report's loop blocks as tables for people; empty without loops.
std::string redundancy_text(const nlohmann::ordered_json& report);

/// Candidate partitions of each loop block of the recursive form, per block: an array.
nlohmann::ordered_json report_partitions(const Compilation& compilation);

/// Candidate partitions of a report as tables; empty if no block has a choice.
std::string partitions_text(const nlohmann::ordered_json& report);

/// The whole report as tables for people.
std::string report_text(const nlohmann::ordered_json& report);

}  // namespace mbgen
