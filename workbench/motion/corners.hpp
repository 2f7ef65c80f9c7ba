#pragma once
// Corners of a model's laws: where a stop is met, a wheel lifts off, a table has a point, friction or min, max, abs and
// step of an expression take their other side.

#include <cstddef>
#include <vector>

#include "compiler/compile.hpp"
#include "runtime/state/state.hpp"

namespace mbgen {

/// Every operation of the accelerations that chooses by a sign, and the rates with the choices given from outside: so
/// that each law goes on smoothly beyond its corner until the corner is found. Traced from the model; works at any
/// engine's states.
class Corners {
 public:
  /// None of a model whose accelerations are too large to be traced.
  explicit Corners(const Compilation& compilation);

  std::size_t count() const { return conditions_.outputs.size(); }
  /// Condition of each corner: one side from zero on, the other one below. state: in the angles of the model.
  std::vector<double> conditions(const GenericState& state, const std::vector<double>& inputs) const;
  /// Rates with these sides, each 1 or -1, less those with other ones. Not finite where a law has no values beyond its
  /// corner.
  GenericDerivative difference(const GenericState& state, const std::vector<double>& inputs,
                               const std::vector<double>& sides, const std::vector<double>& other) const;

 private:
  std::vector<double> results(const Program& program, const GenericState& state, const std::vector<double>& inputs,
                              const std::vector<double>& sides) const;

  Program conditions_;  ///< Array::residual: what each corner chooses by
  Program held_;        ///< the accelerations with Array::seed, the sides
  std::vector<double> parameters_;
};

}  // namespace mbgen
