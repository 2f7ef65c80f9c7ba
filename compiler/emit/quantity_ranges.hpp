#pragma once
// Conditions in C++ on numbers and inertias that tunable parameters and inputs determine together, as the reader would
// check them.

#include <string>
#include <vector>

#include "compiler/emit/context.hpp"
#include "compiler/emit/files.hpp"

namespace mbgen {

/// A number of the model, or the inertia of a body, by an expression of parameters and inputs.
struct QuantityRange {
  std::string name;    ///< "mass of arm"
  std::string broken;  ///< condition over `values`, the parameters, and `inputs`: true where no model may have it
  bool takes_inputs = false;
};

/// Ranges of bounded_quantities (compiler/model), and of inertias of bodies without fixed neighbours. An inertia must
/// not be negative about any axis, nor violate the triangle inequality unless it does so at the values of the model,
/// where it is accepted. Empty if there are none.
std::vector<QuantityRange> quantity_ranges(const EmitContext& context);
bool has_quantities(const EmitContext& context);
bool has_input_quantities(const EmitContext& context);

/// Adds `<model>_quantities.hpp`, which finds the first impossible quantity, if the model can have one.
void add_quantities(const EmitContext& context, std::vector<EmittedFile>& files);

}  // namespace mbgen
