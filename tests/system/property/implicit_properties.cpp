// Implicit steps of random mechanisms: generated programs against the generic runtime.

#include <algorithm>
#include <cmath>
#include <map>

#include "compiler/compile.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/passes/passes.hpp"
#include "compiler/trace/each_program.hpp"
#include "tests/system/property/properties.hpp"
#include "workbench/engines/engine.hpp"

namespace mbgen::testing {
namespace {

constexpr double kFactor = 4e-4;  ///< s, of the equations: that of steps of 1 ms

Mechanism by_implicit_steps(const Mechanism& m) {
  Mechanism result = m;
  result.model.solver.integrator = SolverSettings::Integrator::rosenbrock;
  return result;
}

using Arrays = std::map<Array, std::vector<double>>;

/// Values of a program, by array; shares of blocks are left out.
Arrays interpreted(const Program& program, const Arrays& given) {
  std::vector<double> inputs;
  for (const Slot& slot : program.inputs)
    inputs.push_back(given.at(slot.group.array).at(static_cast<std::size_t>(slot.index)));
  const std::vector<double> values = interpret(program, inputs);
  Arrays result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Slot& slot = program.outputs[i].slot;
    std::vector<double>& array = result[slot.group.array];
    array.resize(std::max(array.size(), static_cast<std::size_t>(slot.index) + 1));
    array[static_cast<std::size_t>(slot.index)] = values[i];
  }
  return result;
}

/// A motion over 0.02 s: velocities and auxiliary states at its end; none where a step gives a notice.
std::optional<std::vector<double>> end_of(const Engine& engine, GenericState state, int steps) {
  for (int k = 0; k < steps; ++k)
    if (engine.step(state, 0.02 / steps).code != Code::ok) return {};
  std::vector<double> end = state.zd;
  end.insert(end.end(), state.x.begin(), state.x.end());
  return end;
}

double largest_gap(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace

Complaint implicit_equations_disagree(const RandomMechanism&, const Mechanism& given) {
  const Mechanism m = by_implicit_steps(given);
  const GenericSolver generic(m.model, m.topology, m.analysis);
  const ImplicitPrograms traced = trace_implicit(m.model, m.topology, m.analysis);
  const Program tangents = optimise(traced.tangents), changes = optimise(traced.changes);
  for (const GenericState& state : good_states(m, 2)) {
    GenericTangents equations;
    if (!generic.tangents(state, kFactor, equations).ok()) return "generic refuses its tangents";
    if (!equations.equations) continue;  // the frozen partition does not serve there
    const std::vector<double> zd = random_tau(m, 5);
    const GenericDerivative rates{random_tau(m, 6), std::vector<double>(state.x.size(), 0.3)};
    const GenericDerivative expected = generic.changes(equations, kFactor, zd, rates);
    const Arrays found = interpreted(tangents, {{Array::z, state.z},
                                                {Array::zd, state.zd},
                                                {Array::x, state.x},
                                                {Array::t, {state.t}},
                                                {Array::charts, std::vector<double>(m.topology.balls.size())},
                                                {Array::step, {kFactor}}});
    const auto entries = found.find(Array::tangent);
    Arrays actual =
        interpreted(changes, {{Array::zd, zd},
                              {Array::zdd, rates.zdd},
                              {Array::xd, rates.xd},
                              {Array::step, {kFactor}},
                              {Array::tangent, entries == found.end() ? std::vector<double>{} : entries->second}});
    actual[Array::zdd].resize(expected.zdd.size());
    actual[Array::xd].resize(expected.xd.size());
    if (const Complaint c = differ("the change of velocities", actual[Array::zdd], expected.zdd, kTolerance)) return c;
    if (const Complaint c = differ("the change of states", actual[Array::xd], expected.xd, kTolerance)) return c;
  }
  return {};
}

/// Where a partition is near to another, generic and generated steps project along different coordinates, and differ by
/// what the method leaves open. Both have the same limit: at half the step they differ by no more than the errors that
/// halving it tells, of order two (stiff elements that are driven), or one where forces have corners.
Complaint implicit_steps_disagree(const RandomMechanism& random, const Mechanism& given) {
  const bool is_stiff = has_corners(random) || !random.bushings.empty();
  const auto every = static_cast<unsigned>(from_environment("MBGEN_PROPERTY_COMPILED", 4));
  if (!is_stiff || random.seed % every != every / 2) return {};
  Compilation compilation{by_implicit_steps(given).model, given.topology, given.analysis};
  add_programs(compilation);
  EngineChoice choice;
  choice.integrator = SolverSettings::Integrator::rosenbrock;
  choice.use_cache = false;
  const Engine emitted = make_engine(compilation, choice);
  choice.name = "generic";
  const Engine generic = make_engine(compilation, choice);
  const double of_order = has_corners(random) ? 1 : 3;  // 2^p - 1
  for (const GenericState& state : good_states(given, 2)) {
    const auto coarse = end_of(emitted, state, 20), fine = end_of(emitted, state, 40);
    const auto its_coarse = end_of(generic, state, 20), its_fine = end_of(generic, state, 40);
    if (!coarse || !fine || !its_coarse || !its_fine) continue;
    const double errors = (largest_gap(*coarse, *fine) + largest_gap(*its_coarse, *its_fine)) / of_order;
    double size = 1;
    for (const double value : *fine) size = std::max(size, std::abs(value));
    const double gap = largest_gap(*fine, *its_fine);
    if (!(gap <= errors + kTolerance * size))
      return "implicit steps differ by " + std::to_string(gap * 1e9) + "e-9, their errors are " +
             std::to_string(errors * 1e9) + "e-9";
  }
  return {};
}

}  // namespace mbgen::testing
