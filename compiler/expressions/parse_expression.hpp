#pragma once
// Text of an expression -> postfix nodes, constants folded.

#include <string>
#include <string_view>
#include <vector>

#include "compiler/expressions/expression_problem.hpp"
#include "compiler/expressions/expression_scope.hpp"

namespace mbgen::reading {

/// A use of such a function.
struct ReductionCall {
  int reduction = -1;   ///< index into ExpressionScope::reductions
  double constant = 0;  ///< where it takes one
  Expression operand;
};

/// A use of the value of an output.
struct OutputUse {
  std::size_t offset = 0;  ///< byte of the text
  int output = -1;         ///< as in Names::outputs
};

/// Requires problems to be empty for the expression to be used.
struct ParsedExpression {
  Expression expression;
  std::vector<ExpressionProblem> problems;
  /// Inner ones first; the value of the k-th is the local variable ExpressionScope::locals.size() + k.
  std::vector<ReductionCall> reductions = {};
  std::vector<OutputUse> outputs = {};
};

/// Parses an expression. Untunable parameters become numbers, parameters that follow from tunable ones their
/// expressions; operations on numbers are carried out. Fails: at the first error of grammar; before it, with every
/// unknown or forbidden name and every value that is not finite.
ParsedExpression parse_expression(std::string_view text, const ExpressionScope& scope);

}  // namespace mbgen::reading
