#pragma once
// A model running in generated code, read by the names of its outputs.

#include <nlohmann/json.hpp>
#include <string>

#include "workbench/engines/engine.hpp"

namespace mbgen::published {

/// Data of a problem, tests/data/reference/<name>.
nlohmann::json reference(const std::string& name);

/// A number that JSON holds as a number or as text with more digits.
double number(const nlohmann::json& value);

/// A model of the project, or one in hand. Fails: std::runtime_error with the diagnostics.
Compilation compiled(const std::string& model);
Compilation compiled(Model model);
/// A model written down. Fails: std::runtime_error with the diagnostics.
Compilation compiled_text(const std::string& text);
/// Output of a command that is run in the source folder. Fails: std::runtime_error when it fails.
std::string output_of(const std::string& command);

/// Copies share the compiled solver, and each goes on from where it was copied.
class Run {
 public:
  /// Starts as the model says, Runge-Kutta steps of h seconds. Fails: std::runtime_error with the diagnostics.
  Run(const std::string& model, double h);
  Run(Compilation compilation, double h);

  /// Takes the model to its reference configuration, at rest.
  void take_reference();
  /// Another length of steps from now on. Requires: the time is a whole number of them.
  void set_step(double h);
  /// Steps on to a time that is a whole number of steps. Fails: std::runtime_error with the status and the time.
  void go_to(double t);
  double output(const std::string& name) const;
  /// Kinetic energy and that of gravity, J.
  double energy() const;

 private:
  GenericOutputs outputs() const;

  Compilation compilation_;
  Engine engine_;
  LoadedState state_;
  double h_;
};

}  // namespace mbgen::published
