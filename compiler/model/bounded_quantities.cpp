#include "compiler/model/bounded_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <variant>

#include "compiler/expressions/evaluate.hpp"
#include "compiler/model/each_friction.hpp"
#include "compiler/model/tyre_sets.hpp"
#include "mbgen/bounds.hpp"

namespace mbgen {
namespace {

using Kind = ExpressionNode::Kind;

using Bound = BoundedQuantity::Bound;

/// Gathers the quantities that the tables of the reader give bounds (compiler/reader/tables_*.cpp), each once.
struct Gatherer {
  const Model& model;
  std::vector<BoundedQuantity> list = {};
  std::set<int> seen = {};

  void add(std::string_view field, const std::string& element, const Quantity& quantity, Bound bound) {
    if (quantity.expression < 0 || !seen.insert(quantity.expression).second) return;
    const Expression& expression = model.expressions[static_cast<std::size_t>(quantity.expression)];
    bool takes_inputs = false, is_of_settings = true;
    for (const ExpressionNode& node : expression.nodes) {
      takes_inputs = takes_inputs || node.kind == Kind::input;
      is_of_settings = is_of_settings && (node.kind == Kind::number || node.kind == Kind::parameter ||
                                          node.kind == Kind::input || node.kind == Kind::call);
    }
    if (!is_of_settings || is_single_product(expression)) return;
    list.push_back({std::string(field) + " of " + element, quantity, bound, takes_inputs});
  }
  void add(std::string_view field, const std::string& element, const std::optional<Quantity>& quantity, Bound bound) {
    if (quantity) add(field, element, *quantity, bound);
  }
  void add(std::string_view field, const std::string& element, const Law& law, Bound bound) {
    if (const Quantity* quantity = std::get_if<Quantity>(&law)) add(field, element, *quantity, bound);
  }
  void add(std::string_view field, const std::string& element, const std::optional<Law>& law, Bound bound) {
    if (law) add(field, element, *law, bound);
  }
};

void add_mechanism(Gatherer& to) {
  for (const Body& body : to.model.bodies) to.add("mass", body.name, body.mass, Bound::not_negative);
  for (const Joint& joint : to.model.joints) to.add("radius", joint.name, joint.radius, Bound::positive);
  for (const Rod& rod : to.model.rods) {
    to.add("mass", rod.name, rod.mass, Bound::not_negative);
    to.add("length", rod.name, rod.length, Bound::positive);
  }
}

void add_springs(Gatherer& to) {
  for (const PointSpring& spring : to.model.springs) {
    to.add("stiffness", spring.name, spring.stiffness, Bound::not_negative);
    to.add("damping", spring.name, spring.damping, Bound::not_negative);
    to.add("free_length", spring.name, spring.free_length, Bound::not_negative);
  }
  for (const JointSpring& spring : to.model.joint_springs) {
    to.add("stiffness", spring.name, spring.stiffness, Bound::not_negative);
    to.add("damping", spring.name, spring.damping, Bound::not_negative);
  }
  for (const AirSpring& spring : to.model.air_springs) {
    to.add("pressure", spring.name, spring.pressure, Bound::positive);
    to.add("ambient", spring.name, spring.ambient, Bound::not_negative);
    to.add("exponent", spring.name, spring.exponent, Bound::positive);
    to.add("length", spring.name, spring.length, Bound::positive);
    to.add("area", spring.name, spring.area, Bound::positive);
    if (!spring.volume) to.add("volume", spring.name, spring.volume0, Bound::positive);
  }
  for (const Bushing& bushing : to.model.bushings) {
    for (const std::optional<BushingFreedom>& freedom : bushing.freedoms) {
      if (!freedom || !freedom->maxwell_stiffness) continue;
      to.add("maxwell_stiffness", bushing.name, freedom->maxwell_stiffness, Bound::not_negative);
      to.add("maxwell_time", bushing.name, freedom->maxwell_time, Bound::positive);
    }
  }
  for (const BumpStop& stop : to.model.bump_stops) {
    to.add("stiffness", stop.name, stop.stiffness, Bound::not_negative);
    to.add("damping", stop.name, stop.damping, Bound::not_negative);
  }
}

void add_friction(Gatherer& to, const std::string& name, const FrictionLaw& law) {
  to.add("coulomb", name, law.coulomb, Bound::not_negative);
  to.add("stiction", name, law.stiction, Bound::not_negative);
  to.add("viscous", name, law.viscous, Bound::not_negative);
  to.add("velocity", name, law.velocity, Bound::positive);
  to.add("stribeck_velocity", name, law.stribeck_velocity, Bound::positive);
  if (!law.has_bristle()) return;
  to.add("stiffness", name, law.stiffness, Bound::positive);
  to.add("damping", name, law.damping, Bound::not_negative);
  to.add("elastic", name, law.elastic, Bound::share);
}

void add_tyre(Gatherer& to, const Tyre& tyre) {
  to.add("radius", tyre.name, tyre.radius, Bound::positive);
  to.add("stiffness", tyre.name, tyre.stiffness, Bound::positive);
  to.add("damping", tyre.name, tyre.damping, Bound::not_negative);
  to.add("friction", tyre.name, tyre.friction, Bound::not_negative);
  to.add("rolling_resistance", tyre.name, tyre.rolling_resistance, Bound::not_negative);
  to.add("pressure", tyre.name, tyre.pressure, Bound::positive);
  to.add("relaxation_x", tyre.name, tyre.relaxation_x, Bound::positive);
  to.add("relaxation_y", tyre.name, tyre.relaxation_y, Bound::positive);
  to.add("low_speed", tyre.name, tyre.low_speed, Bound::positive);
  if (tyre.parking) {
    to.add("stiffness of the patch", tyre.name, tyre.parking->stiffness, Bound::positive);
    to.add("radius of the patch", tyre.name, tyre.parking->radius, Bound::positive);
    to.add("load of the patch", tyre.name, tyre.parking->load, Bound::positive);
  }
  const std::span<const TyreField> fields = tyre_fields(tyre.model);
  for (std::size_t i = 0; i < fields.size() && i < tyre.coefficients.size(); ++i) {
    if (is_scale(tyre.model, fields[i].name) || fields[i].name == "LONGVL")
      to.add(fields[i].name, tyre.name, tyre.coefficients[i], Bound::positive);
  }
}

/// Values that expressions of parameters and inputs take.
struct Settings {
  const std::vector<double>& parameters;
  const std::vector<double>& inputs;

