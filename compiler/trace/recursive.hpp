#pragma once
// The programs of accelerations in the recursive form.

#include <cstddef>

#include "compiler/formulation/recursion_units.hpp"
#include "compiler/trace/tracing.hpp"

namespace mbgen {

/// Where the projections of the loop blocks come from.
enum class Partition {
  frozen,  ///< from the partition that the analysis chose
  chosen   ///< from inputs Rz<b>, zdd_star<b>: a partition chosen at run time
};

/// The projection of a block as inputs of the program.
GroupProjection<Expr> chosen_projection(Tracing& tracing, std::size_t block);

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
