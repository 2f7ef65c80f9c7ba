#pragma once
// The value of an expression, over any scalar: double, a symbolic Expr, or a Jet of either.

#include <cmath>
#include <vector>

#include "compiler/expressions/expression.hpp"
#include "compiler/expressions/named_table.hpp"
#include "mbgen/scalar.hpp"

namespace mbgen {

/// x^exponent by multiplication. Requires: exponent >= 1. Cost: log2(exponent) squarings.
template <class T>
T integer_power(const T& x, int exponent) {
  if (exponent == 1) return x;
  const T half = integer_power(x, exponent / 2);
  return exponent % 2 == 0 ? half * half : half * half * x;
}

/// x^exponent: by multiplication for small whole exponents, which also holds for negative x; else by pow.
template <class T>
T power_by_constant(const T& x, double exponent) {
  using std::pow;
  using std::sqrt;
  constexpr double kLargestMultiplied = 8;
  if (exponent == 0) return T(1.0);
  if (exponent == 0.5) return sqrt(x);
  if (exponent == std::nearbyint(exponent) && std::abs(exponent) <= kLargestMultiplied) {
    const T power = integer_power(x, static_cast<int>(std::abs(exponent)));
    return exponent > 0 ? power : T(1.0) / power;
  }
  return pow(x, exponent);
}

/// One function of the grammar. Arguments beyond its arity are ignored.
template <class T>
T apply(Function function, const T& a, const T& b, const T& c) {
  using mbgen::abs, mbgen::min, mbgen::max, mbgen::select;
  using std::exp, std::log, std::pow, std::tanh;
  using std::floor, std::sqrt, std::sin, std::cos, std::tan, std::asin, std::acos, std::atan, std::atan2;
  switch (function) {
    case Function::add:
      return a + b;
    case Function::subtract:
      return a - b;
    case Function::multiply:
      return a * b;
    case Function::divide:
      return a / b;
    case Function::negate:
      return -a;
    case Function::power:
      return pow(a, b);
    case Function::sqrt:
      return sqrt(a);
    case Function::sin:
      return sin(a);
    case Function::cos:
      return cos(a);
    case Function::tan:
      return tan(a);
    case Function::asin:
      return asin(a);
    case Function::acos:
      return acos(a);
    case Function::atan:
      return atan(a);
    case Function::atan2:
      return atan2(a, b);
    case Function::exp:
      return exp(a);
    case Function::log:
      return log(a);
    case Function::tanh:
      return tanh(a);
    case Function::abs:
      return abs(a);
    case Function::min:
      return min(a, b);
    case Function::max:
      return max(a, b);
    case Function::sign:
      return select(a, select(-a, T(0.0), T(1.0)), T(-1.0));
    case Function::step:
      return select(a, T(1.0), T(0.0));
    case Function::select:
      return select(a, b, c);
    case Function::floor:
      return floor(a);
    case Function::table:
      break;  // needs its node
  }
  return a;
}

/// Value of a state, of a length of the mechanism or its rate, or of an output, where the environment has these;
/// read_model refuses them elsewhere.
template <class T, class Environment>
T evaluate_mechanism([[maybe_unused]] const Environment& environment, [[maybe_unused]] const ExpressionNode& node) {
  if constexpr (requires { environment.state(0); }) {
    if (node.kind == ExpressionNode::Kind::state) return environment.state(node.index);
    if (node.kind == ExpressionNode::Kind::observed) return environment.output(node.index);
    return node.kind == ExpressionNode::Kind::length ? environment.length(node.index) : environment.rate(node.index);
  } else {
    return T(0.0);
  }
}

/// Value of an expression.
/// environment: parameter(i), input(i), time(), position(CoordinateReference), velocity(CoordinateReference), local(i),
/// and where it has them state(i), length(i), rate(i), output(i), each giving T. T: + - * / and unary minus, T(double),
/// and by argument-dependent lookup sqrt sin cos tan asin acos atan atan2 exp log pow tanh floor abs min max select(x,
/// a, b). Comparisons are not used: sign and step go by select. Requires: nodes as read_model gives them (operands
/// earlier, at least one node).
template <class T, class Environment>
T evaluate(const Expression& expression, const Environment& environment) {
  std::vector<T> values;
  values.reserve(expression.nodes.size());
  const auto operand = [&](int index) -> const T& { return values[static_cast<std::size_t>(index)]; };
  const auto call = [&](const ExpressionNode& node) {
    const ExpressionNode* exponent =
        node.function == Function::power ? &expression.nodes[static_cast<std::size_t>(node.second)] : nullptr;
    if (exponent && exponent->kind == ExpressionNode::Kind::number) {
      return power_by_constant(operand(node.first), exponent->number);
    }
    const T& first = operand(node.first);
    if (node.table) return value_of(*node.table, first, node.second < 0 ? first : operand(node.second));
    return apply(node.function, first, node.second < 0 ? first : operand(node.second),
                 node.third < 0 ? first : operand(node.third));
  };
  for (const ExpressionNode& node : expression.nodes) {
    switch (node.kind) {
      case ExpressionNode::Kind::number:
        values.push_back(T(node.number));
        break;
      case ExpressionNode::Kind::parameter:
        values.push_back(environment.parameter(node.index));
        break;
      case ExpressionNode::Kind::input:
        values.push_back(environment.input(node.index));
        break;
      case ExpressionNode::Kind::time:
        values.push_back(environment.time());
        break;
      case ExpressionNode::Kind::position:
        values.push_back(environment.position(node.coordinate));
        break;
      case ExpressionNode::Kind::velocity:
        values.push_back(environment.velocity(node.coordinate));
        break;
      case ExpressionNode::Kind::local:
        values.push_back(environment.local(node.index));
        break;
      case ExpressionNode::Kind::call:
        values.push_back(call(node));
        break;
      case ExpressionNode::Kind::state:
      case ExpressionNode::Kind::length:
      case ExpressionNode::Kind::rate:
      case ExpressionNode::Kind::observed:
        values.push_back(evaluate_mechanism<T>(environment, node));
        break;
    }
  }
  return values.back();
}

/// Value of a number of the model. expressions: Model::expressions.
template <class T, class Environment>
T evaluate(const Quantity& quantity, const std::vector<Expression>& expressions, const Environment& environment) {
  if (quantity.expression < 0) return T(quantity.value);
  return evaluate<T>(expressions[static_cast<std::size_t>(quantity.expression)], environment);
}

}  // namespace mbgen
