#pragma once
// A model compiled by a command, with its progress.

#include <optional>

#include "compiler/compile.hpp"

namespace mbgen::cli {

/// Shows the stages where they take long. Fails: UserError with the problems of the model.
Compilation compiled(Model model, std::optional<Form> form = {});

}  // namespace mbgen::cli
