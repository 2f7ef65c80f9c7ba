#pragma once
// Inputs between the instants at which somebody gives them values.

#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Inputs dt seconds after they had `values`: each continues as value + rate dt + acceleration dt^2/2 + ..., as far as
/// derivatives are named (Input::derivative); without one it stays. values: of all inputs, model order. dt: s.
/// Emitted code does the same in `advance_inputs`.
std::vector<double> advanced_inputs(const std::vector<Input>& inputs, const std::vector<double>& values, double dt);

/// Whether any input has a derivative.
bool inputs_have_derivatives(const std::vector<Input>& inputs);

/// Inputs with their derivatives, each row from an input that is no derivative to the last one; those that share a
/// derivative are left out, as no rate can follow several values.
std::vector<std::vector<int>> input_rows(const std::vector<Input>& inputs);

/// Whether an input is a rate that the reader added since the model left it out: it stands where the input stands whose
/// rate it is.
bool is_made_rate(const std::vector<Input>& inputs, int input);

}  // namespace mbgen
