#pragma once
// Dependency file for a build tool: the files read by a command.

#include <optional>
#include <string>
#include <vector>

#include "workbench/host/files.hpp"

namespace mbgen {

/// The rule `output: inputs` in the syntax of Make, as written by compilers with -MD. Fails: UserError for a line end
/// in a path, which Make cannot express.
std::string depfile_text(const std::string& output, const std::vector<std::string>& inputs);

/// The same rule in a file, complete but not yet committed; none for an empty `path`. Fails: UserError.
std::optional<AtomicFile> depfile_of(const std::string& path, const std::string& output,
                                     const std::vector<std::string>& inputs);

}  // namespace mbgen
