#include "tests/system/property/properties.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "compiler/choose/cheapest_recursion.hpp"
#include "compiler/compile.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/passes/passes.hpp"
#include "compiler/reader/read_model.hpp"
#include "workbench/describe/dump_model.hpp"
#include "workbench/engines/engine.hpp"

namespace mbgen::testing {

Result<Mechanism> understood(const RandomMechanism& random) {
  Result<Model> model = read_model(model_text(random), "random.json");
  if (!model) return model.problems();
  Result<Topology> topology = build_topology(*model);
  if (!topology) return topology.problems();
  Result<Analysis> analysis = analyse(*model, *topology);
  if (!analysis) return analysis.problems();
  return Mechanism{*model, *topology, *analysis};
}

std::vector<GenericState> good_states(const Mechanism& m, int wanted) {
  const GenericSolver solver(m.model, m.topology, m.analysis);
  std::vector<GenericState> states = random_states(m, wanted);
  std::erase_if(states, [&](const GenericState& state) {
    GenericDerivative derivative;
    return solver.solve_motion(state, derivative).code != Code::ok;
  });
  return states;
}

Complaint differ(const std::string& what, const std::vector<double>& actual, const std::vector<double>& expected,
                 double tolerance) {
  const double error = relative_error(actual, expected);
  if (error < tolerance) return {};
  return what + " differs by " + std::to_string(error / tolerance) + " times the tolerance";
}

int from_environment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::atoi(text);
}

