// Trees against MuJoCo as well: composite bodies and a sparse factorisation. Mechanism and gravity only; closed loops
// it treats as springs, which is no check at all.

#include <cstdio>

#include "compiler/reader/read_model.hpp"
#include "tests/system/oracle/mujoco_mechanism.hpp"
#include "tests/system/oracle/oracle_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// Models without loops.
std::vector<std::string> trees() {
  std::vector<std::string> paths;
  for (const std::string& path : all_models()) {
    const Result<Model> model = read_model_file(source_path(path));
    const Result<Topology> topology = model ? build_topology(*model) : Result<Topology>(Diagnostics{});
    if (topology && topology->loops.empty()) paths.push_back(path);
  }
  return paths;
}

/// A motor on every coordinate of the joints.
void add_motors(Model& model) {
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    for (std::size_t f = 0; f < model.joints[j].freedoms.size(); ++f) {
      Actuator motor;
      motor.name = "motor_of_" + model.joints[j].freedoms[f].name;
      motor.joint = CoordinateReference{static_cast<int>(j), static_cast<int>(f)};
      motor.input = static_cast<int>(model.inputs.size());
      model.inputs.push_back({motor.name, {}, "", 0, -1, {}});
      model.actuators.push_back(motor);
    }
  }
}

/// The mechanism of a model with a motor on every coordinate. MuJoCo refuses point masses and thin bars, so every body
/// gets 1e-3 kg m^2 more.
Mechanism bare(const std::string& path) {
  const Model whole = load_without_tyres(path).model;
  Model model;
  model.name = whole.name;
  model.gravity = whole.gravity;
  model.parameters = whole.parameters;
  model.inputs = whole.inputs;
  model.expressions = whole.expressions;
  model.ground = whole.ground;
  model.bodies = whole.bodies;
  model.joints = whole.joints;
  for (Body& body : model.bodies)
    for (int k = 0; k < 3; ++k) body.inertia[k].value += 1e-3;
  add_motors(model);
  return analysed_model(std::move(model));
}

class TreeInMujoco : public ::testing::TestWithParam<std::string> {};

TEST_P(TreeInMujoco, HasTheSameAccelerations) {
  if (!foreign::MujocoMechanism::is_available()) GTEST_SKIP() << "MuJoCo (libmujoco-dev) is not installed";
  const Mechanism m = bare(GetParam());
  const GenericSolver solver(m.model, m.topology, m.analysis);
  foreign::MujocoMechanism mujoco(foreign::reference_mechanism(m.model, m.topology));
  const std::vector<double> tau = random_tau(m, 3);
  double error = 0;
  for (const GenericState& state : random_states(m, 4)) {
    GenericDerivative derivative;
    ASSERT_TRUE(solver.accelerations(state, tau, derivative).ok());
    error = std::max(error, relative_error(mujoco.accelerations(foreign_state(state, tau)), derivative.zdd));
  }
  std::printf("%s: accelerations as in MuJoCo, %.1e relative\n", m.model.name.c_str(), error);
  EXPECT_LT(error, 1e-9);
}

TEST_P(TreeInMujoco, NeedsTheSameForces) {
  if (!foreign::MujocoMechanism::is_available()) GTEST_SKIP() << "MuJoCo (libmujoco-dev) is not installed";
  const Mechanism m = bare(GetParam());
  const GenericSolver solver(m.model, m.topology, m.analysis);
  foreign::MujocoMechanism mujoco(foreign::reference_mechanism(m.model, m.topology));
  const std::vector<double> none(m.topology.bodies.size(), 0.0), wanted = random_tau(m, 5);
  double error = 0;
  for (const GenericState& state : random_states(m, 4)) {
    GenericDerivative derivative{wanted, {}};
    std::vector<double> force, expected;
    ASSERT_TRUE(solver.inverse_dynamics(state, none, derivative, force).ok());
    const std::vector<double> of_coordinates = mujoco.inverse_forces(foreign_state(state, none), wanted);
    for (const Actuator& motor : m.model.actuators)
      expected.push_back(of_coordinates[static_cast<std::size_t>(tree_coordinate(m.topology, *motor.joint))]);
    error = std::max(error, relative_error(force, expected));
  }
  std::printf("%s: forces as in MuJoCo, %.1e relative\n", m.model.name.c_str(), error);
  EXPECT_LT(error, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Models, TreeInMujoco, ::testing::ValuesIn(trees()), test_name);

}  // namespace
}  // namespace mbgen
