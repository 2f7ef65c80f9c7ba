#pragma once
// Names that emitted code cannot give to elements of the model.

#include <string_view>

namespace mbgen {

/// Names that no identifier may have: keywords, names of emitted code, and names that are or may be macros, as every
/// UPPER_CASE name with an underscore.
bool is_reserved(std::string_view name);

/// Names that the solver's namespace and build target may not have besides: `main`, functions and types that C headers
/// declare in the global namespace, targets that CMake keeps for itself.
bool is_reserved_for_solvers(std::string_view name);

}  // namespace mbgen
