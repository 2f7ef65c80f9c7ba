#pragma once
// The inputs of a run: constant, continued by their derivatives, or from a table over time.

#include <string>
#include <vector>

#include "compiler/model/model.hpp"
#include "workbench/motion/course.hpp"
#include "workbench/motion/input_table.hpp"
#include "workbench/motion/law_instants.hpp"

namespace mbgen {

/// Curve of a column between its rows.
enum class Interpolation {
  pchip,   ///< cubic that keeps the shape: never outside the two rows beside it
  linear,  ///< straight
  spline,  ///< cubic spline: smoother, and may leave the rows
  hold     ///< as in the last row
};

/// Values of all inputs of a model, in its order, over time.
struct InputsOverTime {
  std::vector<Course> courses;
  std::vector<bool> advances;              ///< per input: has a derivative, so that a step advances it by itself
  bool is_constant = true;                 ///< whether all of them stand still
  std::vector<double> rows = {};           ///< s, of the table, where derivatives of its inputs may jump
  std::vector<double> jumps = {};          ///< s, of its rows, where an input itself jumps
  LawInstants laws = {};                   ///< of the model, in which time stands beside the inputs
  std::vector<std::string> warnings = {};  ///< complete lines for standard error

  /// Whether a row of the table lies after `start`, and not after `end`; s.
  bool has_row(double start, double end) const;
  /// At an instant.
  std::vector<double> at(double t) const;
  /// Inputs of a step of h seconds from t. An input that advances has its value at t. Other inputs, and the last
  /// derivative of a chain, are constant during the step and have their value in the middle: the step is then of second
  /// order in h.
  std::vector<double> of_step(double t, double h) const;
};

/// The inputs that a user requests. assignments: name=value, for inputs that keep their value, or continue by their
/// derivatives; the others have their defaults. table: path of a CSV file, "" for none. Its header is `t` and names of
/// inputs, with optional units in brackets; its rows have increasing t (s); before and after the rows values are
/// constant. A derivative without a column is the derivative of its input's interpolation; a column for it joins the
/// interpolation of pchip and spline (Hermite polynomials), so that all orders are consistent. Fails: UserError with
/// file and line; columns of rates that contradict the values, see check_rates.
InputsOverTime inputs_over_time(const Model& model, const std::vector<std::string>& assignments,
                                const std::string& table, Interpolation interpolation);

/// The same of a table that was read.
InputsOverTime inputs_over_time(const Model& model, const std::vector<std::string>& assignments,
                                const InputTable& table, Interpolation interpolation);

}  // namespace mbgen