namespace {

using ByName = std::map<std::string, double>;

std::vector<double> interpreted(const Program& program, const GenericState& state, const std::vector<double>& tau) {
  const std::map<SlotGroup, std::vector<double>> given{
      {Array::z, state.z}, {Array::zd, state.zd}, {Array::x, state.x}, {Array::tau, tau}, {Array::t, {state.t}}};
  std::vector<double> inputs;
  for (const Slot& slot : program.inputs) inputs.push_back(given.at(slot.group).at(slot.index));
  const std::vector<double> values = interpret(program, inputs);
  std::vector<double> zdd(state.z.size(), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (program.outputs[i].slot.group == Array::zdd) zdd[program.outputs[i].slot.index] = values[i];
  return zdd;
}

/// All passes on a mechanism that is analysed.
Compilation compiled(const Mechanism& m) {
  Compilation compilation{m.model, m.topology, m.analysis};
  add_programs(compilation);
  return compilation;
}

/// Generic, both forms of the symbolic program, the emitted one with its pairs and the four Cartesian judges say the
/// same.
Complaint engines_disagree(const RandomMechanism&, const Mechanism& m) {
  const GenericSolver generic(m.model, m.topology, m.analysis);
  const Compilation compilation = compiled(m);
  const Programs& programs = compilation.whole.programs;
  const Program matrix = optimise(trace_accelerations(m.model, m.topology, m.analysis, Form::matrix));
  for (const GenericState& state : good_states(m, 2)) {
    const std::vector<double> tau = random_tau(m, 3);
    GenericDerivative expected;
    if (!generic.accelerations(state, tau, expected).ok()) return "generic refuses a state";
    if (const Complaint c = differ("the matrix form", interpreted(matrix, state, tau), expected.zdd, kTolerance))
      return c;
    if (const Complaint c =
            differ("the recursive form", interpreted(programs.accelerations, state, tau), expected.zdd, kTolerance))
      return c;
    if (const Complaint c =
            differ("the emitted program", interpreted(compilation.emitted.programs.accelerations, state, tau),
                   expected.zdd, kTolerance))
      return c;
    for (const CartesianMethod method : {CartesianMethod::augmented, CartesianMethod::range_space,
                                         CartesianMethod::null_space, CartesianMethod::maggi}) {
      const CartesianSolver judge(m.model, m.topology, method, Stabilisation::projection);
      GenericDerivative actual;
      if (!judge.accelerations(state, tau, actual).ok()) return "a Cartesian judge refuses a state";
      if (const Complaint c =
              differ("judge " + std::to_string(static_cast<int>(method)), actual.zdd, expected.zdd, kTolerance))
        return c;
      if (const Complaint c = differ("the states of a judge", actual.xd, expected.xd, kTolerance)) return c;
    }
  }
  return {};
}

/// The emitted solver, compiled, gives the accelerations of the generic runtime and the same step.
Complaint compiled_solver_disagrees(const RandomMechanism& random, const Mechanism& m) {
  if (random.seed % static_cast<unsigned>(from_environment("MBGEN_PROPERTY_COMPILED", 4)) != 0) return {};
  const Compilation compilation = compiled(m);
  EngineChoice choice;
  choice.use_cache = false;
  const Engine emitted = make_engine(compilation, choice);
  choice.name = "generic";
  const Engine generic = make_engine(compilation, choice);
  for (const GenericState& state : good_states(m, 2)) {
    const LoadedState loaded{state, random_tau(m, 3)};
    GenericDerivative expected, actual;
    if (!generic.accelerations(loaded, expected).ok()) return "generic refuses a state";
    if (!emitted.accelerations(loaded, actual).ok()) return "the compiled solver refuses a state";
    if (const Complaint c = differ("the compiled solver", actual.zdd, expected.zdd, kTolerance)) return c;
    GenericState there = state, here = state;
    if (generic.step(there, 1e-4).code != Code::ok || emitted.step(here, 1e-4).code != Code::ok) continue;
    if (const Complaint c = differ("a step of the compiled solver", here.zd, there.zd, kTolerance)) return c;
    if (const Complaint c = differ("its step of states", here.x, there.x, kTolerance)) return c;
  }
  return {};
}

ByName by_name(const Mechanism& m, const std::vector<double>& values) {
  ByName result;
  for (int i = 0; i < m.topology.size(); ++i) result[m.topology.bodies[i].coordinate] = values[i];
  return result;
}

std::vector<double> in_order(const Mechanism& m, const ByName& values) {
  std::vector<double> result;
  for (const TreeBody& body : m.topology.bodies) result.push_back(values.at(body.coordinate));
  return result;
}

/// Auxiliary states of another description of a mechanism, which has them by the same names.
std::vector<double> states_in_order(const Mechanism& other, const Mechanism& m, const std::vector<double>& x) {
  ByName values;
  for (std::size_t i = 0; const std::string& name : auxiliary_state_names(m.model)) values[name] = x[i++];
  std::vector<double> result;
  for (const std::string& name : auxiliary_state_names(other.model)) result.push_back(values.at(name));
  return result;
}

/// The same state of another description of the mechanism has the same accelerations. turns: whether it is turned or
/// mirrored; axes along the surfaces of contacts then are not, and their bristles are straight.
Complaint accelerations_change(const Mechanism& m, const RandomMechanism& other, bool turns = false) {
  const Result<Mechanism> also = understood(other);
  if (!also) return "refused: " + to_text(also.problems());
  const GenericSolver solver(m.model, m.topology, m.analysis), same(also->model, also->topology, also->analysis);
  for (GenericState& state : good_states(m, 2)) {
    const std::vector<double> tau = random_tau(m, 3);
    if (turns && !m.model.contacts.empty())
      std::fill(state.x.begin() + first_state<SurfaceContact>(m.model, 0), state.x.begin() + slip_state_count(m.model),
                0.0);
    GenericDerivative expected, actual;
    if (!solver.accelerations(state, tau, expected).ok()) return "a state is refused";
    const GenericState there{in_order(*also, by_name(m, state.z)), in_order(*also, by_name(m, state.zd)),
                             states_in_order(*also, m, state.x), state.t};
    if (!same.accelerations(there, in_order(*also, by_name(m, tau)), actual).ok()) return "the same state is refused";
    if (const Complaint c = differ("it", actual.zdd, in_order(*also, by_name(m, expected.zdd)), kTolerance)) return c;
  }
  return {};
}

Complaint translation_shows(const RandomMechanism& random, const Mechanism& m) {
  const std::array<Point, 3> identity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  return accelerations_change(m, moved(random, identity, {3, -4, 5}));
}

Complaint rotation_shows(const RandomMechanism& random, const Mechanism& m) {
  if (!has_plain_joints(random)) return {};
  const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(-1.1), e = std::sin(-1.1);
  const std::array<Point, 3> rotation{{{c, -s, 0}, {d * s, d * c, -e}, {e * s, e * c, d}}};
  return accelerations_change(m, moved(random, rotation, {-1, 2, 0.5}), true);
}

Complaint mirror_shows(const RandomMechanism& random, const Mechanism& m) {
  return has_plain_joints(random) ? accelerations_change(m, mirrored(random), true) : Complaint{};
}

Complaint order_shows(const RandomMechanism& random, const Mechanism& m) {
  return accelerations_change(m, renumbered(random, random.seed));
}

/// A run of `steps` steps of h. Result: outputs before and after; none where the motion meets a singular position.
std::optional<std::array<GenericOutputs, 2>> run(const Compilation& compilation, GenericState state, int steps,
                                                 double h) {
  const Engine engine = make_generic_engine(compilation, EngineChoice{});
  std::array<GenericOutputs, 2> results;
  const auto look = [&](GenericOutputs& outputs) {
    const LoadedState loaded{state, std::vector<double>(state.z.size(), 0.0)};
    GenericDerivative derivative;
    return engine.accelerations(loaded, derivative).ok() && engine.outputs(loaded, derivative, outputs).ok();
  };
  if (!look(results[0])) return {};
  for (int k = 0; k < steps; ++k)
    if (engine.step(state, h).code != Code::ok) return {};
  if (!look(results[1])) return {};
  return results;
}

/// J, with that of springs and bushings, which is the last output where nothing is driven.
double energy_of(const GenericOutputs& outputs) {
  return outputs.kinetic_energy + outputs.potential_energy + outputs.y.back();
}

/// Changes over 0.02 s are the integrator's error: they fall with the fourth power of the step, once it is short enough
/// for the fourth power to rule the others. change: of two ends of a run, 0 for none.
Complaint drifts(const Mechanism& m, const std::string& what,
                 const std::function<double(const GenericOutputs&, const GenericOutputs&)>& change) {
  const Compilation compilation{m.model, m.topology, m.analysis, {}};
  for (const GenericState& state : good_states(m, 1)) {
    const auto after = [&](int steps) {
      const auto ends = run(compilation, state, steps, 0.02 / steps);
      return ends ? change((*ends)[0], (*ends)[1]) : 0.0;
    };
    double coarse = after(20), fine = after(40);
    const auto is_error_of_steps = [&] { return fine <= 1e-10 || fine <= coarse / 8; };
    for (int steps = 80; steps <= 320 && !is_error_of_steps(); steps *= 2) coarse = std::exchange(fine, after(steps));
    if (!is_error_of_steps())
      return what + " drifts by " + std::to_string(fine * 1e9) + "e-9, by twice the step " +
             std::to_string(coarse * 1e9) + "e-9";
  }
  return {};
}

/// Nothing dissipates.
Complaint energy_drifts(const RandomMechanism& random, const Mechanism& m) {
  if (is_driven(random)) return {};
  return drifts(m, "energy", [&](const GenericOutputs& start, const GenericOutputs& end) {
    return std::abs(energy_of(end) - energy_of(start)) / (1 + start.kinetic_energy);
  });
}

/// Nothing touches the ground.
Complaint momentum_drifts(const RandomMechanism& random, const Mechanism& m) {
  const bool is_free = std::ranges::all_of(random.joints, [](const RandomJoint& joint) {
    return (joint.from != kOnGround && joint.to != kOnGround) || joint.type == "free";
  });
  if (!is_free || random.gravity != Point{} || has_corners(random)) return {};
  return drifts(m, "momentum", [&](const GenericOutputs& start, const GenericOutputs& end) {
    double largest_change = 0, size = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double change = 0;
      for (std::size_t b = 0; b < random.bodies.size(); ++b) {
        change += random.bodies[b].mass * (end.y[3 * b + axis] - start.y[3 * b + axis]);
        size += random.bodies[b].mass * std::abs(start.y[3 * b + axis]);
      }
      largest_change = std::max(largest_change, std::abs(change));
    }
    return largest_change / size;
  });
}

/// The file written another way is the same model.
Complaint format_shows(const RandomMechanism& random, const Mechanism& m) {
  const std::string other = nlohmann::ordered_json::parse(model_text(random)).dump();
  const Result<Model> again = read_model(other, "random.json");
  if (!again) return "refused: " + to_text(again.problems());
  const auto content = [](const Model& model) {
    const std::string text = dump_model(model);
    return text.substr(text.find('\n'));  // the first line has the hash of the text
  };
  if (content(*again) != content(m.model)) return "it is another model";
  return {};
}

/// Two compilations write the same bytes.
Complaint bytes_change(const RandomMechanism&, const Mechanism& m) {
  if (m.topology.size() > 12) return {};
  const std::vector<EmittedFile> first = emit(compiled(m)), second = emit(compiled(m));
  for (std::size_t f = 0; f < first.size(); ++f)
    if (first[f].text != second[f].text) return first[f].path + " differs";
  return {};
}

constexpr Property kProperties[] = {
    {"engines agree", engines_disagree},
    {"the compiled solver agrees", compiled_solver_disagrees},
    {"implicit equations agree", implicit_equations_disagree},
    {"implicit steps agree", implicit_steps_disagree},
    {"outputs of judges agree", outputs_of_judges_disagree},
    {"reactions change the momentum", reactions_do_not_move_bodies},
    {"inverse dynamics agrees", inverse_dynamics_disagrees},
    {"translation changes nothing", translation_shows},
    {"rotation changes nothing", rotation_shows},
    {"a mirror changes nothing", mirror_shows},
    {"order changes nothing", order_shows},
    {"energy is conserved", energy_drifts},
    {"momentum is conserved", momentum_drifts},
    {"the file's format does not matter", format_shows},
    {"the same bytes twice", bytes_change},
};

}  // namespace

std::span<const Property> properties() { return kProperties; }

}  // namespace mbgen::testing
