// Exact texts of the program room: every rule by its dump, the dump itself, the message of every broken invariant.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <clocale>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "compiler/passes/passes.hpp"
#include "compiler/program/program.hpp"

namespace mbgen {
namespace {

/// One operation appended by the builder itself: %0 and %1 are inputs x[0] and x[1].
using Append = std::function<ValueId(ProgramBuilder& builder, ValueId x, ValueId y)>;

/// Lines of the program of one output, without its head and its inputs; "->" is the output.
std::string text_of(const Append& append) {
  ProgramBuilder builder("rule");
  const ValueId x = builder.input(Array::x, 0), y = builder.input(Array::x, 1);
  builder.output(Array::y, 0, append(builder, x, y));
  const Program program = remove_dead_values(builder.finish());
  const std::string text = dump(program);
  std::string result;
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end + 1) {
    end = text.find('\n', begin);
    const std::string line = text.substr(begin, end - begin);
    if (line.starts_with("program") || line.find(" = input") != std::string::npos) continue;
    result += line.starts_with("out y[0] = ") ? fmt::format("-> {}", line.substr(11)) : line + "; ";
  }
  return result;
}

struct Rule {
  const char* name;
  Append append;
  const char* text;
};

void expect_texts(const std::vector<Rule>& rules) {
  for (const Rule& rule : rules) EXPECT_EQ(text_of(rule.append), rule.text) << rule.name;
}

ValueId negative(ProgramBuilder& b, ValueId x) { return b.append(Op::negate, x); }

TEST(RuleText, SumsAndDifferences) {
  using B = ProgramBuilder;
  expect_texts({
      {"x + 0", [](B& b, ValueId x, ValueId) { return b.append(Op::add, x, b.constant(0)); }, "-> %0"},
      {"0 + x", [](B& b, ValueId x, ValueId) { return b.append(Op::add, b.constant(0), x); }, "-> %0"},
      {"x + -0", [](B& b, ValueId x, ValueId) { return b.append(Op::add, x, b.constant(-0.0)); }, "-> %0"},
      {"x + (-y)", [](B& b, ValueId x, ValueId y) { return b.append(Op::add, x, negative(b, y)); },
       "%2 = sub %0 %1; -> %2"},
      {"(-x) + y", [](B& b, ValueId x, ValueId y) { return b.append(Op::add, negative(b, x), y); },
       "%2 = sub %1 %0; -> %2"},
      {"(-x) + (-y)", [](B& b, ValueId x, ValueId y) { return b.append(Op::add, negative(b, x), negative(b, y)); },
       "%2 = add %0 %1; %3 = neg %2; -> %3"},
      {"x + (-x)", [](B& b, ValueId x, ValueId) { return b.append(Op::add, x, negative(b, x)); },
       "%0 = constant 0; -> %0"},
      {"x + (-3)", [](B& b, ValueId x, ValueId) { return b.append(Op::add, x, b.constant(-3)); },
       "%1 = constant 3; %2 = sub %0 %1; -> %2"},
      {"y + x", [](B& b, ValueId x, ValueId y) { return b.append(Op::add, y, x); }, "%2 = add %0 %1; -> %2"},
      {"x + 3", [](B& b, ValueId x, ValueId) { return b.append(Op::add, x, b.constant(3)); },
       "%1 = constant 3; %2 = add %1 %0; -> %2"},
      {"x - 0", [](B& b, ValueId x, ValueId) { return b.append(Op::subtract, x, b.constant(0)); }, "-> %0"},
      {"0 - x", [](B& b, ValueId x, ValueId) { return b.append(Op::subtract, b.constant(0), x); },
       "%1 = neg %0; -> %1"},
      {"x - x", [](B& b, ValueId x, ValueId) { return b.append(Op::subtract, x, x); }, "%0 = constant 0; -> %0"},
      {"y - x", [](B& b, ValueId x, ValueId y) { return b.append(Op::subtract, y, x); }, "%2 = sub %1 %0; -> %2"},
      {"x - (-y)", [](B& b, ValueId x, ValueId y) { return b.append(Op::subtract, x, negative(b, y)); },
       "%2 = add %0 %1; -> %2"},
      {"(-x) - y", [](B& b, ValueId x, ValueId y) { return b.append(Op::subtract, negative(b, x), y); },
       "%2 = add %0 %1; %3 = neg %2; -> %3"},
      {"(-x) - (-y)", [](B& b, ValueId x, ValueId y) { return b.append(Op::subtract, negative(b, x), negative(b, y)); },
       "%2 = sub %1 %0; -> %2"},
      {"--x", [](B& b, ValueId x, ValueId) { return negative(b, negative(b, x)); }, "-> %0"},
  });
}

TEST(RuleText, ProductsAndQuotients) {
  using B = ProgramBuilder;
  expect_texts({
      {"x * 0", [](B& b, ValueId x, ValueId) { return b.append(Op::multiply, x, b.constant(0)); },
       "%0 = constant 0; -> %0"},
      {"x * 1", [](B& b, ValueId x, ValueId) { return b.append(Op::multiply, x, b.constant(1)); }, "-> %0"},
      {"x * -1", [](B& b, ValueId x, ValueId) { return b.append(Op::multiply, x, b.constant(-1)); },
       "%1 = neg %0; -> %1"},
      {"x * -3", [](B& b, ValueId x, ValueId) { return b.append(Op::multiply, x, b.constant(-3)); },
       "%1 = constant 3; %2 = mul %1 %0; %3 = neg %2; -> %3"},
      {"y * x", [](B& b, ValueId x, ValueId y) { return b.append(Op::multiply, y, x); }, "%2 = mul %0 %1; -> %2"},
      {"(-x) * y", [](B& b, ValueId x, ValueId y) { return b.append(Op::multiply, negative(b, x), y); },
       "%2 = mul %0 %1; %3 = neg %2; -> %3"},
      {"x * (-y)", [](B& b, ValueId x, ValueId y) { return b.append(Op::multiply, x, negative(b, y)); },
       "%2 = mul %0 %1; %3 = neg %2; -> %3"},
      {"(-x) * (-y)", [](B& b, ValueId x, ValueId y) { return b.append(Op::multiply, negative(b, x), negative(b, y)); },
       "%2 = mul %0 %1; -> %2"},
      {"0 / x", [](B& b, ValueId x, ValueId) { return b.append(Op::divide, b.constant(0), x); },
       "%0 = constant 0; -> %0"},
      {"x / 1", [](B& b, ValueId x, ValueId) { return b.append(Op::divide, x, b.constant(1)); }, "-> %0"},
      {"x / -1", [](B& b, ValueId x, ValueId) { return b.append(Op::divide, x, b.constant(-1)); },
       "%1 = neg %0; -> %1"},
      {"x / 8", [](B& b, ValueId x, ValueId) { return b.append(Op::divide, x, b.constant(8)); },
       "%1 = constant 0.125; %2 = mul %1 %0; -> %2"},
      {"x / 3", [](B& b, ValueId x, ValueId) { return b.append(Op::divide, x, b.constant(3)); },
       "%1 = constant 3; %2 = div %0 %1; -> %2"},
      {"x / 5e-324", [](B& b, ValueId x, ValueId) { return b.append(Op::divide, x, b.constant(5e-324)); },
       "%1 = constant 5e-324; %2 = div %0 %1; -> %2"},
      {"x / 0", [](B& b, ValueId x, ValueId) { return b.append(Op::divide, x, b.constant(0)); },
       "%1 = constant 0; %2 = div %0 %1; -> %2"},
      {"(-x) / y", [](B& b, ValueId x, ValueId y) { return b.append(Op::divide, negative(b, x), y); },
       "%2 = div %0 %1; %3 = neg %2; -> %3"},
      {"x / (-y)", [](B& b, ValueId x, ValueId y) { return b.append(Op::divide, x, negative(b, y)); },
       "%2 = div %0 %1; %3 = neg %2; -> %3"},
      {"(-x) / (-y)", [](B& b, ValueId x, ValueId y) { return b.append(Op::divide, negative(b, x), negative(b, y)); },
       "%2 = div %0 %1; -> %2"},
  });
}

TEST(RuleText, Functions) {
  using B = ProgramBuilder;
  for (const Op op : {Op::sin, Op::tan, Op::asin, Op::atan, Op::tanh}) {
    EXPECT_EQ(text_of([op](B& b, ValueId x, ValueId) { return b.append(op, negative(b, x)); }),
              fmt::format("%1 = {} %0; %2 = neg %1; -> %2", op_name(op)));
  }
  for (const Op op : {Op::cos, Op::abs}) {
    EXPECT_EQ(text_of([op](B& b, ValueId x, ValueId) { return b.append(op, negative(b, x)); }),
              fmt::format("%1 = {} %0; -> %1", op_name(op)));
  }
  for (const Op op : {Op::sqrt, Op::acos, Op::exp, Op::log}) {
    EXPECT_EQ(text_of([op](B& b, ValueId x, ValueId) { return b.append(op, negative(b, x)); }),
              fmt::format("%1 = neg %0; %2 = {} %1; -> %2", op_name(op)));
  }
  expect_texts({
      {"pow(x, 0)", [](B& b, ValueId x, ValueId) { return b.append(Op::pow, x, b.constant(0)); },
       "%0 = constant 1; -> %0"},
      {"pow(x, 1)", [](B& b, ValueId x, ValueId) { return b.append(Op::pow, x, b.constant(1)); }, "-> %0"},
      {"pow(x, 2)", [](B& b, ValueId x, ValueId) { return b.append(Op::pow, x, b.constant(2)); },
       "%1 = mul %0 %0; -> %1"},
      {"pow(x, 3)", [](B& b, ValueId x, ValueId) { return b.append(Op::pow, x, b.constant(3)); },
       "%1 = constant 3; %2 = pow %0 %1; -> %2"},
      {"pow(y, x)", [](B& b, ValueId x, ValueId y) { return b.append(Op::pow, y, x); }, "%2 = pow %1 %0; -> %2"},
      {"atan2(y, x)", [](B& b, ValueId x, ValueId y) { return b.append(Op::atan2, y, x); }, "%2 = atan2 %1 %0; -> %2"},
      {"min(y, x)", [](B& b, ValueId x, ValueId y) { return b.append(Op::min, y, x); }, "%2 = min %0 %1; -> %2"},
      {"max(y, x)", [](B& b, ValueId x, ValueId y) { return b.append(Op::max, y, x); }, "%2 = max %0 %1; -> %2"},
      {"select(0, x, y)", [](B& b, ValueId x, ValueId y) { return b.append(Op::select, b.constant(0), x, y); },
       "-> %0"},
      {"select(-1, x, y)", [](B& b, ValueId x, ValueId y) { return b.append(Op::select, b.constant(-1), y, x); },
       "-> %0"},
      {"select(y, x, x)", [](B& b, ValueId x, ValueId y) { return b.append(Op::select, y, x, x); }, "-> %0"},
      {"select(x, y, x)", [](B& b, ValueId x, ValueId y) { return b.append(Op::select, x, y, x); },
       "%2 = select %0 %1 %0; -> %2"},
  });
}

TEST(RuleText, ConstantsFoldUnlessTheResultIsNotFinite) {
  using B = ProgramBuilder;
  expect_texts({
      {"0.1 + 0.2", [](B& b, ValueId, ValueId) { return b.append(Op::add, b.constant(0.1), b.constant(0.2)); },
       "%0 = constant 0.3; -> %0"},
      {"sin 1", [](B& b, ValueId, ValueId) { return b.append(Op::sin, b.constant(1)); },
       "%0 = constant 0.8414709848078965; -> %0"},
      {"select(-1, 2, 3)",
       [](B& b, ValueId, ValueId) { return b.append(Op::select, b.constant(-1), b.constant(2), b.constant(3)); },
       "%0 = constant 3; -> %0"},
      {"0 / 0", [](B& b, ValueId, ValueId) { return b.append(Op::divide, b.constant(0), b.constant(0)); },
       "%0 = constant 0; %1 = div %0 %0; -> %1"},
      {"sqrt -4", [](B& b, ValueId, ValueId) { return b.append(Op::sqrt, b.constant(-4)); },
       "%0 = constant -4; %1 = sqrt %0; -> %1"},
      {"1e308 * 1e308",
       [](B& b, ValueId, ValueId) { return b.append(Op::multiply, b.constant(1e308), b.constant(1e308)); },
       "%0 = constant 1e+308; %1 = mul %0 %0; -> %1"},
  });
}

TEST(Dump, NamesSectionsBlocksAndLabelsWhereTheyChange) {
  ProgramBuilder builder("two_steps");
  const Expr z(builder, builder.input(Array::z, 3)), zd(builder, builder.input(Array::zd, 0));
  builder.set_section({Step::inertias});
  builder.set_owner({OwnerKind::tree_body, 0});
  const Expr s = sin(z);
  builder.label(s.value(builder), "R_crank_xz");
  const Expr velocity = s * zd + 0.1;
  builder.set_section({Step::accelerations, 2});
  const Expr force = velocity * velocity;
  builder.set_owner({});
  builder.output(Array::zdd, 0, (force - sin(z)).value(builder));
  builder.output(Array::y, 4, zd.value(builder));
  EXPECT_EQ(dump(builder.finish()),
            "program two_steps\n"
            "%0 = input z[3]\n"
            "%1 = input zd[0]\n"
            "; section step 1\n"
            "; owner tree_body 0\n"
            "%2 = sin %0  ; R_crank_xz\n"
            "%3 = mul %1 %2\n"
            "%4 = constant 0.1\n"
            "%5 = add %4 %3\n"
            "; section step 7, block 2\n"
            "%6 = mul %5 %5\n"
            "; owner\n"
            "%7 = sub %6 %2\n"
            "out zdd[0] = %7\n"
            "out y[4] = %1\n");
}

TEST(Dump, PrintsTheShortestConstantsThatReadBack) {
  for (const double value : {0.1, 1.0 / 3.0, -1e-300, 6.02214076e23, std::numeric_limits<double>::min()}) {
    ProgramBuilder builder("f");
    builder.output(Array::y, 0, builder.constant(value));
    const std::string text = dump(builder.finish());
    const std::string start = "program f\n%0 = constant ";
    ASSERT_TRUE(text.starts_with(start)) << text;
    EXPECT_EQ(std::stod(text.substr(start.size())), value);
  }
}

TEST(Dump, DoesNotAskTheLocale) {
  const std::string former = std::setlocale(LC_NUMERIC, nullptr);
  // Where none of these is installed there is no comma to fear.
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
    if (std::setlocale(LC_NUMERIC, name) != nullptr) break;
  }
  ProgramBuilder builder("f");
  builder.output(Array::y, 0, builder.constant(0.5));
  const std::string text = dump(builder.finish());
  std::setlocale(LC_NUMERIC, former.c_str());
  EXPECT_EQ(text, "program f\n%0 = constant 0.5\nout y[0] = %0\n");
}

