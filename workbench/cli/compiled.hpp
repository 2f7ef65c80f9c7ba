#pragma once
// A model compiled by a command, with its progress.

#include "compiler/compile.hpp"

namespace mbgen::cli {

/// Shows the stages where they take long, in place of options.watch. Fails: UserError with the problems of the model.
Compilation compiled(Model model, CompileOptions options = {});

}  // namespace mbgen::cli
