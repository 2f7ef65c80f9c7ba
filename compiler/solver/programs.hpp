#pragma once
// The door of the solver room: the programs of a solver, with the inputs and outputs of each. Trace makes them,
// passes rewrite them, emit writes them, linearisation and FMUs differentiate them.
//
// Slot groups (index meaning); n coordinates, nx auxiliary states (tyre slips), B
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
//            Phi<b>[e] Jz<b>[e*c+j] c<b>[e]            closure terms: residual, Jacobian (all equations), acceleration
//                                           right-hand side (Phi_z zdd = c)
//            rate<b>[e]                     Phi_z zd, for Jz where a block is too large, see chooses_again
//            residual[e]                    all closure residuals, block after block (frozen closure step)
//            dz[n] zd[n]                    Newton correction of positions (dependent ones; driven ones set to motion)
//                                           and consistent velocities
//            lambda[m]                      multipliers, in the order of Topology::loops and their equations
//            drive[g]                       generalised driving force of motion g
//            missing<b>[c]                  tree forces less M zdd of block b: what Phi_z' lambda, less drives, equals
//            y[o]                           model outputs

#include <array>
#include <string>
#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// Forms of the equations of motion.
enum class Form {
  matrix,    ///< the paper's nine steps: Rz' M Rz is formed
  recursive  ///< loop blocks and joints are eliminated into the inertia of the body that they move on
};

const char* name_of(Form form);
Form other_form(Form form);

struct Programs {
  Program accelerations;  ///< z zd x t tau in par -> zdd xd pivot inertia; frozen partition, the hot path
  Program closure;        ///< z zd t in par -> residual dz zd pivot; frozen Newton step; only with loops or motions
  Program closure_terms;  ///< z zd t in par -> Phi Jz c of every block, for the pivoting kernels; only with loops
  Program accelerations_chosen;  ///< z zd x t tau in par Rz zdd_star -> zdd xd inertia; any partition; only with
                                 ///< loops, and where it is chosen again
  Program multipliers;           ///< z zd x t tau in par zdd -> lambda drive missing pivot; only with loops or motions
  Program outputs;  ///< z zd x t in par zdd (tau lambda drive) -> y and `energy[0]` kinetic, `energy[1]` potential of
                    ///< gravity, `power[0]` power of all applied forces but gravity
  Program derived_constants;  ///< par -> derived: what the others take of the tunable parameters; only with such things
  Form form = Form::recursive;                         ///< of `accelerations` and `accelerations_chosen`
  std::vector<std::string> free_direction_coordinate;  ///< per index of `inertia`: coordinate that names the direction
  std::vector<int> free_directions_of_block;           ///< per block: f
  std::vector<int> residual_equation_of;               ///< per block: first index of its equations in `residual`
};

/// The programs that a solver runs, in the order in which they are written; programs that a model does not need are
/// empty.
std::array<Program*, 6> solver_programs(Programs& programs);

/// Every program with outputs: the programs of solver_programs, then the derived constants.
std::vector<const Program*> all_programs(const Programs& programs);

}  // namespace mbgen
