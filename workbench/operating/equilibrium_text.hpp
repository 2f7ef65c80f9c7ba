#pragma once
// A static equilibrium with its forces, as text and as JSON.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {

/// The equilibrium, its rates and its forces.
struct Equilibrium {
  GenericState state;
  GenericDerivative rates;  ///< zero up to rounding, except for free rolling or turning
  GenericOutputs outputs;
};

/// The equilibrium near the model's initial state. Fails: UserError as equilibrium_state.
Equilibrium equilibrium(const Compilation& compilation, const std::vector<double>& inputs);

/// Positions and outputs by name, SI units, and the largest remaining acceleration.
nlohmann::ordered_json equilibrium_json(const Compilation& compilation, const Equilibrium& found);

std::string equilibrium_text(const Compilation& compilation, const Equilibrium& found);

}  // namespace mbgen
