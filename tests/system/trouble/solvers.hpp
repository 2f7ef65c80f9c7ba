#pragma once
// One model on every engine, behind the same functions: what the tests of numerical trouble call.

#include <functional>
#include <string>
#include <vector>

#include "compiler/compile.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen::trouble {

/// Arguments of every function of a solver, and what it gives back.
struct Case {
  std::vector<double> parameters, inputs;
  GenericState state;
  std::vector<double> tau;
  GenericDerivative derivative;
  double h = 1e-3;  ///< s
};

/// A solver of the model. A function changes what it says in the case, and nothing else.
struct Solver {
  using Call = std::function<Status(Case&)>;
  std::string name;
  Call accelerations;  ///< derivative
  Call project;        ///< state
  Call rk4;            ///< state
  Call abm4;           ///< state; the history of the solver goes on
  std::function<double(const Case&)> largest_residual;
  std::function<std::string(Status)> describe;  ///< "input not a number: torque"
};

/// The un-specialised runtime. The compilation must outlive it.
Solver generic_solver(const Compilation& compilation);

/// The emitted solver by a compiler, with its flags and all warnings as errors; without functions when it is not
/// installed. Fails: std::runtime_error when the compiler rejects the code.
Solver generated_solver(const Compilation& compilation, const std::string& compiler);

}  // namespace mbgen::trouble