/// %0, %1 inputs, %2 = constant 0.5, %3 = mul, %4 = sin
Program sound_program() {
  ProgramBuilder builder("sound");
  const Expr x(builder, builder.input(Array::x, 0)), y(builder, builder.input(Array::x, 1));
  const Expr result = sin(0.5 * x);
  builder.output(Array::y, 0, result.value(builder));
  builder.output(Array::y, 1, y.value(builder));
  return builder.finish();
}

TEST(VerifyText, NamesTheFirstBrokenInvariant) {
  struct Case {
    std::function<void(Program&)> damage;
    const char* text;
  };
  const std::vector<Case> cases = {
      {[](Program&) {}, ""},
      {[](Program& p) { p.nodes[4].operands[0] = 4; }, "%4: operand %4 is not earlier"},
      {[](Program& p) { p.nodes[4].operands[0] = 77; }, "%4: operand %77 is not earlier"},
      {[](Program& p) { p.nodes[3].operands[1] = kNoValue; }, "%3: mul lacks operand 1"},
      {[](Program& p) { p.nodes[4].operands[1] = 0; }, "%4: sin has a surplus operand 1"},
      {[](Program& p) { p.nodes[0].operands[0] = 0; }, "%0: input has a surplus operand 0"},
      {[](Program& p) { p.nodes[4].op = static_cast<Op>(200); }, "%4: unknown operation 200"},
      {[](Program& p) { p.nodes[2].constant = std::numeric_limits<double>::infinity(); },
       "%2: constant inf is not finite"},
      {[](Program& p) { p.nodes[2].constant = std::numeric_limits<double>::quiet_NaN(); },
       "%2: constant nan is not finite"},
      {[](Program& p) { p.nodes[1].input = 2; }, "%1: no input 2"},
      {[](Program& p) { p.nodes[1].input = -1; }, "%1: no input -1"},
      {[](Program& p) { p.nodes[1].input = 0; }, "%1: second value of input x[0]"},
      {[](Program& p) {
         p.nodes[3].section = {Step::forces, 1};
       },
       "%3: no section \"step 5, block 1\""},
      {[](Program& p) { p.nodes[3].label = 0; }, "%3: no label 0"},
      {[](Program& p) { p.nodes[3].label = -2; }, "%3: no label -2"},
      {[](Program& p) { p.sections.push_back({}); }, "section \"\" appears twice"},
      {[](Program& p) { p.inputs[1].index = 0; }, "input x[0] appears twice"},
      {[](Program& p) { p.inputs[1].index = -3; }, "input x[-3] has a negative index"},
      {[](Program& p) { p.outputs[1].slot.index = 0; }, "output y[0] appears twice"},
      {[](Program& p) { p.outputs[1].value = kNoValue; }, "output y[1] has no value"},
      {[](Program& p) { p.outputs[1].value = 5; }, "output y[1] has no value"},
  };
  for (const Case& broken : cases) {
    Program program = sound_program();
    broken.damage(program);
    EXPECT_EQ(verify(program), broken.text);
  }
}

