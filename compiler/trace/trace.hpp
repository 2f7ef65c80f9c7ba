#pragma once
// The door of the trace room: the formulation run on symbols. Every program is straight-line; iteration, pivoting and
// decisions stay in the runtime kernels that call them.

#include <optional>

#include "compiler/analysis/analysis.hpp"
#include "compiler/formulation/recursion/recursion_units.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Whether a form does not grow far beyond the other one, see kMostMoreOfAForm.
bool is_worth_writing(Form form, const Topology& topology, const Analysis& analysis);

/// The form of a solver when none is asked for: the recursive one, the matrix form where a large loop block moves in so
/// many directions that the recursive form grows beyond it.
Form form_of(const Topology& topology, const Analysis& analysis);

/// The accelerations of the recursive form with the frozen partition, and the choices that they are made by.
struct TracedRecursion {
  Program program;
  RecursionChoices choices;
};

/// Traces every program (theory.md sections 1 to 5): in the recursive form where its accelerations are given, which
/// compiler/choose knows, else in the matrix form.
WholePrograms trace(const Model& model, const Topology& topology, const Analysis& analysis,
                    std::optional<TracedRecursion> recursion);

/// The same for people: names for all that has one, no laws apart. choices: of the recursive form, none for the matrix
/// form.
Programs trace_for_reading(const Model& model, const Topology& topology, const Analysis& analysis,
                           std::optional<RecursionChoices> choices);

/// Inputs of the accelerations that belong to alike parts, results of their shared laws among them; none of the matrix
/// form, which is not written in pairs.
AlikeInputs alike_inputs(const Model& model, const Topology& topology, const WholePrograms& whole);

}  // namespace mbgen
