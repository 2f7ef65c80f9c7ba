// Maps between motors and joints in generated solvers: redundant actuators, lines, lanes, positions where the frozen
// choice of coordinates fails.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class ActuatorMaps : public CommandLine {
 protected:
  /// Compiles a program with the sources of a solver; it ends with 0 where all holds.
  void expect_program(const std::string& program, const std::string& sources) const {
    write("main.cpp", program);
    const Outcome compiled = shell("c++ -std=c++17 -O1 -Imade main.cpp " + sources + " -o main");
    ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
    const Outcome run = shell("./main");
    EXPECT_EQ(run.exit_code, 0) << run.out;
  }
};

/// Four actuators on two directions: motors, one with a tunable gear, one between two shafts, and a cylinder.
constexpr const char* kFiveBar = R"({ "mbgen": 1, "name": "five_bar",
  "parameters": { "ratio": { "value": 3, "unit": "1", "tunable": true } },
  "bodies": {
    "ground": { "points": { "A": [0, 0, 0], "E": [0.4, 0, 0], "G": [0.2, 0, -0.1] } },
    "crank_a": { "mass": 0.8, "com": [-0.02, 0, 0.1], "inertia": [3e-3, 3e-3, 1e-4],
                 "points": { "A": [0, 0, 0], "B": [-0.05, 0, 0.2] } },
    "crank_e": { "mass": 0.7, "com": [0.42, 0, 0.1], "inertia": [3e-3, 3e-3, 1e-4],
                 "points": { "E": [0.4, 0, 0], "D": [0.45, 0, 0.2] } },
    "link_b": { "mass": 0.5, "com": [0.1, 0, 0.35], "inertia": [4e-3, 4e-3, 4e-3],
                "points": { "B": [-0.05, 0, 0.2], "C": [0.2, 0, 0.45] } },
    "link_d": { "mass": 0.6, "com": [0.3, 0, 0.35], "inertia": [4e-3, 4e-3, 4e-3],
                "points": { "D": [0.45, 0, 0.2], "C": [0.2, 0, 0.45] } } },
  "joints": {
    "at_a": { "type": "revolute", "from": "ground.A", "to": "crank_a.A", "axis": "y" },
    "at_e": { "type": "revolute", "from": "ground.E", "to": "crank_e.E", "axis": "y" },
    "at_b": { "type": "revolute", "from": "crank_a.B", "to": "link_b.B", "axis": "y" },
    "at_d": { "type": "revolute", "from": "crank_e.D", "to": "link_d.D", "axis": "y" },
    "tip": { "type": "revolute", "from": "link_b.C", "to": "link_d.C", "axis": "y" } },
  "actuators": {
    "motor_a": { "joint": "at_a", "gear": "ratio" },
    "motor_e": { "joint": "at_e", "weight": 4 },
    "ram": { "from": "ground.G", "to": "link_b.C", "gear": 2 },
    "between": { "joint": "at_b", "relative_to": "at_a", "weight": 0.5 } },
  "solver": { "closure_tolerance": 1e-14 } })";

constexpr const char* kRedundant = R"(#include <cmath>
#include <cstdio>

#include "five_bar_batch.hpp"
using namespace five_bar;

constexpr int n = kCoordinates, m = kActuators;

/// Largest difference of two arrays, over the largest of the second.
template <int N>
static double off(const double (&a)[N], const double (&b)[N]) {
  double error = 0, size = 1e-300;
  for (int i = 0; i < N; ++i) {
    error = std::fmax(error, std::abs(a[i] - b[i]));
    size = std::fmax(size, std::abs(b[i]));
  }
  return error / size;
}

