#pragma once
// Expressions of the model format: a small arithmetic grammar without side effects, held in postfix order.
//
//   sum     = product { ("+" | "-") product }          unary  = { "-" | "+" } power
//   product = unary { ("*" | "/") unary }              power  = atom [ "^" unary ]       so -x^2 = -(x^2), 2^-1 = 0.5
//   atom    = number | "pi" | "t" | parameter | input | local | "z." name | "zd." name
//           | state | "length." spring | "rate." spring | "out." output | function "(" sum { "," sum } ")" | "(" sum
//           ")" | "table(" quoted name { "," sum } ")"
// The functions stand in the table of named_functions.cpp.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "compiler/expressions/table.hpp"

namespace mbgen {

/// A relative coordinate of the model: a joint and one of its freedoms. Resolved to a tree coordinate by Topology.
struct CoordinateReference {
  int joint = -1;     ///< index into Model::joints
  int component = 0;  ///< index into Joint::freedoms
  bool operator==(const CoordinateReference&) const = default;
};

enum class Function : std::uint8_t {
  add,
  subtract,
  multiply,
  divide,
  negate,
  power,
  sqrt,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2,
  exp,
  log,
  tanh,
  abs,
  min,
  max,
  sign,
  step,
  select,
  floor,
  table
};

/// One postfix node. `first`, `second`, `third` are indices of earlier nodes.
struct ExpressionNode {
  enum class Kind : std::uint8_t {
    number,
    parameter,
    input,
    time,
    position,
    velocity,
    local,
    call,
    state,
    length,
    rate,
    observed
  };
  Kind kind = Kind::number;
  Function function = Function::add;  ///< for Kind::call
  double number = 0;                  ///< for Kind::number
  /// parameter, input or local; of Model::states, then Model::sampled; of elements with a length, then rods; of
  /// Model::observed
  int index = -1;
  CoordinateReference coordinate;  ///< for Kind::position and Kind::velocity
  int first = -1, second = -1, third = -1;
  std::shared_ptr<const NamedTable> table = nullptr;  ///< of Function::table
};

/// Appends nodes with their operands. Result: the place of the last one.
inline int append(std::vector<ExpressionNode>& to, const std::vector<ExpressionNode>& nodes) {
  const int first = static_cast<int>(to.size());
  for (ExpressionNode node : nodes) {
    for (int* operand : {&node.first, &node.second, &node.third}) *operand += *operand < 0 ? 0 : first;
    to.push_back(node);
  }
  return static_cast<int>(to.size()) - 1;
}

/// The last node is the value. `text` is the user's text.
struct Expression {
  std::string text;
  std::vector<ExpressionNode> nodes;
};

/// A number of the model: a constant, or an expression that depends on more than untunable parameters.
struct Quantity {
  double value = 0;     ///< the constant, or the value at default parameters and inputs, t = 0, all coordinates zero
  int expression = -1;  ///< index into Model::expressions, -1 for a constant
  Quantity() = default;
  Quantity(double constant) : value(constant) {}
};

}  // namespace mbgen
