#pragma once
// The door of the trace room: the formulation run on symbols. Every program is straight-line; iteration, pivoting and
// decisions stay in the runtime kernels that call them.

#include <optional>

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Whether a form does not grow far beyond the other one, see kMostMoreOfAForm.
bool is_worth_writing(Form form, const Topology& topology, const Analysis& analysis);

/// The form of a solver when none is asked for: the recursive one, the matrix form where a large loop block moves in so
/// many directions that the recursive form grows beyond it.
Form form_of(const Topology& topology, const Analysis& analysis);

/// The accelerations alone, with the frozen partition.
Program trace_accelerations(const Model& model, const Topology& topology, const Analysis& analysis, Form form);

/// Traces every program (theory.md sections 1 to 5). form: of both programs of accelerations, none for form_of.
Programs trace(const Model& model, const Topology& topology, const Analysis& analysis, std::optional<Form> form = {});

}  // namespace mbgen
