#pragma once
// Tunable parameters with the constants that follow from them: the type Tuned, which every function of a solver takes.

#include <string>

#include "compiler/trace/trace.hpp"

namespace mbgen {

/// Struct Tuned, another name of Parameters where nothing follows from them. scalar: type of its values.
std::string tuned_type_text(const Programs& programs, const std::string& scalar);

/// The constructor of the struct, which calls the program of the derived constants; empty without them.
std::string tuned_constructor_text(const Programs& programs);

}  // namespace mbgen
