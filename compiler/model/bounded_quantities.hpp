#pragma once
// Numbers of the model that tunable parameters and inputs make together, within the bounds that the reader holds them
// to: at other values than those of the file they may leave these.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

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
