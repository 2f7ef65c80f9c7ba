#pragma once
// Motions with error control: steps of variable size and order by CVODE of SUNDIALS, where mbgen is built with it.

#include <memory>
#include <optional>
#include <string>

#include "compiler/engines/engine.hpp"
#include "compiler/study/inputs_over_time.hpp"

namespace mbgen {

/// Method that controls its error.
struct ErrorControl {
  enum class Method {
    bdf,   ///< backward differentiation, orders 1 to 5, for stiff models
    adams  ///< Adams-Moulton, orders 1 to 12, by iteration without derivatives
  };
  Method method = Method::bdf;
  /// Of a step's error: relative, and absolute in rad, m and per second; of auxiliary states a thousandth of it in m.
  double tolerance = 1e-6;
  double end = 0;  ///< s: no step goes beyond
};

/// Facts about a motion with error control.
struct ErrorControlRecord {
  ErrorControl control;
  long steps = 0, evaluations = 0, jacobians = 0;
  long rejected = 0;    ///< steps whose error was too large
  long not_solved = 0;  ///< steps whose equations were not solved by Newton's or the fixed-point iteration
  long restarts = 0;    ///< at order one: rows of the input table, changes of charts, open loops
  int largest_order = 0;
  double shortest = 0, longest = 0;  ///< s, of the steps
  std::string failure;               ///< why a step failed, as CVODE says it; empty where none did
};

/// Name of the method on the command line.
const char* name_of(ErrorControl::Method method);

/// The control that an integrator of this name has; none for names of others. Fails: UserError for a tolerance that is
/// not between 1e-14 and 0.1, a tolerance with another integrator, and where mbgen is built without SUNDIALS.
std::optional<ErrorControl> error_control_of(const std::string& integrator, std::optional<double> tolerance);

/// An engine whose steps are those of `engine` with error control: `step` gives the motion at the end of each by
/// interpolation. All of z, zd and x are integrated; every evaluation closes the loops first. It starts anew at rows of
/// the inputs' table, where a ball changes its chart and where the loops have come open. Kinks of forces are not
/// located: the steps become short there.
/// inputs: outlive the engine. record: the facts, also of a step that fails.
Engine with_error_control(const Engine& engine, const InputsOverTime& inputs, const ErrorControl& control,
                          const std::shared_ptr<ErrorControlRecord>& record);

}  // namespace mbgen
