#pragma once
// The door of the passes room. A pass is a pure function Program -> Program; each header holds its contract.
// Every pass keeps name, outputs, sections, blocks and labels, and verifies its result.

#include <vector>

#include "compiler/passes/contract.hpp"
#include "compiler/passes/dead_values.hpp"
#include "compiler/passes/derived_constants.hpp"
#include "compiler/passes/factor_sums.hpp"
#include "compiler/passes/fewest_alive.hpp"
#include "compiler/passes/merge_divisions.hpp"
#include "compiler/passes/shorten_lifetimes.hpp"

namespace mbgen {

/// All passes in order: the list is the architecture.
Program optimise(const Program& program);

/// Operations before and after each pass of `optimise`.
struct PassCount {
  const char* name;
  long before = 0, after = 0;
};
std::vector<PassCount> count_passes(const Program& program);

}  // namespace mbgen
