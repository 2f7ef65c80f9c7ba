#pragma once
// Nodes of an expression while it is parsed, constants folded, and the problems found. A part of parse_expression.

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "compiler/expressions/evaluate.hpp"
#include "compiler/expressions/expression_problem.hpp"

namespace mbgen::reading {

/// Invariant: every operand of nodes_ stands before its user, and the last node is the latest value.
class ExpressionNodes {
 protected:
  static constexpr std::size_t kMostNodes = 10'000;  ///< far beyond what people write; some passes are quadratic
  using Kind = ExpressionNode::Kind;

  int fail(std::size_t offset, std::string message, std::string hint = {}) {
    problems_.push_back({offset, std::move(message), std::move(hint)});
    return -1;
  }

  int fail_too_long() {
    return fail(at_, fmt::format("expression has more than {} numbers, names and operations", kMostNodes));
  }

  int push(const ExpressionNode& node) {
    if (nodes_.size() >= kMostNodes) return fail_too_long();
    nodes_.push_back(node);
    return static_cast<int>(nodes_.size()) - 1;
  }

  /// The value of another expression.
  int push_copy(const std::vector<ExpressionNode>& nodes) {
    return nodes_.size() + nodes.size() > kMostNodes ? fail_too_long() : append(nodes_, nodes);
  }

  int push_number(double number) {
    ExpressionNode node;
    node.number = number;
    return push(node);
  }

  int push_indexed(Kind kind, int index) {
    ExpressionNode node;
    node.kind = kind;
    node.index = index;
    return push(node);
  }

  bool is_number(int index) const { return index < 0 || nodes_[static_cast<std::size_t>(index)].kind == Kind::number; }
  double number_at(int index) const { return index < 0 ? 0 : nodes_[static_cast<std::size_t>(index)].number; }

  /// A call node, or its value when all operands are numbers. Constant operands are the last nodes of the array.
  int push_call(Function function, std::size_t offset, int first, int second = -1, int third = -1) {
    ExpressionNode node;
    node.kind = Kind::call;
    node.function = function;
    node.first = first;
    node.second = second;
    node.third = third;
    if (!is_number(first) || !is_number(second) || !is_number(third)) return push(node);
    const double a = number_at(first), b = number_at(second), c = number_at(third);
    const double value = function == Function::power ? power_by_constant(a, b) : apply(function, a, b, c);
    const bool spoiled = std::isnan(a) || std::isnan(b) || std::isnan(c);  // by a parameter that could not be read
    if (!std::isfinite(value) && !spoiled && problems_.empty()) {
      fail(offset, std::isnan(value) ? "value is not a number here" : "value is infinite here");
    }
    nodes_.resize(nodes_.size() - static_cast<std::size_t>(1 + (second >= 0) + (third >= 0)));
    return push_number(value);
  }

  /// A call of a table, or its value for numbers.
  int push_table(std::shared_ptr<const NamedTable> table, int first, int second) {
    if (is_number(first) && is_number(second)) {
      const double value = value_of(*table, number_at(first), number_at(second));
      nodes_.resize(nodes_.size() - static_cast<std::size_t>(1 + (second >= 0)));
      return push_number(value);
    }
    ExpressionNode node;
    node.kind = Kind::call;
    node.function = Function::table;
    node.first = first;
    node.second = second;
    node.table = std::move(table);
    return push(node);
  }

  std::size_t at_ = 0;  ///< byte of the text
  std::vector<ExpressionNode> nodes_;
  std::vector<ExpressionProblem> problems_;
};

}  // namespace mbgen::reading
