#pragma once
// Facts about the values of a program before their text is written.

#include <string>
#include <vector>

#include "compiler/emit/arrangement.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {

struct Fate {
  int users = 0;               ///< operands that are this value
  ValueId user = kNoValue;     ///< the last of them
  std::size_t part = 0;        ///< of its definition
  bool crosses = false;        ///< used in a later part
  ValueId partner = kNoValue;  ///< sine or cosine of the same angle beside this one, which no larger call computes
  std::vector<std::string> outputs;  ///< places of the result that it goes to, for the caller to fill
};

/// Per value of the program.
std::vector<Fate> decide_fates(const Program& program, const Arrangement& arrangement);

/// True for a value that only its one user needs to know: it becomes part of that user's expression.
bool can_be_inlined(const Program& program, const std::vector<Fate>& fates, ValueId value);

/// Place in the order of the last value of each section.
std::vector<std::size_t> section_ends(const Program& program, const Arrangement& arrangement);

}  // namespace mbgen
