#include "compiler/emit/quantity_ranges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "compiler/emit/context_values.hpp"
#include "compiler/emit/expression_text.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/expressions/evaluate.hpp"

namespace mbgen {
namespace {

/// Parameters as symbols; the reader refuses all else in masses and inertias.
struct ParameterSymbols {
  ProgramBuilder& builder;

  Expr parameter(int index) const { return {builder, builder.input(Array::par, index)}; }
  Expr input(int) const { return {}; }
  Expr time() const { return {}; }
  Expr position(const CoordinateReference&) const { return {}; }
  Expr velocity(const CoordinateReference&) const { return {}; }
  Expr local(int) const { return {}; }
};

/// Expressions of parameters as C++ over `values`, in double precision.
struct ParameterTexts {
  const EmitContext& context;

  std::string parameter(int index) const {
    const auto before = std::span(context.model.parameters).first(static_cast<std::size_t>(index));
    const auto place = static_cast<std::size_t>(std::ranges::count_if(before, &Parameter::tunable));
    return fmt::format("static_cast<double>(values.{})", context.names.parameters[place]);
  }

  std::string text(const Quantity& quantity) const {
    if (quantity.expression < 0) return number_text(quantity.value);
    ProgramBuilder builder("quantity");
    builder.output(Array::y, 0,
                   evaluate<Expr>(quantity, context.model.expressions, ParameterSymbols{builder}).value(builder));
    const Program program = builder.finish();
    std::vector<Phrase> phrases;
    const auto phrase = [&](ValueId value) { return value == kNoValue ? Phrase{} : phrases[value]; };
    for (const Node& node : program.nodes) {
      if (node.op == Op::constant)
        phrases.push_back(constant_phrase(number_text(node.constant)));
      else if (node.op == Op::input)
        phrases.push_back({parameter(program.inputs[static_cast<std::size_t>(node.input)].index)});
      else
        phrases.push_back(operation_phrase(Scalar::doubles, node.op, phrase(node.operands[0]), phrase(node.operands[1]),
                                           phrase(node.operands[2])));
    }
    return phrases[program.outputs[0].value].text;
  }

  /// Whether several parameters determine it; a single parameter times positive factors has its own bound.
  bool is_joint(const Quantity& quantity) const {
    if (quantity.expression < 0) return false;
    int parameters = 0;
    bool is_product = true;
    for (const ExpressionNode& node : context.model.expressions[static_cast<std::size_t>(quantity.expression)].nodes) {
      using Kind = ExpressionNode::Kind;
      if (node.kind == Kind::parameter) ++parameters;
      if (node.kind == Kind::number) is_product = is_product && node.number > 0;
      if (node.kind == Kind::call)
        is_product = is_product && (node.function == Function::multiply || node.function == Function::divide);
    }
    return parameters > 1 || (parameters == 1 && !is_product);
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
  const ParameterTexts texts{context};
  std::vector<QuantityRange> list;
  const auto add_mass = [&](const std::string& name, const Quantity& mass) {
    if (texts.is_joint(mass)) list.push_back({"mass of " + name, texts.text(mass) + " < 0"});
  };
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    add_mass(body.name, body.mass);
    const bool is_tuned = std::any_of(body.inertia.begin(), body.inertia.end(),
                                      [](const Quantity& entry) { return entry.expression >= 0; });
    if (!is_tuned || static_cast<int>(i) == model.ground || is_fixed_to_another(model, static_cast<int>(i))) continue;
    std::string entries, written;
    for (const Quantity& entry : body.inertia) {
      entries += (entries.empty() ? "" : ", ") + texts.text(entry);
      written += (written.empty() ? "" : ", ") + number_text(entry.value);
    }
    list.push_back({"inertia of " + body.name, fmt::format("!mbgen::is_inertia({{{}}}, {{{}}})", entries, written)});
  }
  for (const Rod& rod : model.rods) add_mass(rod.name, rod.mass);
  return list;
}

bool has_quantities(const EmitContext& context) { return !quantity_ranges(context).empty(); }

void add_quantities(const EmitContext& context, std::vector<EmittedFile>& files) {
  const std::vector<QuantityRange> quantities = quantity_ranges(context);
  if (quantities.empty()) return;
  FrameRows rows;
  for (std::size_t i = 0; i < quantities.size(); ++i)
    rows.push_back({{"place", i}, {"name", string_literal(quantities[i].name)}, {"broken", quantities[i].broken}});
  files.push_back(
      {context.names.solver + "_quantities.hpp", fill_template(context, "quantities.hpp.in",
                                                               {{"banner", banner_text(context.model, "//")},
                                                                {"quantity_count", quantities.size()},
                                                                {"quantity_ranges", rows}})});
}

}  // namespace mbgen
