#pragma once
// The program of accelerations in the recursive form.

#include "compiler/trace/trace.hpp"

namespace mbgen {

/// Same slots as Programs::accelerations.
Program trace_recursive_accelerations(const Model& model, const Topology& topology, const Analysis& analysis);

}  // namespace mbgen
