#pragma once
// How far loops are open, in words.

#include "compiler/compile.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {

/// Says which loops stay open by how many millimetres or degrees at the positions of `state`, the nearest that the
/// locked and driven coordinates allow. Fails: always, UserError.
[[noreturn]] void refuse_open_positions(const Compilation& compilation, const GenericSolver& solver,
                                        const GenericState& state);

/// Says that the locked and driven velocities contradict the closures. Fails: always, UserError.
[[noreturn]] void refuse_open_velocities(const Compilation& compilation);

}  // namespace mbgen
