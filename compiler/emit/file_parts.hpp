#pragma once
// Parts of a large source file, which a compiler can take side by side.

#include <cstddef>
#include <string>
#include <vector>

#include "compiler/emit/layout.hpp"

namespace mbgen {

/// Gives programs that run rarely the parts 1, 2, ... of the file, each with at least so many values; the rest of the
/// file is part 0. A file with fewer such values stays whole. Result: the number of parts beside part 0.
int divide_file(std::vector<ShapedProgram>& programs, std::size_t least_values);

/// Text that belongs to one part of the file alone.
std::string in_file_part(int part, const std::string& text);

/// What stands before the first namespace of a file with so many parts beside part 0.
std::string file_parts_text(int rare_parts);

/// The programs of a divided file, between the constants of the model and the struct System. hot, shared: of part 0,
/// and those that the parts call across.
std::string divided_programs(const std::string& hot, const std::string& shared);

}  // namespace mbgen
