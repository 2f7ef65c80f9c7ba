#pragma once
// The door of the trace room: the formulation run on symbols. Every program is straight-line; iteration, pivoting and
// decisions stay in the runtime kernels that call them.

#include <optional>
#include <string>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Number of auxiliary states of a model: two per tyre (longitudinal and lateral slip deflection, m).
int auxiliary_state_count(const Model& model);

/// Names and units of the auxiliary states.
std::vector<std::string> auxiliary_state_names(const Model& model);

/// The recursive program without one treatment each, with its name.
std::vector<std::pair<std::string, Program>> trace_without(const Model& model, const Topology& topology,
                                                           const Analysis& analysis);

/// Whether a form does not grow far beyond the other one, see kMostMoreOfAForm.
bool is_worth_writing(Form form, const Topology& topology, const Analysis& analysis);

/// The form of a solver when none is asked for: the recursive one, the matrix form where a large loop block moves in so
/// many directions that the recursive form grows beyond it.
Form form_of(const Topology& topology, const Analysis& analysis);

/// The accelerations alone, with the frozen partition.
Program trace_accelerations(const Model& model, const Topology& topology, const Analysis& analysis, Form form);

/// The order of a traced program.
enum class TraceOrder {
  canonical,   ///< the same from every compiler
  as_recorded  ///< for counting: as many operations, in less time
};

/// The share of a loop block in the recursive accelerations, for counting: its joints, those that it moves on and the
/// units directly on it, without applied forces. Of the other blocks nothing is traced. partition: in place of `quasi`.
Program trace_block(const Model& model, const Topology& topology, const Analysis& analysis, int block,
                    const LoopPartition& partition, TraceOrder order);

/// Traces every program (theory.md sections 1 to 5). form: of both programs of accelerations, none for form_of.
Programs trace(const Model& model, const Topology& topology, const Analysis& analysis, std::optional<Form> form = {});

}  // namespace mbgen
