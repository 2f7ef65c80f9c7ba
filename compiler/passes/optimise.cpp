#include "compiler/passes/passes.hpp"

namespace mbgen {

Program optimise(const Program& program) {
  // Dead values go first, for their divisions would count, and again, for merging leaves constants behind.
  Program result = remove_dead_values(program);
  result = merge_divisions(result);
  result = factor_sums(remove_dead_values(result));
  return remove_dead_values(result);
}

}  // namespace mbgen
