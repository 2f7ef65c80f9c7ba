#pragma once
// Inputs between the instants at which they are set.

#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Inputs dt seconds after `values` were set: each is extrapolated by value + rate dt + acceleration dt^2/2 + ..., as
/// far as derivatives are named (Input::derivative); without one it is constant. values: all inputs, model order. dt:
/// s. Emitted code has the same in `advance_inputs`.
std::vector<double> advanced_inputs(const std::vector<Input>& inputs, const std::vector<double>& values, double dt);

/// Whether any input has a derivative.
bool inputs_have_derivatives(const std::vector<Input>& inputs);

/// Inputs with their derivatives: a row for each input that is no derivative. Inputs with a common derivative are
/// omitted: one rate cannot belong to several values.
std::vector<std::vector<int>> input_rows(const std::vector<Input>& inputs);

/// Whether an input is a rate added by the reader because the model omits it; its position is the position of the input
/// with this rate.
bool is_made_rate(const std::vector<Input>& inputs, int input);

}  // namespace mbgen