  double parameter(int index) const { return parameters[static_cast<std::size_t>(index)]; }
  double input(int index) const { return inputs[static_cast<std::size_t>(index)]; }
  double time() const { return 0; }
  double position(const CoordinateReference&) const { return 0; }
  double velocity(const CoordinateReference&) const { return 0; }
  double local(int) const { return 0; }
};

}  // namespace

bool is_single_product(const Expression& expression) {
  int symbols = 0;
  bool is_product = true;
  for (const ExpressionNode& node : expression.nodes) {
    if (node.kind == Kind::parameter || node.kind == Kind::input) ++symbols;
    if (node.kind == Kind::number) is_product = is_product && node.number > 0;
    if (node.kind == Kind::call)
      is_product = is_product && (node.function == Function::multiply || node.function == Function::divide);
  }
  return symbols <= 1 && is_product;
}

std::vector<BoundedQuantity> bounded_quantities(const Model& model) {
  Gatherer to{model};
  add_mechanism(to);
  add_springs(to);
  each_friction(model, [&](const auto& friction) { add_friction(to, friction.name, friction); });
  for (const Tyre& tyre : model.tyres) add_tyre(to, tyre);
  return std::move(to.list);
}

bool is_out_of_bounds(const Model& model, const BoundedQuantity& bounded, const std::vector<double>& parameters,
                      const std::vector<double>& inputs) {
  const double value = evaluate<double>(bounded.quantity, model.expressions, Settings{parameters, inputs});
  if (bounded.bound == Bound::positive) return !is_positive(value);
  return bounded.bound == Bound::share ? !is_share(value) : !is_not_negative(value);
}

}  // namespace mbgen
