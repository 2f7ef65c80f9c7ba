#include "compiler/emit/quantity_ranges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "compiler/emit/context_values.hpp"
#include "compiler/emit/expression_text.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/expressions/evaluate.hpp"
#include "compiler/model/inputs.hpp"

namespace mbgen {
namespace {

/// Parameters and inputs as symbols; bounded quantities are of nothing else.
struct SettingSymbols {
  ProgramBuilder& builder;

  Expr parameter(int index) const { return {builder, builder.input(Array::par, index)}; }
  Expr input(int index) const { return {builder, builder.input(Array::in, index)}; }
  Expr time() const { return {}; }
  Expr position(const CoordinateReference&) const { return {}; }
  Expr velocity(const CoordinateReference&) const { return {}; }
  Expr local(int) const { return {}; }
};

/// Expressions of parameters and inputs as C++ over `values` and `inputs`, in double precision.
struct SettingTexts {
  const EmitContext& context;

  std::string parameter(int index) const {
    const auto before = std::span(context.model.parameters).first(static_cast<std::size_t>(index));
    const auto place = static_cast<std::size_t>(std::ranges::count_if(before, &Parameter::tunable));
    return fmt::format("static_cast<double>(values.{})", context.names.parameters[place]);
  }

  std::string setting(const Slot& slot) const {
    if (slot.group.array == Array::par) return parameter(slot.index);
    return fmt::format("static_cast<double>(inputs.{})", context.names.inputs[static_cast<std::size_t>(slot.index)]);
  }

  std::string text(const Quantity& quantity) const {
    if (quantity.expression < 0) return number_text(quantity.value);
    ProgramBuilder builder("quantity");
    builder.output(Array::y, 0,
                   evaluate<Expr>(quantity, context.model.expressions, SettingSymbols{builder}).value(builder));
    const Program program = builder.finish();
    std::vector<Phrase> phrases;
    const auto phrase = [&](ValueId value) { return value == kNoValue ? Phrase{} : phrases[value]; };
    for (const Node& node : program.nodes) {
      if (node.op == Op::constant)
        phrases.push_back(constant_phrase(number_text(node.constant)));
      else if (node.op == Op::input)
        phrases.push_back({setting(program.inputs[static_cast<std::size_t>(node.input)])});
      else
        phrases.push_back(operation_phrase(Scalar::doubles, node.op, phrase(node.operands[0]), phrase(node.operands[1]),
                                           phrase(node.operands[2])));
    }
    return phrases[program.outputs[0].value].text;
  }
};

bool is_fixed_to_another(const Model& model, int body) {
  return std::any_of(model.joints.begin(), model.joints.end(), [&](const Joint& joint) {
    return joint.type == JointType::fixed && (joint.from.body == body || joint.to.body == body);
  });
}

}  // namespace

std::vector<QuantityRange> quantity_ranges(const EmitContext& context) {
  const Model& model = context.model;
  const SettingTexts texts{context};
  std::vector<QuantityRange> list;
  const auto function_of = [](QuantityBound bound) {
    return bound == QuantityBound::positive ? "is_positive"
           : bound == QuantityBound::share  ? "is_share"
                                            : "is_not_negative";
  };
  for (const BoundedQuantity& bounded : bounded_quantities(model)) {
    list.push_back({bounded.name,
                    fmt::format("!mbgen::{}({})", function_of(bounded.bound), texts.text(bounded.quantity)),
                    bounded.takes_inputs});
  }
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    const bool is_tuned = std::any_of(body.inertia.begin(), body.inertia.end(),
                                      [](const Quantity& entry) { return entry.expression >= 0; });
    if (!is_tuned || static_cast<int>(i) == model.ground || is_fixed_to_another(model, static_cast<int>(i))) continue;
    std::string entries, written;
    for (const Quantity& entry : body.inertia) {
      entries += (entries.empty() ? "" : ", ") + texts.text(entry);
      written += (written.empty() ? "" : ", ") + number_text(entry.value);
    }
    list.push_back(
        {"inertia of " + body.name, fmt::format("!mbgen::is_inertia({{{}}}, {{{}}})", entries, written), false});
  }
  return list;
}

bool has_quantities(const EmitContext& context) { return !quantity_ranges(context).empty(); }

bool has_input_quantities(const EmitContext& context) {
  return std::ranges::any_of(quantity_ranges(context), &QuantityRange::takes_inputs);
}

void add_quantities(const EmitContext& context, std::vector<EmittedFile>& files) {
  const std::vector<QuantityRange> quantities = quantity_ranges(context);
  if (quantities.empty()) return;
  FrameRows names, of_parameters, of_both;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    names.push_back({{"name", string_literal(quantities[i].name)}});
    (quantities[i].takes_inputs ? of_both : of_parameters).push_back({{"place", i}, {"broken", quantities[i].broken}});
  }
  files.push_back(
      {context.names.solver + "_quantities.hpp", fill_template(context, "quantities.hpp.in",
                                                               {{"banner", banner_text(context.model, "//")},
                                                                {"quantity_count", quantities.size()},
                                                                {"quantity_names", names},
                                                                {"of_parameters", of_parameters},
                                                                {"of_both", of_both}})});
}

}  // namespace mbgen
