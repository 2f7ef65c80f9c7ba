#pragma once
// A static equilibrium with its forces, for people and for machines.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {

/// The equilibrium, its rates and its forces.
struct Equilibrium {
  GenericState state;
  GenericDerivative rates;  ///< zero but for rounding, and for what may roll or turn freely
  GenericOutputs outputs;
};

/// The equilibrium near the model's initial state. Fails: UserError as equilibrium_state.
Equilibrium equilibrium(const Compilation& compilation, const std::vector<double>& inputs);

/// Positions and outputs by name, SI units, and the largest acceleration that is left.
nlohmann::ordered_json equilibrium_json(const Compilation& compilation, const Equilibrium& found);

std::string equilibrium_text(const Compilation& compilation, const Equilibrium& found);

}  // namespace mbgen
