#pragma once
// Numbers that people write on the command line and in tables.

#include <string>

namespace mbgen::cli {

/// A finite number. Fails: UserError with `what` in front.
double parse_number(const std::string& text, const std::string& what);

}  // namespace mbgen::cli
