#include "compiler/emit/quantity_ranges.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/emit/context_values.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

/// Expressions of parameters as C++ over `values`, in double precision.
struct ParameterTexts {
  const EmitContext& context;

  std::string parameter(int index) const {
    std::size_t place = 0;
    for (int i = 0; i < index; ++i) place += context.model.parameters[static_cast<std::size_t>(i)].tunable ? 1 : 0;
    return fmt::format("static_cast<double>(values.{})", context.names.parameters[place]);
  }

  static std::string call(Function function, const std::string& a, const std::string& b, const std::string& c) {
    const auto named = [&](const char* name) { return fmt::format("std::{}({})", name, a); };
    switch (function) {
      case Function::add:
        return fmt::format("({} + {})", a, b);
      case Function::subtract:
        return fmt::format("({} - {})", a, b);
      case Function::multiply:
        return fmt::format("({} * {})", a, b);
      case Function::divide:
        return fmt::format("({} / {})", a, b);
      case Function::negate:
        return fmt::format("(-{})", a);
      case Function::power:
        return fmt::format("std::pow({}, {})", a, b);
      case Function::sqrt:
        return named("sqrt");
      case Function::sin:
        return named("sin");
      case Function::cos:
        return named("cos");
      case Function::tan:
        return named("tan");
      case Function::asin:
        return named("asin");
      case Function::acos:
        return named("acos");
      case Function::atan:
        return named("atan");
      case Function::atan2:
        return fmt::format("std::atan2({}, {})", a, b);
      case Function::exp:
        return named("exp");
      case Function::log:
        return named("log");
      case Function::tanh:
        return named("tanh");
      case Function::abs:
        return named("fabs");
      case Function::min:
        return fmt::format("std::fmin({}, {})", a, b);
      case Function::max:
        return fmt::format("std::fmax({}, {})", a, b);
      case Function::sign:
        return fmt::format("({0} > 0 ? 1.0 : {0} < 0 ? -1.0 : 0.0)", a);
      case Function::step:
        return fmt::format("({} >= 0 ? 1.0 : 0.0)", a);
      case Function::select:
        return fmt::format("({} >= 0 ? {} : {})", a, b, c);
    }
    return a;
  }

  std::string text(const Quantity& quantity) const {
    if (quantity.expression < 0) return number_text(quantity.value);
    std::vector<std::string> texts;
    const auto operand = [&](int index) { return index < 0 ? std::string() : texts[static_cast<std::size_t>(index)]; };
    for (const ExpressionNode& node : context.model.expressions[static_cast<std::size_t>(quantity.expression)].nodes) {
      if (node.kind == ExpressionNode::Kind::number)
        texts.push_back(number_text(node.number));
      else if (node.kind == ExpressionNode::Kind::parameter)
        texts.push_back(parameter(node.index));
      else
        texts.push_back(call(node.function, operand(node.first), operand(node.second), operand(node.third)));
    }
    return texts.back();
  }

  /// Whether parameters make it, and not one alone by positive factors, which has its bound itself.
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
