#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <variant>

#include "compiler/expressions/evaluate.hpp"
#include "compiler/model/element_kinds.hpp"
#include "compiler/model/inputs.hpp"
#include "compiler/model/tyres.hpp"
#include "mbgen/bounds.hpp"

namespace mbgen {
namespace {

using Kind = ExpressionNode::Kind;

using Bound = QuantityBound;

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
  template <class Other>
  void add(std::string_view, const std::string&, const Other&, Bound) {}
};

void add_mechanism(Gatherer& to) {
  for (const Body& body : to.model.bodies) to.add("mass", body.name, body.mass, Bound::not_negative);
  for (const Joint& joint : to.model.joints) to.add("radius", joint.name, joint.radius, Bound::positive);
  for (const Rod& rod : to.model.rods) {
    to.add("mass", rod.name, rod.mass, Bound::not_negative);
    to.add("length", rod.name, rod.length, Bound::positive);
  }
}

/// Numbers of an element by the bounds of its kind.
template <class Element>
void add_element(Gatherer& to, const Element& element) {
  KindOf<Element>::fields(element, [&](const std::string& name, const auto& field) {
    const std::string_view own = std::string_view(name).substr(name.rfind('.') + 1);
    for (const FieldBound& bound : KindOf<Element>::bounds)
      if (own == bound.field) to.add(name, element.name, field, bound.bound);
  });
}

/// Numbers of a tyre beside its fields: the patch of its parking moment, and scales of its set.
void add_set(Gatherer& to, const Tyre& tyre) {
  if (tyre.parking) {
    to.add("stiffness of the patch", tyre.name, tyre.parking->stiffness, Bound::positive);
    to.add("radius of the patch", tyre.name, tyre.parking->radius, Bound::positive);
    to.add("load of the patch", tyre.name, tyre.parking->load, Bound::positive);
  }
  const std::span<const TyreField> fields = tyre_fields(tyre.model);
  for (std::size_t i = 0; i < fields.size() && i < tyre.coefficients.size(); ++i) {
    if (is_scale(tyre.model, fields[i].name) || std::string_view(fields[i].name) == "LONGVL")
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
  each_element(model, [&](const auto& element) { add_element(to, element); });
  for (const Tyre& tyre : model.tyres) add_set(to, tyre);
  return std::move(to.list);
}

bool is_out_of_bounds(const Model& model, const BoundedQuantity& bounded, const std::vector<double>& parameters,
                      const std::vector<double>& inputs) {
  const double value = evaluate<double>(bounded.quantity, model.expressions, Settings{parameters, inputs});
  if (bounded.bound == Bound::positive) return !is_positive(value);
  return bounded.bound == Bound::share ? !is_share(value) : !is_not_negative(value);
}

}  // namespace mbgen
