#pragma once
// Tables as MAT files of level 4.

#include <string>
#include <string_view>

#include "compiler/text/diagnostic.hpp"
#include "workbench/results/table.hpp"

namespace mbgen {

/// A MAT file of level 4: `data` (rows by columns), `names` and `units` (one row of text a column, blanks behind) and
/// `run` (JSON text). MATLAB, Octave and scipy.io.loadmat read it.
std::string mat_text(const Results& results);

/// Whether the bytes begin like a MAT file of level 4 or 5.
bool is_mat(std::string_view bytes);

/// Columns and run of a MAT file. Fails: see read_results.
Result<Results> read_mat(std::string_view bytes, const std::string& file);

}  // namespace mbgen
