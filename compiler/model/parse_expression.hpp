#pragma once
// Text of an expression -> postfix nodes, constants folded.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/model/expression.hpp"
#include "compiler/model/model.hpp"
#include "compiler/model/names.hpp"

namespace mbgen::reading {

/// Names that a number of the model may depend on; each value allows those of the values before it, `motion` and up
/// also inputs. `positions`: parameters and positions of coordinates alone.
enum class Depends { nothing, parameters, positions, motion, all };

/// A function of the course of a value over time, for expressions over a motion: max(x), or with a constant in front,
/// at(1.5, x).
struct ReductionName {
  std::string_view name;
  int arity = 1;  ///< 2 with a constant
};

/// A use of such a function.
struct ReductionCall {
  int reduction = -1;   ///< index into ExpressionScope::reductions
  double constant = 0;  ///< where it takes one
  Expression operand;
};

/// Meaning of the names of an expression, and the names that it may use.
struct ExpressionScope {
  const Names& names;
  const Visibility& visible;  ///< from where names are looked up
  std::span<const Parameter> parameters;
  std::span<const Expression> expressions;  ///< expressions of the parameters among them
  Depends depends = Depends::all;
  std::span<const std::string_view> locals = {};
  bool suggest = true;           ///< propose the name that was probably meant
  bool refuse_reversed = false;  ///< coordinates of Names::reversed mean something else here
  bool folds_tunable = false;    ///< tunable parameters become numbers, too
  bool at_start = false;         ///< parameters that act at the start may be used
  std::span<const ReductionName> reductions = {};
};

struct ExpressionProblem {
  std::size_t offset = 0;  ///< byte of the text
  std::string message;
  std::string hint;
};

/// Requires problems to be empty for the expression to be used.
struct ParsedExpression {
  Expression expression;
  std::vector<ExpressionProblem> problems;
  /// Inner ones first; the value of the k-th is the local variable ExpressionScope::locals.size() + k.
  std::vector<ReductionCall> reductions = {};
};

/// Parses an expression. Untunable parameters become numbers, parameters that follow from tunable ones their
/// expressions; operations on numbers are carried out. Fails: at the first error of grammar; before it, with every
/// unknown or forbidden name and every value that is not finite.
ParsedExpression parse_expression(std::string_view text, const ExpressionScope& scope);

}  // namespace mbgen::reading
