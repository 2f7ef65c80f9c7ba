#pragma once
// Corners of a model's laws: contact of a stop, lift-off of a wheel, points of a table, and changes of branch in
// friction or in min, max, abs and step of an expression.

#include <cstddef>
#include <vector>

#include "compiler/compile.hpp"
#include "runtime/state/state.hpp"

namespace mbgen {

/// All operations of the accelerations that switch by a sign, and the rates with given sides: each law continues
/// smoothly beyond its corner until the corner is found. Traced from the model; works at the states of any engine.
class Corners {
 public:
  /// Without corners if the accelerations of the model are too large to be traced.
  explicit Corners(const Compilation& compilation);

  std::size_t count() const { return conditions_.outputs.size(); }
  /// Condition of each corner: one side from zero on, the other one below. state: in the angles of the model.
  std::vector<double> conditions(const GenericState& state, const std::vector<double>& inputs) const;
  /// Rates with these sides, each 1 or -1, minus the rates with the other ones. Not finite if a law has no values
  /// beyond its corner.
  GenericDerivative difference(const GenericState& state, const std::vector<double>& inputs,
                               const std::vector<double>& sides, const std::vector<double>& other) const;
  /// Rates with the sides that the conditions have. state: in the angles of the model.
  GenericDerivative rates(const GenericState& state, const std::vector<double>& inputs) const;
  /// Whether each condition changes with the state, or with one of these tunable parameters, counted from 0.
  std::vector<bool> follow(const std::vector<int>& tunable) const;

 private:
  std::vector<double> results(const Program& program, const GenericState& state, const std::vector<double>& inputs,
                              const std::vector<double>& sides) const;

  /// Rates where each corner is on the side that is given.
  GenericDerivative held_rates(const GenericState& state, const std::vector<double>& inputs,
                               const std::vector<double>& sides) const;

  Program conditions_;  ///< Array::residual: what each corner chooses by
  Program held_;        ///< the accelerations with Array::seed, the sides
  std::vector<double> parameters_;
};

}  // namespace mbgen
