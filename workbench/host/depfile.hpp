#pragma once
// The dependency file of a build tool: the files that a command has read.

#include <optional>
#include <string>
#include <vector>

#include "workbench/host/files.hpp"

namespace mbgen {

/// The rule `output: inputs` in the syntax of Make, as compilers write it with -MD.
/// Fails: UserError for the end of a line in a path, which Make cannot say.
std::string depfile_text(const std::string& output, const std::vector<std::string>& inputs);

/// That rule in a file, complete but for its name; none where `path` is empty. Fails: UserError.
std::optional<AtomicFile> depfile_of(const std::string& path, const std::string& output,
                                     const std::vector<std::string>& inputs);

}  // namespace mbgen
