#pragma once
// Expressions of the model that the reader puts together: written as equations, kept as nodes.

#include <cstddef>
#include <utility>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen::reading {

/// Nodes of an expression in postfix order, the last one its value.
struct Formula {
  std::vector<ExpressionNode> nodes;

  Formula(double number) {
    ExpressionNode node;
    node.number = number;
    nodes.push_back(node);
  }
  explicit Formula(std::vector<ExpressionNode> of) : nodes(std::move(of)) {}
};

/// A state or sampled value by its place in Names::values.
inline Formula state_formula(int place) {
  ExpressionNode node;
  node.kind = ExpressionNode::Kind::state;
  node.index = place;
  return Formula(std::vector{node});
}

inline Formula time_formula() {
  ExpressionNode node;
  node.kind = ExpressionNode::Kind::time;
  return Formula(std::vector{node});
}

inline Formula formula_of(const Model& model, const Quantity& quantity) {
  if (quantity.expression < 0) return Formula(quantity.value);
  return Formula(model.expressions[static_cast<std::size_t>(quantity.expression)].nodes);
}

/// A function of up to three operands.
template <class... Operands>
Formula call(Function function, const Operands&... operands) {
  std::vector<ExpressionNode> nodes;
  ExpressionNode node;
  node.kind = ExpressionNode::Kind::call;
  node.function = function;
  int* place[] = {&node.first, &node.second, &node.third};
  std::size_t next = 0;
  ((*place[next++] = append(nodes, operands.nodes)), ...);
  nodes.push_back(node);
  return Formula(std::move(nodes));
}

inline Formula operator+(const Formula& a, const Formula& b) { return call(Function::add, a, b); }
inline Formula operator-(const Formula& a, const Formula& b) { return call(Function::subtract, a, b); }
inline Formula operator*(const Formula& a, const Formula& b) { return call(Function::multiply, a, b); }
inline Formula operator/(const Formula& a, const Formula& b) { return call(Function::divide, a, b); }
inline Formula operator-(const Formula& a) { return call(Function::negate, a); }
inline Formula floor(const Formula& x) { return call(Function::floor, x); }
inline Formula sqrt(const Formula& x) { return call(Function::sqrt, x); }
inline Formula exp(const Formula& x) { return call(Function::exp, x); }
inline Formula log(const Formula& x) { return call(Function::log, x); }
inline Formula cos(const Formula& x) { return call(Function::cos, x); }
/// a where x is at least 0, else b.
inline Formula select(const Formula& x, const Formula& a, const Formula& b) { return call(Function::select, x, a, b); }
inline Formula min(const Formula& a, const Formula& b) { return call(Function::min, a, b); }
inline Formula max(const Formula& a, const Formula& b) { return call(Function::max, a, b); }

}  // namespace mbgen::reading
