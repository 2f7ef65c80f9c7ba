#include "compiler/trace/shared_laws.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "compiler/formulation/elements/tyre.hpp"
#include "compiler/trace/each_program.hpp"

namespace mbgen {
namespace {

/// A law of one tyre alone saves nothing.
constexpr std::size_t kFewestTyres = 2;

using Wheel = WheelMotion<Expr>;
using Properties = TyreProperties<Expr>;
using Forces = WheelForces<Expr>;

/// Calls use(name, component) for a vector's components.
template <class Use>
void each_component(const std::string& name, Vector<Expr>& v, const Use& use) {
  use(name + "_x", v.x);
  use(name + "_y", v.y);
  use(name + "_z", v.z);
}

/// Calls use(name, number) for all that the law takes of a tyre and its wheel.
template <class Use>
void each_argument(const Tyre& of, Wheel& wheel, Properties& tyre, const Use& use) {
  each_component("up", wheel.up, use);
  each_component("axis", wheel.axis, use);
  use("height", wheel.height);
  each_component("velocity", wheel.velocity, use);
  each_component("angular", wheel.angular, use);
  use("u", wheel.u);
  use("v", wheel.v);
  use("radius", tyre.radius);
  use("stiffness", tyre.stiffness);
  use("damping", tyre.damping);
  use("friction", tyre.friction);
  use("rolling_resistance", tyre.rolling_resistance);
  use("relaxation_x", tyre.relaxation_x);
  use("relaxation_y", tyre.relaxation_y);
  use("low_speed", tyre.low_speed);
  use("side", tyre.side);
  use("count", tyre.count);
  use("pressure", tyre.pressure);
  use("over_load_x", tyre.over_load_x);
  use("over_load_y", tyre.over_load_y);
  if (!of.parking) return;
  use("turn", wheel.turn);
  use("turn_stiffness", tyre.turn_stiffness);
  use("turn_radius", tyre.turn_radius);
  use("turn_load", tyre.turn_load);
}

/// Calls use(name, number) for all that the law gives.
template <class Use>
void each_result(const Tyre& of, Forces& forces, const Use& use) {
  each_component("force", forces.wrench.linear, use);
  each_component("moment", forces.wrench.angular, use);
  use("du", forces.du);
  use("dv", forces.dv);
  if (of.parking) use("dturn", forces.dturn);
}

bool is_number(const Quantity& quantity) { return quantity.expression < 0; }

/// One law: the same formula with the same numbers.
bool share_a_law(const Tyre& a, const Tyre& b) {
  const auto same = [](const Quantity& p, const Quantity& q) {
    return is_number(p) && is_number(q) && p.value == q.value;
  };
  return a.model == b.model && detail::turning_of(a) == detail::turning_of(b) && a.combined_slip == b.combined_slip &&
         std::ranges::equal(a.coefficients, b.coefficients, same);
}

/// Whether expressions look at a tyre's forces or slips, which a shared law does not give.
bool looks_at_tyres(const Model& model) {
  return std::ranges::any_of(model.observed, [](const ObservedOutput& observed) {
    const auto* element = std::get_if<ElementOutput>(&observed.output.source);
    return element && element->kind == kKindIndex<Tyre>;
  });
}

/// Groups of tyres that share a law, in the order of their first tyres.
std::vector<std::vector<int>> tyres_of_laws(const Model& model) {
  std::vector<std::vector<int>> groups;
  if (looks_at_tyres(model)) return groups;
  for (std::size_t i = 0; i < model.tyres.size(); ++i) {
    const auto group = std::ranges::find_if(
        groups, [&](const auto& tyres) { return share_a_law(model.tyres[tyres.front()], model.tyres[i]); });
    (group == groups.end() ? groups.emplace_back() : *group).push_back(static_cast<int>(i));
  }
  std::erase_if(groups, [](const auto& tyres) { return tyres.size() < kFewestTyres; });
  return groups;
}

/// A law whose program is still to be traced.
SharedLaw planned_law(const Model& model, std::vector<int> tyres) {
  SharedLaw law;
  Wheel wheel;
  Properties properties;
  Forces forces;
  const Tyre& first = model.tyres[tyres.front()];
  each_argument(first, wheel, properties, [&](const std::string& name, Expr&) { law.arguments.push_back({name}); });
  each_result(first, forces, [&](const std::string& name, Expr&) { law.results.push_back(name); });
  law.tyres = std::move(tyres);
  return law;
}

/// Takes out of the program around a law the arguments that are numbers, and all but one of equal values.
void gather_constants(SharedLaw& law, SlotGroup group, Program& around) {
  const std::size_t elements = law.tyres.size();
  std::vector<ValueId> given(law.arguments.size() * elements, kNoValue);
  for (const OutputValue& output : around.outputs)
    if (output.slot.group == group) given[static_cast<std::size_t>(output.slot.index)] = output.value;
  std::erase_if(around.outputs, [&](const OutputValue& output) { return output.slot.group == group; });
  for (std::size_t a = 0; a < law.arguments.size(); ++a) {
    LawArgument& argument = law.arguments[a];
    const std::span<const ValueId> values = std::span(given).subspan(a * elements, elements);
    if (std::ranges::all_of(values, [&](ValueId v) { return around.nodes[v].op == Op::constant; }))
      for (const ValueId v : values) argument.numbers.push_back(around.nodes[v].constant);
    const auto same = [](const auto& all) { return std::ranges::count(all, all[0]) == std::ssize(all); };
    argument.is_common = argument.numbers.empty() ? same(values) : same(argument.numbers);
    if (!argument.numbers.empty()) continue;
    for (std::size_t k = 0; k < (argument.is_common ? 1 : elements); ++k)
      around.outputs.push_back({{group, argument_place(law, a, k)}, values[k]});
  }
}

Program traced_law(const Model& model, const SharedLaw& law) {
  ProgramBuilder builder("tyres");
  Annotator<Expr> annotator{builder};
  const auto step = annotator.step(Step::forces);
  Wheel wheel;
  Properties properties;
  const Tyre& first = model.tyres[law.tyres.front()];
  properties.turning = detail::turning_of(first);
  properties.ellipse = first.combined_slip == CombinedSlip::ellipse;
  int argument = 0;
  each_argument(first, wheel, properties, [&](const std::string&, Expr& number) {
    const LawArgument& known = law.arguments[static_cast<std::size_t>(argument)];
    number = known.is_common && !known.numbers.empty() ? Expr(known.numbers[0])
                                                       : Expr(builder, builder.input(Array::law_argument, argument));
    ++argument;
  });
  std::vector<Expr> coefficients;
  for (const Quantity& q : first.coefficients) coefficients.emplace_back(q.value);
  const RoadContact<Expr> contact = road_contact(wheel, properties.radius);
  const TyreResult<Expr> tyre = detail::tyre_law(first.model, coefficients, properties, contact.motion);
  Forces forces{tyre_wrench(contact, tyre), tyre.du, tyre.dv, tyre.dturn};
  forces.wrench.angular = forces.wrench.angular + cross(contact.down, forces.wrench.linear);
  int result = 0;
  each_result(first, forces, [&](const std::string& name, Expr& number) {
    annotator.name(number, name);
    builder.output(Array::law_result, result++, number.value(builder));
  });
  return builder.finish_in_canonical_order();
}

}  // namespace

std::optional<AroundLaws> trace_around_laws(const Model& model, const Topology& topology, const Analysis& analysis,
                                            RecursionChoices choices) {
  std::vector<SharedLaw> laws;
  for (std::vector<int>& tyres : tyres_of_laws(model)) laws.push_back(planned_law(model, std::move(tyres)));
  if (laws.empty()) return {};
  Program around = trace_recursive_accelerations(model, topology, analysis, Role::accelerations, choices, laws);
  for (std::size_t k = 0; k < laws.size(); ++k) {
    gather_constants(laws[k], of_block(Array::law_argument, k), around);
    laws[k].program = traced_law(model, laws[k]);
  }
  return AroundLaws{std::move(around), std::move(laws)};
}

detail::SharedTyreLaw<Expr> shared_tyre_law(Tracing& tracing, const std::vector<SharedLaw>& laws) {
  return [&](std::size_t tyre, Properties properties, Wheel wheel) -> std::optional<Forces> {
    for (std::size_t k = 0; k < laws.size(); ++k) {
      const SharedLaw& law = laws[k];
      const auto place = std::ranges::find(law.tyres, static_cast<int>(tyre));
      if (place == law.tyres.end()) continue;
      const int elements = static_cast<int>(law.tyres.size()), element = static_cast<int>(place - law.tyres.begin());
      int argument = element, result = element;
      const Tyre& of = tracing.system.model.tyres[tyre];
      each_argument(of, wheel, properties, [&](const std::string&, Expr& number) {
        tracing.output(of_block(Array::law_argument, k), std::exchange(argument, argument + elements), number);
      });
      Forces forces;
      each_result(of, forces, [&](const std::string&, Expr& number) {
        number = tracing.input(of_block(Array::law_result, k), std::exchange(result, result + elements));
      });
      return forces;
    }
    return {};
  };
}

}  // namespace mbgen
