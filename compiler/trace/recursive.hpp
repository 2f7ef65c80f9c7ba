#pragma once
// The programs of accelerations in the recursive form.

#include "compiler/analysis/analysis.hpp"
#include "compiler/formulation/recursion_units.hpp"
#include "compiler/trace/projections.hpp"

namespace mbgen {

/// Same slots as Programs::accelerations or accelerations_chosen.
Program trace_recursive_accelerations(const Model& model, const Topology& topology, const Analysis& analysis,
                                      Partition partition = Partition::frozen, RecursionChoices choices = {});

/// The frozen program with the reference points of the blocks' bodies that take fewer operations, and these choices.
struct CheapestRecursion {
  Program program;
  RecursionChoices choices;
};
CheapestRecursion cheapest_recursion(const Model& model, const Topology& topology, const Analysis& analysis);

}  // namespace mbgen
