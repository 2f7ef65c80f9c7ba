#pragma once
// Usual causes for a model without rest.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "runtime/state/state.hpp"
#include "workbench/engines/engine.hpp"

namespace mbgen {

/// A failed search for rest, and numbers of the model in its last state.
struct AtRest {
  const Compilation& compilation;
  const std::vector<double>& inputs;
  const GenericState &start, &last;
  const std::vector<double>& zdd;    ///< at `last`; empty where these are not to be had
  const std::vector<double>& loads;  ///< of the tyres at `last`, N; empty where these are not to be had

  /// The coordinate that accelerates most. Requires: zdd is not empty.
  int fastest() const {
    const auto is_smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
    return static_cast<int>(std::max_element(zdd.begin(), zdd.end(), is_smaller) - zdd.begin());
  }
  double parameter(int i) const { return compilation.model.parameters[static_cast<std::size_t>(i)].value; }
  double input(int i) const { return inputs[static_cast<std::size_t>(i)]; }
  double time() const { return last.t; }
  double position(const CoordinateReference& at) const {
    const int i = tree_coordinate(compilation.topology, at);
    return i < 0 ? 0 : last.z[static_cast<std::size_t>(i)];
  }
  double velocity(const CoordinateReference&) const { return 0; }
  double local(int) const { return 0; }
};

/// The causes that apply, one line each, with the places of the elements they name.
std::vector<std::string> equilibrium_causes(const AtRest& rest);

/// Springs whose two points coincide in a state, a line each.
std::vector<std::string> coinciding_ends(const Compilation& compilation, const GenericState& at);

}  // namespace mbgen