#define REQUIRE(what)                         \
  if (!(what)) {                              \
    std::printf("%d: %s\n", __LINE__, #what); \
    return 1;                                 \
  }

static const Parameters parameters;
static const Inputs inputs;
static const double none[n] = {};

static int completes(State& state, Derivative& derivative) {
  for (int c = 0; c < n; ++c) state.z[c] = 0.1 * (c - 1), state.zd[c] = 1.5 - c;  // independent ones count
  REQUIRE(assemble(parameters, inputs, state).ok());
  double position[m], speed[m];
  REQUIRE(actuator_positions(parameters, inputs, state, position, speed).ok());
  // From a pose beside, all coordinates come back.
  State found{};
  REQUIRE(assemble(parameters, inputs, found).ok());
  REQUIRE(complete_joints(parameters, inputs, position, speed, found).ok());
  REQUIRE(off(found.z, state.z) < 1e-12 && off(found.zd, state.zd) < 1e-12);
  // Accelerations by differences along a motion.
  const double h = 1e-4;
  Derivative motion{};
  REQUIRE(accelerations(parameters, inputs, state, none, motion).ok());
  double there[2][m], rate[m], acceleration[m];
  for (int k = 0; k < 2; ++k) {
    State moved = state;
    const double t = k == 0 ? -h : h;
    for (int c = 0; c < n; ++c) moved.z[c] += t * (state.zd[c] + t / 2 * motion.zdd[c]);
    REQUIRE(actuator_positions(parameters, inputs, moved, there[k], rate).ok());
  }
  for (int i = 0; i < m; ++i) acceleration[i] = (there[1][i] - 2 * position[i] + there[0][i]) / (h * h);
  REQUIRE(complete_accelerations(parameters, inputs, state, acceleration, derivative).ok());
  REQUIRE(off(derivative.zdd, motion.zdd) < 1e-6);
  return 0;
}

static int maps(const State& state, const Derivative& derivative) {
  // The static map against inverse dynamics, whose least forces come by other steps.
  const double tau[n] = {3, -1, 0.5, 2};
  double position[m], speed[m];
  REQUIRE(actuator_positions(parameters, inputs, state, position, speed).ok());
  double mapped[m], difference[m];
  ActuatorForces with, without;
  REQUIRE(inverse_dynamics(parameters, inputs, state, tau, derivative, with).ok());
  REQUIRE(inverse_dynamics(parameters, inputs, state, none, derivative, without).ok());
  REQUIRE(forces_at_actuators(parameters, inputs, state, tau, mapped).ok());
  for (int i = 0; i < m; ++i) difference[i] = without.force[i] - with.force[i];
  REQUIRE(off(difference, mapped) < 1e-11);
  // The Jacobian's transpose is this map, and rates of a motion come back.
  double jacobian[n][m], transposed[m] = {}, rates[n] = {};
  REQUIRE(actuator_jacobian(parameters, inputs, state, jacobian).ok());
  for (int c = 0; c < n; ++c)
    for (int i = 0; i < m; ++i) transposed[i] += jacobian[c][i] * tau[c], rates[c] += jacobian[c][i] * speed[i];
  REQUIRE(off(transposed, mapped) < 1e-12 && off(rates, state.zd) < 1e-12);
  // The way back does the same work.
  double back[n], work = 0, expected = 0;
  REQUIRE(forces_at_independent(parameters, inputs, state, mapped, back).ok());
  for (int c = 0; c < n; ++c) work += back[c] * state.zd[c], expected += tau[c] * state.zd[c];
  REQUIRE(std::abs(work - expected) < 1e-12 * std::abs(expected));
  return 0;
}

static int meets_encoders(const State& state) {
  const double weight[m] = {1, 4, 1, 0.5};
  State found = state;
  double position[m], speed[m], rate[m];
  REQUIRE(actuator_positions(parameters, inputs, state, position, speed).ok());
  // Encoders that contradict one another: the errors over the weights do no work along any motion.
  for (int i = 0; i < m; ++i) position[i] += 1e-3 * (i % 2 == 0 ? 1 : -1);
  REQUIRE(complete_joints(parameters, inputs, position, speed, found).ok());
  double measured[m], errors[m], across[n];
  REQUIRE(actuator_positions(parameters, inputs, found, measured, rate).ok());
  for (int i = 0; i < m; ++i) errors[i] = (position[i] - measured[i]) / weight[i];
  REQUIRE(forces_at_independent(parameters, inputs, found, errors, across).ok());
  for (int c = 0; c < n; ++c) REQUIRE(std::abs(across[c]) < 1e-10);
  return 0;
}

static int has_lanes(const State& state) {
  double position[m], speed[m];
  REQUIRE(actuator_positions(parameters, inputs, state, position, speed).ok());
  // Lanes have the same bits, and one that fails leaves the others.
  const batch::Parameters parameters_of_lanes;
  const batch::Inputs inputs_of_lanes;
  batch::State lanes;
  batch::ActuatorValues positions, speeds, forces;
  for (int lane = 0; lane < batch::kLanes; ++lane) {
    batch::set_lane(lanes, lane, state);
    for (int i = 0; i < m; ++i) positions.value[i][lane] = position[i] + (lane == 1 ? NAN : 1e-3 * lane);
    for (int i = 0; i < m; ++i) speeds.value[i][lane] = speed[i], forces.value[i][lane] = i - lane;
  }
  const batch::Statuses moved = batch::complete_joints(parameters_of_lanes, inputs_of_lanes, positions, speeds, lanes);
  batch::JointForces at_joints{};
  batch::forces_at_independent(parameters_of_lanes, inputs_of_lanes, lanes, forces, at_joints);
  for (int lane = 0; lane < batch::kLanes; ++lane) {
    State one = state;
    double at[m], force[m], expected_tau[n];
    for (int i = 0; i < m; ++i) at[i] = positions.value[i][lane], force[i] = i - lane;
    const mbgen::Status status = complete_joints(parameters, inputs, at, speed, one);
    REQUIRE(status.ok() == (lane != 1) && moved.lane[lane].code == status.code);
    REQUIRE(off(batch::lane_of(lanes, lane).z, one.z) == 0 && off(batch::lane_of(lanes, lane).zd, one.zd) == 0);
    REQUIRE(forces_at_independent(parameters, inputs, one, force, expected_tau).ok());
    for (int c = 0; c < n; ++c) REQUIRE(at_joints.tau[c][lane] == expected_tau[c]);
  }
  return 0;
}

int main() {
  State state{};
  Derivative derivative{};
  return completes(state, derivative) != 0 || maps(state, derivative) != 0 || meets_encoders(state) != 0 ||
         has_lanes(state) != 0;
}
)";

