#pragma once
// Laws that several elements share, seen from the program around them. Inside the trace room.

#include <vector>

#include "compiler/formulation/elements/force_work.hpp"
#include "compiler/trace/tracing.hpp"

namespace mbgen {

/// Leaves the tyres of these laws to them: their contacts are outputs of the program in the making, their forces
/// inputs. Requires: the arguments live as long.
detail::SharedTyreLaw<Expr> shared_tyre_law(Tracing& tracing, const std::vector<SharedLaw>& laws);

}  // namespace mbgen
