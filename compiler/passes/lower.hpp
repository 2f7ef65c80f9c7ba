#pragma once
// All passes in order, from traced programs to programs as they are written.

#include <span>

#include "compiler/solver/programs.hpp"

namespace mbgen {

/// How far programs are from the emitted ones.
enum class Lowered {
  whole,   ///< every value follows from the inputs: derivatives are taken here
  lean,    ///< without values of tunable parameters alone: operations are counted here
  emitted  ///< rounded and ordered as the C++ text is
};

/// One pass over all programs of a solver.
struct Pass {
  const char* name;           ///< of the stage: --dump=NAME
  const char* effect;         ///< in words
  Lowered result;             ///< state of the programs after it
  Programs (*run)(Programs);  ///< pure
};

/// The list is the architecture: every decision about a program before it is arranged into functions.
std::span<const Pass> passes();

/// The passes that leave programs whole, on one program.
Program optimise(const Program& program);

}  // namespace mbgen
