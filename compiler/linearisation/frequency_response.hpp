#pragma once
// Response of a linear system to harmonic inputs.

#include <complex>
#include <vector>

#include "compiler/linearisation/linear_system.hpp"
#include "compiler/model/model.hpp"

namespace mbgen {

/// y over u of an output for a harmonic input, per frequency (Hz, above 0): C (i w - A)^-1 B + D. An input with a rate
/// moves with it: B and D are those of the input plus i w times the columns of its rate, and so on. Infinite at an
/// undamped mode. Cost: the cube of the states once, then their square per frequency.
std::vector<std::complex<double>> frequency_response(const Model& model, const LinearSystem& system, int input,
                                                     int output, const std::vector<double>& frequencies);

}  // namespace mbgen
