#pragma once
// The law of frictions, whatever they act on.

#include <array>
#include <optional>

#include "compiler/expressions/expression.hpp"
#include "compiler/model/elements/kind.hpp"

namespace mbgen {

/// Law of a friction between two parts that slide on each other, v their speed, F_n the force that presses them, or 1.
/// Level: g(v) = F_n (coulomb + (stiction - coulomb) exp(-(v/v_stribeck)^2)).
///   smooth          f = -g(v) tanh(v/velocity) - viscous v: creeps at rest
///   elasto_plastic, lugre: a bristle of deflection b, an auxiliary state, see mbgen/bristle.hpp;
///                   f = -(stiffness b + damping db/dt) - viscous v: holds at rest
struct FrictionLaw {
  enum class Kind { smooth, elasto_plastic, lugre };
  Kind kind = Kind::smooth;
  Quantity coulomb;   ///< N m or N; with `normal` 1 or m
  Quantity stiction;  ///< as coulomb; the reader sets it to coulomb when absent
  Quantity viscous;   ///< N m s/rad or N s/m
  Quantity velocity;  ///< rad/s or m/s over which the sign of smooth friction is smoothed, > 0
  /// rad/s or m/s, > 0; the reader sets it to 10 * velocity when absent, or of a bristle without stiction to 1
  Quantity stribeck_velocity;
  Quantity stiffness;         ///< of a bristle, N m/rad or N/m, > 0
  Quantity damping;           ///< of a bristle, N m s/rad or N s/m
  Quantity elastic;           ///< share of the largest deflection up to which a bristle does not slide, 0 to below 1
  std::optional<double> lag;  ///< s: a bristle follows no faster; the reader sets it to the step of the solver
  int normal = -1;            ///< index into Model::springs of the spring that presses the parts together, -1 for none
  int load = -1;              ///< index into Model::sampled of the reaction that presses them, -1 for none

  /// Of a model whose programs are differentiated, and nothing else: see open_bristle in mbgen/bristle.hpp.
  bool is_for_slopes = false;

  bool has_bristle() const { return kind != Kind::smooth; }
};

/// Bounds of the law's fields.
inline constexpr std::array kFrictionBounds = {
    FieldBound{"coulomb", QuantityBound::not_negative},       FieldBound{"stiction", QuantityBound::not_negative},
    FieldBound{"viscous", QuantityBound::not_negative},       FieldBound{"velocity", QuantityBound::positive},
    FieldBound{"stribeck_velocity", QuantityBound::positive}, FieldBound{"stiffness", QuantityBound::positive},
    FieldBound{"damping", QuantityBound::not_negative},       FieldBound{"elastic", QuantityBound::share}};

}  // namespace mbgen
