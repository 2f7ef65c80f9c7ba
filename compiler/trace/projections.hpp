#pragma once
// Projections of joint groups on their free directions, as the forms of the accelerations take them.

#include <cstddef>

#include "compiler/formulation/loop_solution.hpp"
#include "compiler/program/program.hpp"
#include "compiler/solver/programs.hpp"

namespace mbgen {

class Tracing;

/// Where the projections of the loop blocks come from.
enum class Partition {
  frozen,  ///< from the partition that the analysis chose
  chosen   ///< from inputs Rz<b>, zdd_star<b>: a partition chosen at run time
};

/// The program of accelerations over a partition.
Role role_of(Partition partition);

/// The projection of a block as inputs of the program.
GroupProjection<Expr> chosen_projection(Tracing& tracing, std::size_t block);

/// Projection of a joint outside all blocks: free, or prescribed by a motion.
GroupProjection<Expr> single_projection(const Tracing& tracing, int joint);

}  // namespace mbgen
