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

/// Reads any table of numbers in comma separated values with a header. expected: the kind of file, for messages.
/// Fails: as read_sweep.
Result<Results> read_table(std::string_view text, const std::string& file, const char* expected);

}  // namespace mbgen
