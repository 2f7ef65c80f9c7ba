#pragma once
// Request for error control of a motion, and its record.

#include <string>
#include <vector>

namespace mbgen {

/// A method with error control.
struct ErrorControl {
  enum class Method {
    bdf,   ///< backward differentiation, orders 1 to 5, for stiff models
    adams  ///< Adams-Moulton, orders 1 to 12, by iteration without derivatives
  };
  Method method = Method::bdf;
  /// Tolerance of a step's error: relative, and absolute in rad, m and per second; of auxiliary states in parts of
  /// their magnitudes (magnitude_of).
  double tolerance = 1e-6;
  double end = 0;                 ///< s: no step goes beyond
  std::vector<double> periods{};  ///< s, of the sampled values
  bool finds_corners = true;      ///< of laws, and starts anew at them
};

/// Facts about a motion with error control.
struct ErrorControlRecord {
  ErrorControl control;
  long steps = 0, evaluations = 0, jacobians = 0;
  long rejected = 0;    ///< steps whose error was too large
  long not_solved = 0;  ///< steps whose equations were not solved by Newton's or the fixed-point iteration
  long restarts = 0;    ///< at order one: rows of the input table, sampled values, charts, open loops, corners
  long corners = 0;     ///< of laws, at which it started anew
  int largest_order = 0;
  double shortest = 0, longest = 0;  ///< s, of the steps
  std::string failure;               ///< why a step failed, as CVODE says it; empty where none did
};

/// Name of the method on the command line.
constexpr const char* name_of(ErrorControl::Method method) {
  return method == ErrorControl::Method::bdf ? "cvode" : "cvode-adams";
}

}  // namespace mbgen
