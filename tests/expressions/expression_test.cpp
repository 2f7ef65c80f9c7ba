// Expressions: grammar, folding, evaluation at double and at jets; jets against finite differences.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compiler/expressions/evaluate.hpp"
#include "compiler/model/moving.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

/// Values that no two names share.
struct Environment {
  double now = 0.7;
  double parameter(int index) const { return 2 + index; }
  double input(int index) const { return 20 + index; }
  double time() const { return now; }
  double position(const CoordinateReference&) const { return 0.25; }
  double velocity(const CoordinateReference&) const { return -0.5; }
  double local(int index) const { return 200 + index; }
};

/// A model whose only output is the expression; k is tunable, c is not.
Model model_of(const std::string& expression) {
  return read(arm_model(R"("parameters": { "k": { "value": 1, "tunable": true }, "c": 5 }, "inputs": { "u": {} },
    "outputs": { "y": { "expression": ")" +
                        expression + "\" } }"));
}

const Quantity& output(const Model& model) { return std::get<ExpressionOutput>(model.outputs.at(0).source).value; }

double value(const std::string& expression) {
  const Model model = model_of(expression);
  return model.outputs.empty() ? NAN : evaluate<double>(output(model), model.expressions, Environment{});
}

/// How many nodes are left after folding; 0 for a constant.
std::size_t node_count(const std::string& expression) {
  const Model model = model_of(expression);
  const int index = output(model).expression;
  return index < 0 ? 0 : model.expressions[static_cast<std::size_t>(index)].nodes.size();
}

TEST(Expression, PrecedenceAndAssociativity) {
  EXPECT_EQ(value("1 + 2*3"), 7);
  EXPECT_EQ(value("(1 + 2)*3"), 9);
  EXPECT_EQ(value("7 - 2 - 1"), 4);
  EXPECT_EQ(value("12/3/2"), 2);
  EXPECT_EQ(value("-2^2"), -4);
  EXPECT_EQ(value("2^-1"), 0.5);
  EXPECT_EQ(value("2^3^2"), 512);
  EXPECT_EQ(value("2*-3"), -6);
  EXPECT_EQ(value("--3 - +-4"), 7);
  EXPECT_EQ(value("-t^2"), -(0.7 * 0.7));
  EXPECT_EQ(value(" 1.5e1\\t+ .5 "), 15.5);
}

TEST(Expression, NamesMeanWhatTheyAre) {
  EXPECT_EQ(value("k"), 2);
  EXPECT_EQ(value("c"), 5);
  EXPECT_EQ(value("u"), 20);
  EXPECT_EQ(value("t"), 0.7);
  EXPECT_EQ(value("pi"), std::numbers::pi);
  EXPECT_EQ(value("z.pin"), 0.25);
  EXPECT_EQ(value("zd.pin"), -0.5);
}

TEST(Expression, EveryFunctionMatchesTheLibrary) {
  const volatile double t = 0.7;  // volatile: compared with the library, not with the compiler's folding
  EXPECT_EQ(value("sqrt(t)"), std::sqrt(t));
  EXPECT_EQ(value("sin(t)"), std::sin(t));
  EXPECT_EQ(value("cos(t)"), std::cos(t));
  EXPECT_EQ(value("tan(t)"), std::tan(t));
  EXPECT_EQ(value("asin(t)"), std::asin(t));
  EXPECT_EQ(value("acos(t)"), std::acos(t));
  EXPECT_EQ(value("atan(t)"), std::atan(t));
  EXPECT_EQ(value("atan2(t, -u)"), std::atan2(t, -20));
  EXPECT_EQ(value("exp(t)"), std::exp(t));
  EXPECT_EQ(value("log(t)"), std::log(t));
  EXPECT_EQ(value("tanh(t)"), std::tanh(t));
  EXPECT_EQ(value("abs(zd.pin)"), 0.5);
  EXPECT_EQ(value("min(t, z.pin)"), 0.25);
  EXPECT_EQ(value("max(t, z.pin)"), 0.7);
  EXPECT_EQ(value("pow(t, z.pin)"), std::pow(t, 0.25));
  EXPECT_EQ(value("t^z.pin"), std::pow(t, 0.25));
  EXPECT_EQ(value("select(zd.pin, 1, t)"), 0.7);
  EXPECT_EQ(value("select(zd.pin + 0.5, 1, t)"), 1) << "zero selects the first";
}

TEST(Expression, SignAndStepAtZero) {
  EXPECT_EQ(value("sign(zd.pin)"), -1);
  EXPECT_EQ(value("sign(zd.pin + 0.5)"), 0);
  EXPECT_EQ(value("sign(t)"), 1);
  EXPECT_EQ(value("step(zd.pin)"), 0);
  EXPECT_EQ(value("step(zd.pin + 0.5)"), 1);
}

TEST(Expression, SmallWholePowersAreProducts) {
  EXPECT_EQ(value("zd.pin^2"), 0.25);
  EXPECT_EQ(value("zd.pin^3"), -0.125);
  EXPECT_EQ(value("zd.pin^-1"), -2);
  EXPECT_EQ(value("zd.pin^-3"), -8);
  EXPECT_EQ(value("zd.pin^0"), 1);
  EXPECT_EQ(value("t^2"), 0.7 * 0.7);
  EXPECT_EQ(value("t^3"), 0.7 * 0.7 * 0.7);
  EXPECT_EQ(value("t^0.5"), std::sqrt(0.7));
  EXPECT_EQ(value("t^9.5"), std::pow(0.7, 9.5));
}

TEST(Expression, ConstantsFold) {
  EXPECT_EQ(node_count("2*sin(c*pi/6)^2 + select(1, c, 2)"), 0u);
  EXPECT_EQ(node_count("t"), 1u);
  EXPECT_EQ(node_count("2*c*t"), 3u);
  EXPECT_EQ(node_count("t*2*c"), 5u) << "folding does not reorder";
  EXPECT_EQ(node_count("k"), 1u) << "tunable parameters stay";
  EXPECT_EQ(node_count("sin(t) + atan2(2*c, 3)"), 4u);
}

TEST(Expression, NodesArePostfix) {
  const Model model = model_of("select(t - c, -u*k, sqrt(z.pin)/(2 + t))");
  for (const Expression& expression : model.expressions) {
    for (std::size_t i = 0; i < expression.nodes.size(); ++i) {
      const ExpressionNode& node = expression.nodes[i];
      for (const int operand : {node.first, node.second, node.third}) EXPECT_LT(operand, static_cast<int>(i));
      EXPECT_EQ(node.kind == ExpressionNode::Kind::call, node.first >= 0);
    }
  }
}

TEST(Expression, ReferenceValueUsesDefaults) {
  const Model model = read(arm_model(R"--("parameters": { "k": { "value": 3, "tunable": true } },
    "inputs": { "u": { "default": 7 } },
    "outputs": { "y": { "expression": "100*k + 10*u + t + z.pin + cos(zd.pin)" } })--"));
  EXPECT_EQ(output(model).value, 371);
}

TEST(Expression, HoldsParametersThatFollowTunableOnes) {
  const Model model = read(arm_model(R"--("parameters": { "a": { "value": 5, "tunable": true }, "b": "3*a^2",
    "c": { "value": "b - 2", "unit": "m" } }, "outputs": { "y": { "expression": "a + c*b" } })--"));
  ASSERT_EQ(model.parameters.size(), 3u);
  EXPECT_EQ(model.parameters[2].value, 73);
  EXPECT_FALSE(model.parameters[2].tunable);
  const int expression = output(model).expression;
  ASSERT_GE(expression, 0);
  EXPECT_EQ(output(model).value, 5 + 73 * 75);
  // The environment's a is 2: both parameters go with it.
  EXPECT_EQ(evaluate<double>(model.expressions.at(expression), Environment{}), 2 + 10 * 12);
}

TEST(Expression, MayBeSingularWhereAllCoordinatesAreZero) {
  EXPECT_EQ(messages(arm_model(R"--("joint_forces": { "f": { "joint": "pin", "force": "1/z.pin + log(t)" } })--")), "");
}

TEST(Expression, LocalsAreTheOnesOfTheElement) {
  const auto spring = [](const std::string& force) {
    return arm_model(R"("springs": { "s": { "from": "ground.T", "to": "arm.B", "force": ")" + force + "\" } }");
  };
  const Model model = read(spring("length - 2*rate"));
  EXPECT_EQ(evaluate<double>(model.expressions.at(0), Environment{}), 200 - 2 * 201);
  EXPECT_NE(messages(spring("position")).find("unknown name \"position\""), std::string::npos);
}

TEST(Expression, DepthAndLengthAreNoDanger) {
  const auto force = [](const std::string& expression) {
    return arm_model(R"("joint_forces": { "f": { "joint": "pin", "force": ")" + expression + "\" } }");
  };
  const auto repeated = [](const std::string& piece, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += piece;
    return text;
  };
  constexpr int kMany = 100'000;
  EXPECT_NE(messages(force(repeated("(", kMany))).find("nested too deeply"), std::string::npos);
  EXPECT_NE(messages(force(repeated("(", kMany) + "1" + repeated(")", kMany))).find("nested too deeply"),
            std::string::npos);
  EXPECT_NE(messages(force(repeated("sin(", kMany))).find("nested too deeply"), std::string::npos);
  EXPECT_NE(messages(force(repeated("2^", kMany) + "1")).find("nested too deeply"), std::string::npos);
  EXPECT_EQ(messages(force(repeated("-", kMany) + "t")), "") << "signs do not nest";
  EXPECT_EQ(messages(force(repeated("t + ", 4999) + "t")), "") << "sums do not nest";
  EXPECT_EQ(messages(force(repeated("1 + ", kMany) + "t")), "") << "numbers fold";
  EXPECT_NE(messages(force(repeated("t + ", 5000) + "t")).find("has more than 10000"), std::string::npos);
  EXPECT_EQ(messages(force(repeated("(", 90) + "t" + repeated(")", 90))), "") << "what people write is shallow";
}

/// Position, velocity and acceleration of a motion.
Jet<double> motion(const std::string& angle, double time) {
  const Model model = read(arm_model(R"("parameters": { "k": { "value": 1, "tunable": true } }, "inputs": { "u": {} },
    "motions": { "m": { "joint": "pin", "angle": ")" +
                                     angle + "\" } }"));
  if (model.motions.empty()) return {};
  return evaluate_motion<double>(model, model.motions[0], Environment{time});
}

TEST(Jet, ClosedForms) {
  const double w = 2 * std::numbers::pi * 0.4, t = 0.7;
  const Jet<double> sine = motion("0.3*sin(2*pi*0.4*t)", t);
  EXPECT_DOUBLE_EQ(sine.value, 0.3 * std::sin(w * t));
  EXPECT_DOUBLE_EQ(sine.first, 0.3 * w * std::cos(w * t));
  EXPECT_DOUBLE_EQ(sine.second, -0.3 * w * w * std::sin(w * t));
  const Jet<double> cubic = motion("k*t^3 - u*t", t);  // k = 2, u = 20
  EXPECT_DOUBLE_EQ(cubic.value, 2 * t * t * t - 20 * t);
  EXPECT_DOUBLE_EQ(cubic.first, 6 * t * t - 20);
  EXPECT_DOUBLE_EQ(cubic.second, 12 * t);
  const Jet<double> constant = motion("k + 1", t);
  EXPECT_EQ(constant.value, 3);
  EXPECT_EQ(constant.first, 0);
  EXPECT_EQ(constant.second, 0);
}

/// A motion over inputs that name their derivatives, at t = 0.7; inputs have the values 20, 21, 22, 23.
Jet<double> motion_of_inputs(const std::string& angle) {
  const Model model = read(arm_model(R"("inputs": {
    "u": { "derivative": "u1" }, "u1": { "derivative": "u2" }, "u2": {}, "held": {} },
    "motions": { "m": { "joint": "pin", "angle": ")" +
                                     angle + "\" } }"));
  if (model.motions.empty()) return {};
  return evaluate_motion<double>(model, model.motions[0], Environment{});
}

TEST(Jet, InputsMoveByTheirDerivatives) {
  const auto expect = [](const Jet<double>& jet, double value, double first, double second) {
    EXPECT_DOUBLE_EQ(jet.value, value);
    EXPECT_DOUBLE_EQ(jet.first, first);
    EXPECT_DOUBLE_EQ(jet.second, second);
  };
  expect(motion_of_inputs("u"), 20, 21, 22);
  expect(motion_of_inputs("u1"), 21, 22, 24);  // u2 has no derivative: the reader adds one, the fifth input
  expect(motion_of_inputs("u2"), 22, 0, 0);
  expect(motion_of_inputs("held*u"), 23 * 20, 23 * 21, 23 * 22);
  expect(motion_of_inputs("u*t"), 20 * 0.7, 21 * 0.7 + 20, 22 * 0.7 + 2 * 21);
  expect(motion_of_inputs("u^2"), 400, 2 * 20 * 21, 2 * (21 * 21 + 20 * 22));
  expect(motion_of_inputs("sin(u)"), std::sin(20), 21 * std::cos(20), 22 * std::cos(20) - 21 * 21 * std::sin(20));
}

TEST(Jet, PowersOfZeroAndOfNegativeNumbersHaveDerivatives) {
  const Jet<double> square = motion("t^2", 0);
  EXPECT_EQ(square.value, 0);
  EXPECT_EQ(square.first, 0);
  EXPECT_EQ(square.second, 2);
  const Jet<double> high = motion("(t - 1)^11", 0);  // beyond the powers that become products
  EXPECT_EQ(high.value, -1);
  EXPECT_EQ(high.first, 11);
  EXPECT_EQ(high.second, -110);
}

/// Each function of the grammar against central differences of its own value.
class JetFunction : public testing::TestWithParam<std::string> {};

TEST_P(JetFunction, MatchesFiniteDifferences) {
  // Central differences with step h err by h^2/6 f''' and h^2/12 f'''' and by rounding 1e-16/h and 4e-16/h^2: at
  // h = 1e-4 both are below 1e-7 for the functions here, whose fourth derivatives stay below 50.
  constexpr double kStep = 1e-4, kFirst = 2e-7, kSecond = 5e-7, kTime = 0.7;
  const Jet<double> jet = motion(GetParam(), kTime);
  const double before = motion(GetParam(), kTime - kStep).value, after = motion(GetParam(), kTime + kStep).value;
  EXPECT_NEAR(jet.first, (after - before) / (2 * kStep), kFirst);
  EXPECT_NEAR(jet.second, (after - 2 * jet.value + before) / (kStep * kStep), kSecond);
}

INSTANTIATE_TEST_SUITE_P(Grammar, JetFunction,
                         testing::Values("sqrt(t)", "sin(2*t)", "cos(t^2)", "tan(t/2)", "asin(t/2)", "acos(t/3)",
                                         "atan(2*t)", "atan2(sin(t), t^2)", "exp(-t)", "log(1 + t)", "tanh(2*t)",
                                         "abs(0.2 - t)", "min(sin(t), 0.9*t)", "max(sin(t), 0.9*t)", "t^2.5",
                                         "(1 + t)^-2", "t^t", "pow(2, t)", "sign(t)*t^3", "step(t - 1) + t",
                                         "select(0.5 - t, t, cos(t))", "sin(t)/(1 + t^2)", "t*exp(-t)*cos(3*t)"));

}  // namespace
}  // namespace mbgen
