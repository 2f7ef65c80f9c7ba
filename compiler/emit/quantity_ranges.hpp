#pragma once
// Masses and inertias that tunable parameters make together, and that the reader would refuse: conditions of C++.

#include <string>
#include <vector>

#include "compiler/emit/context.hpp"
#include "compiler/emit/files.hpp"

namespace mbgen {

/// A number of the model, or the inertia of a body, by an expression of parameters.
struct QuantityRange {
  std::string name;    ///< "mass of arm"
  std::string broken;  ///< condition over `values`, the parameters: true where no body has it
};

/// Of masses that not one parameter alone makes, and of inertias of bodies that nothing is fixed to. An inertia must
/// not be negative about any axis, nor break the triangle rule unless it does so at the values of the model, where it
/// is accepted. Empty without such.
std::vector<QuantityRange> quantity_ranges(const EmitContext& context);
bool has_quantities(const EmitContext& context);

/// Adds `<model>_quantities.hpp`, which tells the first that no body has, where the model has some.
void add_quantities(const EmitContext& context, std::vector<EmittedFile>& files);

}  // namespace mbgen
