#pragma once
// How the inputs of a solver go on during a step.

#include <string>
#include <vector>

#include "compiler/emit/names.hpp"
#include "compiler/model/model.hpp"

namespace mbgen {

/// Pieces of the emitted files that depend on whether an input has a derivative.
struct InputText {
  std::string comment;           ///< of struct Inputs
  std::string declaration;       ///< of advance_inputs, empty without derivatives, as are the next
  std::string definition;        ///< of advance_inputs
  std::string member;            ///< of Dynamics: the time of its inputs
  std::string now;               ///< statement that advances the inputs to a state's time
  std::string start;             ///< initialiser of `member`
  std::string dynamics_comment;  ///< of struct Dynamics
  std::string name;              ///< of the inputs at a state's time
  std::string include = {};      ///< the headers that `rows` needs
  std::string rows = {};         ///< kInputRows and InputPaths, empty where no rates can be made
};
/// scalar: type of the inputs, double or float; the time of `start` is a double all the same.
InputText input_text(const Model& model, const SolverNames& names, const std::string& scalar);

/// Inputs with their derivatives, each row from an input that is no derivative to the last one; those that share a
/// derivative are left out, as no rate can follow several values.
std::vector<std::vector<int>> input_rows(const std::vector<Input>& inputs);

/// Value of an input dt seconds later, in terms of `inputs` and `dt`.
std::string input_polynomial(const Model& model, const SolverNames& names, int input,
                             const std::string& scalar = "double");

}  // namespace mbgen
