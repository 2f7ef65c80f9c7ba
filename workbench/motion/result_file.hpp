#pragma once
// Results as the command line reads them.

#include <string>
#include <vector>

#include "workbench/results/results.hpp"

namespace mbgen {

/// The table of a file that `simulate` wrote. The run of a CSV table is read from the file beside it, if there is one.
/// Fails: UserError, as read_results.
Results read_result_file(const std::string& path);

/// The same, or the table of a study as `sweep` wrote it.
Results read_result_or_sweep(const std::string& path);

/// Columns for a list of names, separated by commas; a name may be followed by its unit, and * stands for any letters.
/// option: where the names were typed. Fails: UserError that names the nearest column.
std::vector<int> find_columns(const Results& results, const std::string& names, const std::string& path,
                              const std::string& option = "--columns");

}  // namespace mbgen
