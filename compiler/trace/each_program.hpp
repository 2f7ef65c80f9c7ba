#pragma once
// The programs of a solver one by one, each in the frames and by the rows of a form. Inside the trace room, and for
// whoever counts what a choice costs.

#include <optional>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/formulation/recursion/recursion_units.hpp"
#include "compiler/model/model.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// The nine steps of the paper. role: accelerations, or accelerations_chosen with the projections of the loop blocks as
/// inputs.
Program trace_matrix_accelerations(const Model& model, const Topology& topology, const Analysis& analysis, Role role,
                                   Spelling spelling = Spelling::fast);

/// The same by recursion. laws: that are left to programs of their own.
Program trace_recursive_accelerations(const Model& model, const Topology& topology, const Analysis& analysis,
                                      Role role = Role::accelerations, RecursionChoices choices = {},
                                      const std::vector<SharedLaw>& laws = {}, Spelling spelling = Spelling::fast);

/// Mirror images of the inputs of the accelerations, results of these laws among them; empty where the mechanism has no
/// mirror.
std::vector<MirroredInput> mirrored_inputs(const Model& model, const Topology& topology,
                                           const std::vector<SharedLaw>& laws);

/// Inputs of the accelerations that belong to parts of the mechanism which are equal, results of these laws among them.
std::vector<TwinInput> twin_inputs(const Model& model, const Topology& topology, const std::vector<SharedLaw>& laws);

/// The laws of tyres that have one set of coefficients, each of two or more, and the recursive accelerations around
/// them; none where no law has two tyres.
std::optional<AroundLaws> trace_around_laws(const Model& model, const Topology& topology, const Analysis& analysis,
                                            RecursionChoices choices);

/// Newton correction of positions and consistent velocities by the frozen factors (60), (61).
Program trace_closure(const Model& model, const Topology& topology, const Analysis& analysis, Form form,
                      Spelling spelling = Spelling::fast);

/// Residuals, Jacobian and acceleration right-hand side of every block.
Program trace_closure_terms(const Model& model, const Topology& topology, const Analysis& analysis, Form form,
                            Spelling spelling = Spelling::fast);

/// Multipliers and driving forces in the frozen order (theory.md section 4).
Program trace_multipliers(const Model& model, const Topology& topology, const Analysis& analysis, Form form,
                          Spelling spelling = Spelling::fast);

/// Outputs of the model and its energies. Multipliers come from outside, so that they are right where the frozen
/// partition is not; without loops there are none, and the driving forces come from outside.
Program trace_outputs(const Model& model, const Topology& topology, const Analysis& analysis, Form form,
                      Spelling spelling = Spelling::fast);

/// Auxiliary states that hold, after the sampled values that are due are set; empty without such values.
Program trace_sampled(const Model& model, const Topology& topology, const Analysis& analysis, Form form,
                      Spelling spelling = Spelling::fast);

/// x and y below the wheels on ground of a host, one after another.
Program trace_ground_places(const Model& model, const Topology& topology, const Analysis& analysis, Form form,
                            Spelling spelling = Spelling::fast);

/// Forces of the actuators for the accelerations of the independent coordinates, and all accelerations. Requires:
/// has_inverse_dynamics.
Program trace_inverse_dynamics(const Model& model, const Topology& topology, const Analysis& analysis, Form form,
                               Spelling spelling = Spelling::fast);

/// Positions and directions of the actuators, and their drifts.
Program trace_actuators(const Model& model, const Topology& topology, const Analysis& analysis, Form form,
                        Spelling spelling = Spelling::fast);

/// Forces of the tree that given accelerations need, without those of the actuators.
Program trace_required_forces(const Model& model, const Topology& topology, const Analysis& analysis, Form form,
                              Spelling spelling = Spelling::fast);

/// The equations of an implicit step, and the changes that solve them. Entries that are constants stay in the programs.
struct ImplicitPrograms {
  Program tangents, changes;
};
ImplicitPrograms trace_implicit(const Model& model, const Topology& topology, const Analysis& analysis,
                                Spelling spelling = Spelling::fast);

/// The order of a traced program.
enum class TraceOrder {
  canonical,   ///< the same from every compiler
  as_recorded  ///< for counting: as many operations, in less time
};

/// The share of a loop block in the recursive accelerations, for counting: its joints, the joints of its base and the
/// units directly on it, without applied forces. Other blocks are not traced. partition: in place of `quasi`.
Program trace_block(const Model& model, const Topology& topology, const Analysis& analysis, int block,
                    const LoopPartition& partition, TraceOrder order);

}  // namespace mbgen
