#pragma once
// Conditions in C++ on masses and inertias that several tunable parameters determine, as the reader would check them.

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

/// Ranges of masses that depend on several parameters, and of inertias of bodies without fixed neighbours. An inertia
/// must not be negative about any axis, nor violate the triangle inequality unless it does so at the values of the
/// model, where it is accepted. Empty if there are none.
std::vector<QuantityRange> quantity_ranges(const EmitContext& context);
bool has_quantities(const EmitContext& context);

/// Adds `<model>_quantities.hpp`, which finds the first impossible quantity, if the model can have one.
void add_quantities(const EmitContext& context, std::vector<EmittedFile>& files);

}  // namespace mbgen
