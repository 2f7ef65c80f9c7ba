#pragma once
// Meanings of the names of an expression, and limits on their use.

#include <span>
#include <string_view>

#include "compiler/expressions/expression.hpp"
#include "compiler/expressions/names.hpp"
#include "compiler/expressions/parameter.hpp"

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

}  // namespace mbgen::reading
