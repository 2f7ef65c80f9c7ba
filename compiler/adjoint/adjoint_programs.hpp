#pragma once
// The programs of a solver from their results to their arguments.

#include "compiler/solver/programs.hpp"

namespace mbgen {

/// The adjoint of each program that a step or an output needs, see passes/passes.hpp: it takes what the program takes,
/// without joint forces from outside and with charts 0, and weights of its results.
struct AdjointPrograms {
  Program accelerations;  ///< weights of zdd and xd
  Program velocities;     ///< of the closure: weights of zd; gives the pivots too
  Program positions;      ///< of the closure: weights of dz
  Program multipliers;    ///< weights of lambda and drive; gives the pivots too
  Program outputs;        ///< weights of y
  Program derived;        ///< weights of the derived constants
};

AdjointPrograms adjoint_programs(const WrittenPrograms& written);

/// The accelerations with the laws that elements share put into them, element by element.
Program with_laws(const Program& around, const std::vector<SharedLaw>& laws);

}  // namespace mbgen
