#pragma once
// Tables of a study.

#include <string>
#include <string_view>

#include "compiler/text/diagnostic.hpp"
#include "workbench/results/table.hpp"

namespace mbgen {

/// Whether a text is the table of a study, as `mbgen sweep` writes it: its first column is "case".
bool is_sweep(std::string_view bytes);

/// Reads the table of a study, without its column of states. Values of cases that failed are NaN.
/// Fails: no rows, a row of another length than the header, a field that is neither empty nor a finite number.
Result<Results> read_sweep(std::string_view text, const std::string& file);

}  // namespace mbgen
