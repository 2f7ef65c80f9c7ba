// Inverse dynamics of random mechanisms with an actuator per free direction, on coordinates that may depend on others.

#include <map>
#include <random>

#include "compiler/compile.hpp"
#include "runtime/judges/cartesian.hpp"
#include "tests/system/property/properties.hpp"

namespace mbgen::testing {
namespace {

/// Motors on some of these coordinates, each with an input.
Model with_motors(Model model, const Topology& topology, const std::vector<int>& coordinates) {
  for (std::size_t j = 0; j < model.joints.size(); ++j)
    for (std::size_t c = 0; c < model.joints[j].freedoms.size(); ++c) {
      const CoordinateReference reference{static_cast<int>(j), static_cast<int>(c)};
      if (std::ranges::count(coordinates, tree_coordinate(topology, reference)) == 0) continue;
      Actuator motor;
      motor.name = "motor_of_" + model.joints[j].freedoms[c].name;
      motor.joint = reference;
      motor.gear = 1.5;
      motor.input = static_cast<int>(model.inputs.size());
      model.inputs.push_back({motor.name, {}, "", 0, -1, {}});
      model.actuators.push_back(motor);
    }
  return model;
}

/// Other coordinates of the same loops in place of free ones, where chance has it.
std::vector<int> exchanged(const Mechanism& m, std::vector<int> free, std::mt19937& random) {
  for (int& coordinate : free) {
    const JointGroup& group = m.topology.groups[m.topology.group_of[coordinate]];
    const int other = group.joints[random() % group.joints.size()];
    if (!m.analysis.driven[other] && std::ranges::count(free, other) == 0) coordinate = other;
  }
  return free;
}

/// The mechanism with as many motors as free directions, if it moves at all.
std::optional<Mechanism> with_motors(const Mechanism& m, unsigned seed) {
  std::mt19937 random(seed);
  const std::vector<int> free = free_coordinates(m.topology, m.analysis);
  if (free.empty()) return {};
  for (const std::vector<int>& coordinates : {exchanged(m, free, random), free}) {
    Mechanism actuated = analysed(with_motors(m.model, m.topology, coordinates));
    if (has_inverse_dynamics(actuated.model, actuated.topology, actuated.analysis)) return actuated;
  }
  return {};
}

/// Forces of the actuators by a program.
std::vector<double> forces_of(const Program& program, const GenericState& state, const std::vector<double>& tau,
                              const std::vector<double>& zdd, std::size_t actuators) {
  const std::map<SlotGroup, std::vector<double>> given{{Array::z, state.z},
                                                       {Array::zd, state.zd},
                                                       {Array::x, state.x},
                                                       {Array::tau, tau},
                                                       {Array::t, {state.t}},
                                                       {Array::zdd, zdd},
                                                       {Array::in, std::vector<double>(actuators, 0.0)},
                                                       {Array::charts, std::vector<double>(state.z.size(), 0.0)}};
  std::vector<double> inputs, force(actuators, 0.0);
  for (const Slot& slot : program.inputs) inputs.push_back(given.at(slot.group).at(slot.index));
  const std::vector<double> values = interpret(program, inputs);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (program.outputs[i].slot.group == Array::force) force[program.outputs[i].slot.index] = values[i];
  return force;
}

/// Whether accelerations under these forces are the given ones.
Complaint is_not_undone(const Mechanism& m, const GenericState& state, const std::vector<double>& tau,
                        const std::vector<double>& force, const std::vector<double>& zdd) {
  GenericSolver solver(m.model, m.topology, m.analysis);
  std::vector<double> inputs;
  for (const Input& input : m.model.inputs) inputs.push_back(input.default_value);
  for (std::size_t i = 0; i < force.size(); ++i) inputs[m.model.actuators[i].input] = force[i];
  solver.set_inputs(inputs);
  GenericDerivative found;
  if (!solver.accelerations(state, tau, found).ok()) return "generic refuses the forces of the actuators";
  return differ("the acceleration under the forces of the actuators", found.zdd, zdd, 1e-10);
}

}  // namespace

Complaint inverse_dynamics_disagrees(const RandomMechanism& random, const Mechanism& plain) {
  const std::optional<Mechanism> m = with_motors(plain, random.seed);
  if (!m) return {};
  Compilation compilation{m->model, m->topology, m->analysis};
  add_programs(compilation);
  const Program& program = compilation.emitted.programs.inverse_dynamics;
  const GenericSolver generic(m->model, m->topology, m->analysis);
  const CartesianSolver judge(m->model, m->topology, CartesianMethod::null_space, Stabilisation::projection);
  const std::vector<int> free = free_coordinates(m->topology, m->analysis);
  for (const GenericState& state : good_states(*m, 2)) {
    const std::vector<double> tau = random_tau(*m, 3), given = random_tau(*m, 5);
    GenericDerivative derivative{given, {}}, judged{given, {}};
    std::vector<double> force, expected;
    const Status status = generic.inverse_dynamics(state, tau, derivative, force);
    if (status.code == Code::actuators_singular || status.code == Code::loop_singular) continue;
    if (!status.ok()) return "generic refuses a state";
    if (!judge.inverse_dynamics(state, tau, free, judged, expected).ok()) return "the judge refuses a state";
    if (const Complaint c = differ("the judge", force, expected, kTolerance)) return c;
    if (const Complaint c = differ("accelerations of the judge", derivative.zdd, judged.zdd, kTolerance)) return c;
    if (const Complaint c =
            differ("the program", forces_of(program, state, tau, given, force.size()), force, kTolerance))
      return c;
    if (const Complaint c = is_not_undone(*m, state, tau, force, derivative.zdd)) return c;
  }
  return {};
}

}  // namespace mbgen::testing