TEST(VerifyText, StandsBehindEveryDoor) {
  ProgramBuilder builder("doubled");
  const ValueId x = builder.input(Array::x, 0);
  builder.output(Array::y, 0, x);
  builder.output(Array::y, 0, x);
  try {
    builder.finish();
    FAIL() << "finish let a broken program out";
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(), "program doubled: output y[0] appears twice");
  }
  EXPECT_EQ(dump(builder.finish()), "program \n") << "the builder is empty after finish";
}

TEST(Builder, RefusesWrongOperands) {
  ProgramBuilder builder("f"), other("g");
  const ValueId x = builder.input(Array::x, 0);
  EXPECT_THROW(builder.append(Op::add, x), std::logic_error);
  EXPECT_THROW(builder.append(Op::sin, x, x), std::logic_error);
  EXPECT_THROW(builder.append(Op::sin, x + 1), std::logic_error);
  EXPECT_THROW(builder.append(Op::input, x), std::logic_error);
  EXPECT_THROW(Expr(builder, x) + Expr(other, other.input(Array::x, 0)), std::logic_error);
  EXPECT_THROW(interpret(sound_program(), std::vector<double>{1}), std::invalid_argument);
}

TEST(Builder, LeavesNoTraceOfNeutralConstants) {
  ProgramBuilder builder("f");
  const Expr x(builder, builder.input(Array::x, 0));
  const Expr y = ((x + 0.0) * 1.0 - 0.0) / 1.0 + x * 0.0 + 0.0 * x;
  EXPECT_EQ(y.value(builder), x.value(builder));
  builder.output(Array::y, 0, y.value(builder));
  EXPECT_EQ(builder.finish().nodes.size(), 1u);
}

}  // namespace
}  // namespace mbgen
