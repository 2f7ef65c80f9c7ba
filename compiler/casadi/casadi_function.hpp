#pragma once
// The two functions of a model, xdot = f(x, u, p, t) and y = h(x, u, p, t), with their programs in C.

#include <string>
#include <vector>

#include "compiler/casadi/c_functions.hpp"
#include "compiler/casadi/explicit_motion.hpp"
#include "compiler/casadi/sparsity.hpp"

namespace mbgen {

/// One of the two functions, f or h, with its programs in C.
struct CasadiFunction {
  std::string name, result;  ///< "four_bar_f", "xdot"
  std::vector<Slot> rows;    ///< its results, as outputs of a program
  std::vector<Slot> pivots = {}, inertias = {}, holds = {};
  int factors = 0;
  Pattern jacobian = {};
  CFunctions values = {}, factor_values = {}, directions = {}, sums = {};
};

/// The arguments of both functions.
struct CasadiArguments {
  ArgumentLayout layout;
  bool has_time = false;

  std::vector<std::string> names() const {
    return has_time ? std::vector<std::string>{"x", "u", "p", "t"} : std::vector<std::string>{"x", "u", "p"};
  }
  /// Columns of the Jacobian before each argument, and all.
  std::vector<int> first() const {
    std::vector<int> columns = {0, layout.input(0), layout.parameter(0), layout.time()};
    if (has_time) columns.push_back(layout.time() + 1);
    return columns;
  }
  int columns() const { return first().back(); }
};

/// Programs of a solver and their derivatives as functions in C.
struct CasadiFunctions {
  CasadiArguments arguments;
  CFunctions closing = {};
  int closing_residuals = 0, closing_pivots = 0;
  std::vector<CasadiFunction> list = {};  ///< f, and h where the model has outputs
};

/// solver: name of the model's solver. for_slopes: the programs as they are differentiated.
CasadiFunctions casadi_functions(const std::string& solver, const Programs& programs, const Programs& for_slopes,
                                 const SolverLayout& layout, const ArgumentLayout& arguments);

}  // namespace mbgen
