#pragma once
// The program of accelerations in the recursive form.

#include "compiler/formulation/recursion_units.hpp"
#include "compiler/trace/trace.hpp"

namespace mbgen {

/// Same slots as Programs::accelerations.
Program trace_recursive_accelerations(const Model& model, const Topology& topology, const Analysis& analysis,
                                      RecursionChoices choices = {});

/// The same with the reference points of the blocks' bodies that take fewer operations.
Program cheapest_recursion(const Model& model, const Topology& topology, const Analysis& analysis);

}  // namespace mbgen
