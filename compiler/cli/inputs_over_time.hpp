#pragma once
// The inputs of a run: constant, continued by their derivatives, or from a table over time.

#include <string>
#include <vector>

#include "compiler/cli/course.hpp"
#include "compiler/model/model.hpp"

namespace mbgen::cli {

/// Values of all inputs of a model, in its order, over time.
struct InputsOverTime {
  std::vector<Course> courses;
  std::vector<bool> advances;  ///< per input: has a derivative, so that a step advances it by itself
  bool is_constant = true;     ///< whether all of them stand still

  /// At an instant.
  std::vector<double> at(double t) const;
  /// What a step of h seconds from t is given. An input that advances has its value at t; any other stands still during
  /// the step, also the last derivative of a row, and has its value in the middle: the step is then right to the second
  /// order in h.
  std::vector<double> of_step(double t, double h) const;
};

/// The inputs that a user asks for.
/// assignments: name=value, of inputs that keep their value, or continue with their derivatives; the rest has its
/// default. table: path of a CSV file, "" for none. Its header is `t` and names of inputs, with units in brackets where
/// wanted, its rows have increasing t (s); values between rows are on straight lines, before and after they are held.
/// Where an input of the table has a derivative that is not in the table, a cubic spline gives both.
/// Fails: UserError with file and line.
InputsOverTime inputs_over_time(const Model& model, const std::vector<std::string>& assignments,
                                const std::string& table);

}  // namespace mbgen::cli
