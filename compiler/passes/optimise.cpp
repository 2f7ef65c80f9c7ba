#include "compiler/passes/passes.hpp"

namespace mbgen {
namespace {

struct Pass {
  const char* name;
  Program (*run)(const Program&);
};

// Dead values go first, for their divisions would count, and again, for what is merged leaves values behind.
constexpr Pass kPasses[] = {
    {"divisions by one value merged", merge_divisions},
    {"sums factored", factor_sums},
    {"sums of what that left factored", factor_sums},
};

}  // namespace

Program optimise(const Program& program) {
  Program result = remove_dead_values(program);
  for (const Pass& pass : kPasses) result = remove_dead_values(pass.run(result));
  return result;
}

std::vector<PassCount> count_passes(const Program& program) {
  std::vector<PassCount> counts;
  Program result = remove_dead_values(program);
  for (const Pass& pass : kPasses) {
    const long before = count_operations(result).total();
    result = remove_dead_values(pass.run(result));
    counts.push_back({pass.name, before, count_operations(result).total()});
  }
  return counts;
}

}  // namespace mbgen
