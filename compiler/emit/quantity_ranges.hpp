#pragma once
// Numbers and inertias that tunable parameters and inputs make together, and that the reader would refuse: conditions
// of C++.

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

/// Of bounded_quantities (compiler/model), and of inertias of bodies that nothing is fixed to. An inertia must not be
/// negative about any axis, nor break the triangle rule unless it does so at the values of the model, where it is
/// accepted. Empty without such.
std::vector<QuantityRange> quantity_ranges(const EmitContext& context);
bool has_quantities(const EmitContext& context);
bool has_input_quantities(const EmitContext& context);

/// Adds `<model>_quantities.hpp`, which tells the first that no model may have, where there are some.
void add_quantities(const EmitContext& context, std::vector<EmittedFile>& files);

}  // namespace mbgen
