#pragma once
// Friction law, common to all kinds of friction.

#include <array>
#include <optional>

#include "compiler/expressions/expression.hpp"
#include "compiler/model/elements/kind.hpp"

namespace mbgen {

/// Law of a friction between two sliding parts: v is their relative speed, F_n the normal force, or 1.
/// Stribeck curve: g(v) = F_n (coulomb + (stiction - coulomb) exp(-(v/v_stribeck)^2)).
///   smooth          f = -g(v) tanh(v/velocity) - viscous v: creeps at rest
///   elasto_plastic, lugre: a bristle of deflection b, an auxiliary state, see mbgen/solver/bristle.hpp;
///                   f = -(stiffness b + damping db/dt) - viscous v: holds at rest
struct FrictionLaw {
  enum class Kind { smooth, elasto_plastic, lugre };
  Kind kind = Kind::smooth;
  Quantity coulomb;   ///< N m or N; with `normal` 1 or m
  Quantity stiction;  ///< as coulomb; the reader sets it to coulomb when absent
  Quantity viscous;   ///< N m s/rad or N s/m
  Quantity velocity;  ///< rad/s or m/s, regularisation speed of smooth friction, > 0
  /// rad/s or m/s, > 0; the reader sets it to 10 * velocity when absent, or of a bristle without stiction to 1
  Quantity stribeck_velocity;
  Quantity stiffness;         ///< of a bristle, N m/rad or N/m, > 0
  Quantity damping;           ///< of a bristle, N m s/rad or N s/m
  Quantity elastic;           ///< purely elastic share of the largest deflection of a bristle, 0 to below 1
  std::optional<double> lag;  ///< s: least time constant of a bristle; the reader sets it to the step of the solver
  int normal = -1;            ///< index into Model::springs of the spring with the normal force, -1 for none
  int load = -1;              ///< index into Model::sampled of the reaction with the normal force, -1 for none

  /// Only for a model whose programs are differentiated: see open_bristle in mbgen/solver/bristle.hpp.
  bool is_for_slopes = false;

  bool has_bristle() const { return kind != Kind::smooth; }
};

/// Calls use(name, value) for the fields of the law.
template <class Use>
void use_friction_fields(const FrictionLaw& law, const Use& use) {
  use("coulomb", law.coulomb);
  use("stiction", law.stiction);
  use("viscous", law.viscous);
  use("velocity", law.velocity);
  use("stribeck_velocity", law.stribeck_velocity);
  use("stiffness", law.stiffness);
  use("damping", law.damping);
  use("elastic", law.elastic);
}

/// Members of all kinds of frictions.
struct FrictionDefaults : KindDefaults {
  static constexpr const char *section = "frictions", *words = "friction";
  static constexpr StateNature nature = StateNature::bristle;
  template <class Use>
  static void states(const FrictionLaw& law, const Use& use) {
    if (law.has_bristle()) use(HiddenState{.suffix = "_bristle"});
  }
  /// place: "on knee", "along leaf".
  static std::string sticks(const std::string& name, const std::string& place, const FrictionLaw& law) {
    if (!law.has_bristle()) return "";
    return name + " sticks " + place + ", by bristles (" +
           (law.kind == FrictionLaw::Kind::lugre ? "LuGre, which creeps under loads that vibrate" : "elasto-plastic") +
           ") whose deflection is the state x." + name + "_bristle.";
  }
};

/// Bounds of the law's fields.
inline constexpr std::array kFrictionBounds = {
    FieldBound{"coulomb", QuantityBound::not_negative},       FieldBound{"stiction", QuantityBound::not_negative},
    FieldBound{"viscous", QuantityBound::not_negative},       FieldBound{"velocity", QuantityBound::positive},
    FieldBound{"stribeck_velocity", QuantityBound::positive}, FieldBound{"stiffness", QuantityBound::positive},
    FieldBound{"damping", QuantityBound::not_negative},       FieldBound{"elastic", QuantityBound::share}};

}  // namespace mbgen
