#pragma once
// The recursive form with the treatments that take fewest operations: each is traced and counted.

#include <optional>

#include "compiler/trace/trace.hpp"

namespace mbgen {

/// The frozen program with the reference points of the blocks' bodies, and other treatments, that take fewer operations
/// once equal values are merged.
TracedRecursion cheapest_recursion(const Model& model, const Topology& topology, const Analysis& analysis);

/// The accelerations alone, with the frozen partition.
Program trace_accelerations(const Model& model, const Topology& topology, const Analysis& analysis, Form form);

/// Every program, see trace. form: of both programs of accelerations, none for form_of.
WholePrograms traced_programs(const Model& model, const Topology& topology, const Analysis& analysis,
                              std::optional<Form> form = {});

/// The same equations for people, see trace_for_reading.
Programs programs_for_reading(const Model& model, const Topology& topology, const Analysis& analysis, Form form);

}  // namespace mbgen
