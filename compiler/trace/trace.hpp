#pragma once
// The door of the trace room: the formulation run on symbols. Every program is straight-line; iteration, pivoting and
// decisions stay in the runtime kernels that call them.
//
// Slot groups (index meaning), the contract with the emit room; n coordinates, nx auxiliary states (tyre slips), B
// blocks:
//   inputs   z[n] zd[n] x[nx] t[1] tau[n]   state and joint forces
//            in[..] par[..]                 Inputs, tunable Parameters (by index among the tunable ones)
//            zdd[n]                         given accelerations (outputs, multipliers)
//            lambda[m] drive[g]             constraint forces (outputs that look at them, with loops)
//            Rz<b>[c*f+q] zdd_star<b>[c]    projection of block b chosen at run time: c local coordinate, q of f free
//            directions
//   outputs  zdd[n] xd[nx]
//            pivot[b]                       smallest |pivot|/reference of block b (monitor), one per block with rank >
//            0 inertia[k]                     > 0 when free direction k of the final equations has inertia; names:
//                                           free_direction_coordinate
//            Phi<b>[e] Jz<b>[e*c+j] ct<b>[e] c<b>[e]   closure terms: residual, Jacobian (all equations), -dPhi/dt
//                                           (velocity right-hand side, Phi_z zd = ct), acceleration right-hand side
//                                           (Phi_z zdd = c)
//            rate<b>[e]                     Phi_z zd, for Jz where a block is too large, see chooses_again
//            residual[e]                    all closure residuals, block after block (frozen closure step)
//            dz[n] zd[n]                    Newton correction of positions (dependent ones; driven ones set to motion)
//                                           and consistent velocities
//            lambda[m]                      multipliers, in the order of Topology::loops and their equations
//            drive[g]                       generalised driving force of motion g
//            missing<b>[c]                  tree forces less M zdd of block b: what Phi_z' lambda, less drives, equals
//            y[o]                           model outputs

#include <optional>
#include <string>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/model.hpp"
#include "compiler/program/program.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Forms of the equations of motion.
enum class Form {
  matrix,    ///< the paper's nine steps: Rz' M Rz is formed
  recursive  ///< loop blocks and joints are eliminated into the inertia of the body that they move on
};

const char* name_of(Form form);

/// What a treatment of the equations saves, in operations of the accelerations.
struct Saving {
  std::string name;
  long without = 0, with = 0;
};

struct Programs {
  Program accelerations;  ///< z zd x t tau in par -> zdd xd pivot inertia; frozen partition, the hot path
  Program closure;        ///< z zd t in par -> residual dz zd pivot; frozen Newton step; only with loops or motions
  Program closure_terms;  ///< z zd t in par -> Phi Jz ct c of every block, for the pivoting kernels; only with loops
  Program accelerations_chosen;  ///< z zd x t tau in par Rz zdd_star -> zdd xd inertia; any partition; only with
                                 ///< loops, and where it is chosen again
  Program multipliers;           ///< z zd x t tau in par zdd -> lambda drive missing pivot; only with loops or motions
  Program outputs;  ///< z zd x t in par zdd (tau lambda drive) -> y and `energy[0]` kinetic, `energy[1]` potential of
                    ///< gravity, `power[0]` power of all applied forces but gravity
  Program derived_constants;  ///< par -> derived: what the others take of the tunable parameters; only with such things
  Program recursive_accelerations;  ///< the slots of `accelerations`, in the recursive form; empty once one is taken
  Form form = Form::matrix;         ///< of `accelerations`
  long operations_of_form[2] = {0, 0};  ///< of `accelerations` after the passes, by Form, once one is taken;
                                        ///< 0: not traced
  std::vector<Saving> savings;          ///< treatments with their counts, where they were counted
  std::vector<std::string> free_direction_coordinate;  ///< per index of `inertia`: coordinate that names the direction
  std::vector<int> free_directions_of_block;           ///< per block: f
  std::vector<int> residual_equation_of;               ///< per block: first index of its equations in `residual`
};

/// Number of auxiliary states of a model: two per tyre (longitudinal and lateral slip deflection, m).
int auxiliary_state_count(const Model& model);

/// Names and units of the auxiliary states.
std::vector<std::string> auxiliary_state_names(const Model& model);

/// The recursive program without one treatment each, with its name.
std::vector<std::pair<std::string, Program>> trace_without(const Model& model, const Topology& topology,
                                                           const Analysis& analysis);

/// Traces every program (theory.md sections 1 to 5); the accelerations in both forms, but one that is
/// not worth writing only where it is `form`.
Programs trace(const Model& model, const Topology& topology, const Analysis& analysis, std::optional<Form> form = {});

}  // namespace mbgen
