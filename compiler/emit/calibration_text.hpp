#pragma once
// The calibration file of a solver, ASAP2 1.6 (ASAM MCD-2 MC), and the C header of the symbols that it links to.

#include <string>

#include "compiler/emit/interface_text.hpp"

namespace mbgen {

/// `<model>.a2l`: parameters as characteristics; inputs, outputs and state as measurements; each with its unit and its
/// place in a structure of the C interface. Source: ASAM MCD-2 MC (ASAP2), version 1.6.
std::string calibration_text(const EmitContext& context);

/// `<model>_a2l.h`, C99.
std::string calibration_header_text(const EmitContext& context);

}  // namespace mbgen