TEST_F(ActuatorMaps, OfRedundantActuatorsAndOfLines) {
  write("five_bar.json", kFiveBar);
  ASSERT_EQ(mbgen("generate five_bar.json --batch 4 --out made").exit_code, 0);
  expect_program(kRedundant, "made/five_bar.cpp made/five_bar_batch.cpp");
}

constexpr const char* kPast = R"(#include <cmath>
#include <cstdio>

#include "parallel_ankle.hpp"
using namespace parallel_ankle;

int main() {
  const Parameters parameters;
  Inputs inputs;
  State state{};
  if (!assemble(parameters, inputs, state).ok()) return 2;
  const double none[kCoordinates] = {};
  double worst = 0;
  int refused = 0;
  // At 1.63 rad the foot turns back: its angles are independent, and do not determine those of the motors.
  for (int i = 0; i <= 1000; ++i) {
    const double angle = 1.8e-3 * i, position[2] = {angle, angle}, speed[2] = {3, 3}, acceleration[2] = {-20, -20};
    if (!complete_joints(parameters, inputs, position, speed, state).ok()) return 3;
    Derivative derivative{}, found{};
    if (!complete_accelerations(parameters, inputs, state, acceleration, derivative).ok()) return 4;
    ActuatorForces torque;
    if (!inverse_dynamics(parameters, inputs, state, none, derivative, torque).ok()) return 5;
    inputs.ankle_a = torque.force[0], inputs.ankle_b = torque.force[1];
    if (!accelerations(parameters, inputs, state, none, found).ok()) return 6;
    double size = 0;
    for (int c = 0; c < kCoordinates; ++c) size = std::fmax(size, std::abs(derivative.zdd[c]));
    for (int c = 0; c < kCoordinates; ++c)
      worst = std::fmax(worst, std::abs(found.zdd[c] - derivative.zdd[c]) / size);
    // The foot alone is enough where it determines the motors, and is refused where not.
    Derivative foot{};
    foot.zdd[Coordinate::ankle_ry] = derivative.zdd[Coordinate::ankle_ry];
    foot.zdd[Coordinate::ankle_rx] = derivative.zdd[Coordinate::ankle_rx];
    ActuatorForces by_foot;
    const mbgen::Status status = inverse_dynamics(parameters, inputs, state, none, foot, by_foot);
    if (status.code == mbgen::Code::loop_singular) ++refused;
    else if (!status.ok() || !(std::abs(by_foot.force[0] - torque.force[0]) < 1e-9 * (1 + std::abs(torque.force[0])))) {
      std::printf("%d: at %g %g %g\n", (int)status.code, angle, by_foot.force[0], torque.force[0]);
      return 7;
    }
  }
  std::printf("%.2g, refused %d\n", worst, refused);
  return worst < 1e-9 && refused > 0 && refused < 20 ? 0 : 8;
}
)";

TEST_F(ActuatorMaps, GoOnWhereTheIndependentCoordinatesStandStill) {
  ASSERT_EQ(mbgen("generate '" + kSource + "/models/robots/parallel_ankle.json' --out made").exit_code, 0);
  expect_program(kPast, "made/parallel_ankle.cpp");
}

}  // namespace
}  // namespace mbgen::cli_test
