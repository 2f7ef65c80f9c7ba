// Bytes as an expression, after one byte that says what it may depend on: diagnostics inside the text, or an expression
// that has a value and a program.
#include <array>
#include <cmath>

#include "compiler/expressions/evaluate.hpp"
#include "compiler/expressions/parse_expression.hpp"
#include "compiler/passes/passes.hpp"
#include "fuzz_support.hpp"

namespace {

using namespace mbgen;

constexpr std::array<std::string_view, 2> kLocals = {"length", "rate"};

reading::Names names() {
  reading::Names names;
  names.parameters = {{"k", 0}, {"c", 1}};
  names.inputs = {{"u", 0}};
  names.coordinates = {{{"pin", {0, 0}}, {"ball_x", {1, 0}}}};
  names.later_parameters = {{"later", 2}};
  names.unreadable_joints = {"broken"};
  return names;
}

std::vector<Parameter> parameters() {
  std::vector<Parameter> list(2);
  list[0].value = 3;
  list[0].tunable = true;
  list[1].value = -0.5;
  return list;
}

struct Numbers {
  double parameter(int index) const { return 3 - 3.5 * index; }
  double input(int) const { return 0.7; }
  double time() const { return 1.3; }
  double position(const CoordinateReference& z) const { return 0.2 - z.joint; }
  double velocity(const CoordinateReference& z) const { return -1.1 + z.joint; }
  double local(int index) const { return 0.4 + index; }
};

/// The same names as inputs of a program.
struct Symbols {
  ProgramBuilder& builder;
  Expr input_of(Array array, int index) const { return Expr(builder, builder.input(array, index)); }
  Expr parameter(int index) const { return input_of(Array::par, index); }
  Expr input(int index) const { return input_of(Array::in, index); }
  Expr time() const { return input_of(Array::t, 0); }
  Expr position(const CoordinateReference& z) const { return input_of(Array::z, z.joint); }
  Expr velocity(const CoordinateReference& z) const { return input_of(Array::zd, z.joint); }
  Expr local(int index) const { return input_of(Array::x, index); }
};

double value_of(const Slot& slot) {
  const Numbers numbers;
  if (slot.group == Array::par) return numbers.parameter(slot.index);
  if (slot.group == Array::in) return numbers.input(slot.index);
  if (slot.group == Array::t) return numbers.time();
  if (slot.group == Array::x) return numbers.local(slot.index);
  const CoordinateReference z{slot.index, 0};
  return slot.group == Array::z ? numbers.position(z) : numbers.velocity(z);
}

double interpreted(const Program& program) {
  std::vector<double> inputs;
  for (const Slot& slot : program.inputs) inputs.push_back(value_of(slot));
  return interpret(program, inputs).at(0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const reading::Names known = names();
  static const std::vector<Parameter> list = parameters();
  static const reading::Visibility visible = {{0, {}, {}}};
  const std::string text = fuzz::text_of(data + 1, size - 1);
  const auto depends = static_cast<reading::Depends>(data[0] % 4);
  const bool has_locals = data[0] / 4 % 2 == 1;
  const reading::ExpressionScope scope{.names = known,
                                       .visible = visible,
                                       .parameters = list,
                                       .expressions = {},
                                       .depends = depends,
                                       .locals = has_locals ? kLocals : std::span<const std::string_view>()};
  const reading::ParsedExpression parsed = reading::parse_expression(text, scope);
  for (const reading::ExpressionProblem& problem : parsed.problems) {
    fuzz::require(problem.offset <= text.size(), "a problem stands inside the text");
    fuzz::require(!problem.message.empty(), "a problem has a message");
  }
  if (!parsed.problems.empty()) return 0;
  fuzz::require(!parsed.expression.nodes.empty(), "an expression has a value");
  evaluate<double>(parsed.expression, Numbers{});

  ProgramBuilder builder("expression");
  const Expr result = evaluate<Expr>(parsed.expression, Symbols{builder});
  if (result.is_constant() && !std::isfinite(result.constant())) return 0;
  builder.output(Array::y, 0, result.value(builder));
  const Program program = builder.finish();
  interpreted(program);
  interpreted(optimise(program));
  return 0;
}
