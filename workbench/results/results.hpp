#pragma once
// The door of the results room: tables of a motion as files, CSV or MAT (level 4), written and read.

#include <string>
#include <string_view>

#include "compiler/text/diagnostic.hpp"
#include "workbench/results/csv.hpp"
#include "workbench/results/faults.hpp"
#include "workbench/results/mat.hpp"
#include "workbench/results/sweep.hpp"
#include "workbench/results/table.hpp"

namespace mbgen {

/// Reads a table that `mbgen simulate` wrote; its bytes say whether it is CSV or MAT. file, hint: for messages.
/// Ensures: every number is finite, time increases.
/// Fails: a file without rows, a row of another length than the header, a field that is no finite number, time that
/// does not increase or does not stand first, a heading that stands twice, a MAT file of another level, byte order or
/// make.
Result<Results> read_results(std::string_view bytes, const std::string& file,
                             const char* hint = "a result is a table of mbgen simulate");

}  // namespace mbgen
