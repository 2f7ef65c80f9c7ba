#include "solvers.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "tests/support/compiled_solver.hpp"
#include "tests/support/dynamics.hpp"
#include "tests/support/table_state.hpp"
#include "workbench/engines/engine.hpp"

/// Calls of the heap by this program so far, see tests/support/heap.cpp; null under sanitizers.
extern "C" [[gnu::weak]] long heap_calls();

namespace mbgen::trouble {
namespace {

/// The generic runtime with what its multistep method remembers.
struct GenericRun {
  GenericSolver solver;
  AbmHistory<testing::Dynamics> history{};
};

/// Status of a function of an emitted solver. Fails: std::logic_error when it has touched the heap.
template <class Call>
Status watched(const Call& call) {
  if (heap_calls == nullptr) return call();
  const long before = heap_calls();
  const Status status = call();
  if (heap_calls() != before) throw std::logic_error("an emitted function touches the heap");
  return status;
}

}  // namespace

Solver generic_solver(const Compilation& compilation) {
  const auto run = std::make_shared<GenericRun>(
      GenericRun{GenericSolver(compilation.model, compilation.topology, compilation.analysis)});
  const auto given = [run](const Case& at) -> GenericRun& {
    run->solver.set_inputs(at.inputs);
    run->solver.set_parameters(at.parameters);
    return *run;
  };
  Solver solver;
  solver.name = "generic";
  solver.accelerations = [given](Case& at) { return given(at).solver.accelerations(at.state, at.tau, at.derivative); };
  solver.project = [given](Case& at) { return given(at).solver.project(at.state); };
  solver.rk4 = [given](Case& at) { return step_rk4(testing::Dynamics{given(at).solver}, at.state, at.h); };
  solver.abm4 = [given](Case& at) {
    GenericRun& run = given(at);
    return step_abm4(testing::Dynamics{run.solver}, at.state, run.history, at.h);
  };
  solver.largest_residual = [given](const Case& at) {
    return largest_absolute(given(at).solver.position_residuals(at.state));
  };
  solver.describe = [&compilation](Status status) { return describe(compilation, status); };
  return solver;
}

Solver generated_solver(const Compilation& compilation, const std::string& command) {
  const test::Compiler compiler{command.c_str(), command == "clang++" ? CompilerFamily::clang : CompilerFamily::gnu};
  Solver solver;
  solver.name = command;
  if (!test::is_installed(compiler)) return solver;
  std::vector<EmittedFile> files = emit(compilation, {.runtime_headers = false});
  files.push_back(emit_driver(compilation.model));
  const auto loaded = std::make_shared<test::Loaded>(files, solver_name(compilation.model), compiler);
  if (loaded->table() == nullptr) throw std::runtime_error(loaded->compilation().text);
  const SolverTable& table = *loaded->table();

  const auto history = std::make_shared<std::vector<double>>(table.history_bytes / sizeof(double) + 1);
  table.start_abm4(history->data());
  // The library stays for as long as a function of it can be called.
  const auto moving = [loaded, &table](Case& at, auto call) {
    std::vector<double> state = testing::flat(table, at.state);
    const Status status = watched([&] { return call(state.data()); });
    at.state = testing::unflat(table, state);
    return status;
  };
  solver.accelerations = [loaded, &table](Case& at) {
    std::vector<double> rates = at.derivative.zdd;
    rates.insert(rates.end(), at.derivative.xd.begin(), at.derivative.xd.end());
    const std::vector<double> state = testing::flat(table, at.state);
    const Status status = watched([&] {
      return table.accelerations(at.parameters.data(), at.inputs.data(), state.data(), at.tau.data(), rates.data());
    });
    at.derivative.zdd.assign(rates.begin(), rates.begin() + table.coordinates);
    at.derivative.xd.assign(rates.begin() + table.coordinates, rates.end());
    return status;
  };
  solver.project = [moving, &table](Case& at) {
    return moving(at, [&](double* s) { return table.project(at.parameters.data(), at.inputs.data(), s); });
  };
  solver.rk4 = [moving, &table](Case& at) {
    return moving(at, [&](double* s) { return table.step_rk4(at.parameters.data(), at.inputs.data(), s, at.h); });
  };
  solver.abm4 = [moving, history, &table](Case& at) {
    return moving(at, [&](double* s) {
      return table.step_abm4(at.parameters.data(), at.inputs.data(), s, history->data(), at.h);
    });
  };
  solver.largest_residual = [loaded, &table](const Case& at) {
    std::vector<double> position(static_cast<std::size_t>(table.closure_equations)), velocity = position;
    const std::vector<double> state = testing::flat(table, at.state);
    table.residuals(at.parameters.data(), at.inputs.data(), state.data(), position.data(), velocity.data());
    return largest_absolute(position);
  };
  solver.describe = [loaded, &table](Status status) {
    const std::string name = table.describe(status);
    return text(status.code) + (name.empty() ? "" : ": " + name);
  };
  return solver;
}

}  // namespace mbgen::trouble
