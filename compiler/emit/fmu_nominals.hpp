#pragma once
// Nominal values of an FMU's states.

#include "compiler/emit/fmu_variables.hpp"

namespace mbgen {

/// Nominal values of the continuous states: 1 rad or the extent of the model, as much per second, or what they start
/// with where that is more; a tenth of a tyre's radius for its slips. They stay whatever coordinates are chosen.
void add_nominals(const EmitContext& context, const InitialState& initial, FmuLayout& fmu);

}  // namespace mbgen
