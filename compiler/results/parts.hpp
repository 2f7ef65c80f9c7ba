#pragma once
// The parts of read_results.

#include "compiler/results/results.hpp"

namespace mbgen::results_detail {

/// A problem of a line of a file, line 0 for the whole file.
Diagnostic problem(const std::string& file, int line, std::string message, std::string hint = {});

/// Columns of a CSV file. Fails: see read_results.
Result<Results> read_csv(std::string_view text, const std::string& file);

/// Whether the bytes begin like a MAT file of level 4 or 5.
bool is_mat(std::string_view bytes);

/// Columns and run of a MAT file. Fails: see read_results.
Result<Results> read_mat(std::string_view bytes, const std::string& file);

}  // namespace mbgen::results_detail
