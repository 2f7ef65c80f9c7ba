#pragma once
// Inputs between the instants at which they are set, and bounded numbers made of parameters and inputs.

#include <string>
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

// Numbers of the model that tunable parameters and inputs make together, within the bounds that the reader holds them
// to: at other values than those of the file they may leave these.

/// An expression of parameters and inputs, of no time, position or state, and its bounds.
struct BoundedQuantity {
  std::string name;  ///< field and element: "stiffness of strut"
  Quantity quantity;
  QuantityBound bound = QuantityBound::not_negative;
  bool takes_inputs = false;
};

/// Whether an expression is a product or quotient of positive numbers and at most one parameter or input: its bound is
/// then the parameter's or the input's.
bool is_single_product(const Expression& expression);

/// All of them that are no single product, in the order of the model. Masses among them; inertias are no numbers.
std::vector<BoundedQuantity> bounded_quantities(const Model& model);

/// Whether one is out of its bounds at values of all parameters and inputs, in the order of the model.
bool is_out_of_bounds(const Model& model, const BoundedQuantity& bounded, const std::vector<double>& parameters,
                      const std::vector<double>& inputs);

}  // namespace mbgen
