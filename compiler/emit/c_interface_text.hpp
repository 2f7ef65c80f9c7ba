#pragma once
// The C interface of a solver, and a Python module over it.

#include <string>

#include "compiler/emit/interface_text.hpp"

namespace mbgen {

/// banner_text as one comment of C.
std::string c_banner_text(const Model& model);

/// FOUR_BAR_, for macros.
std::string guard_of(const std::string& solver);

/// `<model>_c.h`, C99.
std::string c_header_text(const EmitContext& context);

/// `<model>_c.cpp`. Requires: context.initial.
std::string c_source_text(const EmitContext& context);

/// `<model>.py`: ctypes and numpy over the shared library, nothing to compile.
std::string python_text(const EmitContext& context);

}  // namespace mbgen
