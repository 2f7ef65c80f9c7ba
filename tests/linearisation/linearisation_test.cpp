// Linear systems: by hand, against differences of the generic runtime, and published eigenvalues.

#include "compiler/linearisation/linearisation.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "compiler/compile.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/support/mechanism_support.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A model, a solver of it, and a state with closed loops.
struct Linearised {
  Compilation compilation;
  GenericState state;
  std::vector<double> inputs;
  LinearSystem system;
};

GenericSolver solver_of(const Compilation& c, const std::vector<double>& inputs) {
  GenericSolver solver(c.model, c.topology, c.analysis);
  solver.set_inputs(inputs);
  return solver;
}

Compilation compiled(Result<Model> model) {
  if (!model) throw std::runtime_error(to_text(model.problems()));
  Result<Compilation> compilation = compile(std::move(*model));
  if (!compilation) throw std::runtime_error(to_text(compilation.problems()));
  return std::move(*compilation);
}

/// Linearises at positions and velocities of the independent coordinates (all of them the same numbers), or at the
/// equilibrium near the reference.
Linearised linearised(Compilation compilation, double position, double velocity, bool at_equilibrium = false) {
  Linearised result{std::move(compilation), {}, {}, {}};
  const Compilation& c = result.compilation;
  for (const Input& input : c.model.inputs) result.inputs.push_back(input.default_value);
  result.state.z.assign(static_cast<std::size_t>(c.topology.size()), 0.0);
  result.state.zd = result.state.z;
  result.state.x = initial_auxiliary_states(c.model);
  for (const int i : free_coordinates(c.topology, c.analysis)) {
    result.state.z[static_cast<std::size_t>(i)] = position;
    result.state.zd[static_cast<std::size_t>(i)] = velocity;
  }
  GenericSolver solver = solver_of(c, result.inputs);
  EXPECT_TRUE((at_equilibrium ? solver.equilibrium(result.state) : solver.project(result.state)).ok());
  const GenericState& s = result.state;
  Result<LinearSystem> system = linearise(c, {s.z, s.zd, s.x, s.t, result.inputs});
  if (!system) throw std::runtime_error(to_text(system.problems()));
  result.system = std::move(*system);
  return result;
}

std::vector<std::complex<double>> eigenvalues(const LinearSystem& system) {
  std::vector<std::complex<double>> values;
  for (const Mode& mode : modes(system)) values.push_back(mode.eigenvalue);
  return values;
}

// A mass m on a spring and a damper: roots of m s^2 + d s + c.
TEST(Linearisation, MassOnSpringAndDamper) {
  const Linearised l = linearised(compiled(read_model(R"({ "mbgen": 1,
    "inputs": { "force": { "unit": "N", "default": 0 } },
    "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
      "mass": { "mass": 2, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "mass.A", "axis": "z" } },
    "joint_springs": { "spring": { "joint": "slide", "stiffness": 50, "damping": 4 } },
    "forces": { "push": { "at": "mass.A", "force": [0, 0, "force"] } },
    "outputs": { "height": { "unit": "m", "point": "mass.A", "quantity": "position", "axis": "z" } } })",
                                                      "test.json")),
                                  0, 0, true);
  Eigen::MatrixXd a(2, 2), b(2, 1);
  a << 0, 1, -25, -2;
  b << 0, 0.5;
  EXPECT_LT((l.system.A - a).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((l.system.B - b).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((l.system.C - Eigen::RowVector2d(1, 0)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(l.system.D(0, 0), 0);
  const std::vector<Mode> list = modes(l.system);
  ASSERT_EQ(list.size(), 1u);
  EXPECT_NEAR(list[0].eigenvalue.real(), -1, 1e-12);
  EXPECT_NEAR(list[0].eigenvalue.imag(), std::sqrt(24.0), 1e-12);
  EXPECT_NEAR(list[0].undamped_frequency(), 5 / (2 * std::numbers::pi), 1e-12);
  EXPECT_NEAR(list[0].damping_ratio(), 0.2, 1e-12);
}

// Two equal bobs on massless bars of length l: w^2 = (2 -+ sqrt 2) g / l, shapes 1 : -+ sqrt 2 of the absolute angles.
TEST(Linearisation, DoublePendulumHangs) {
  const Linearised l = linearised(compiled(read_model(R"({ "mbgen": 1, "gravity": [0, 0, -9.81],
    "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
      "upper": { "mass": 1.5, "com": [0, 0, -0.7], "inertia": [0, 0, 0], "points": { "A": [0, 0, 0], "B": [0, 0, -0.7] } },
      "lower": { "mass": 1.5, "com": [0, 0, -1.4], "inertia": [0, 0, 0], "points": { "B": [0, 0, -0.7] } } },
    "joints": { "first": { "type": "revolute", "from": "ground.A", "to": "upper.A", "axis": "y" },
                "second": { "type": "revolute", "from": "upper.B", "to": "lower.B", "axis": "y" } } })",
                                                      "test.json")),
                                  0, 0, true);
  const std::vector<Mode> list = modes(l.system);
  ASSERT_EQ(list.size(), 2u);
  const double g_over_l = 9.81 / 0.7;
  EXPECT_NEAR(list[0].eigenvalue.imag(), std::sqrt((2 + std::sqrt(2.0)) * g_over_l), 1e-10);
  EXPECT_NEAR(list[1].eigenvalue.imag(), std::sqrt((2 - std::sqrt(2.0)) * g_over_l), 1e-10);
  for (const int i : {0, 1}) {
    const std::complex<double> absolute = 1.0 + list[i].coordinates[1] / list[i].coordinates[0];
    EXPECT_NEAR(absolute.real(), i == 0 ? -std::sqrt(2.0) : std::sqrt(2.0), 1e-10);
    EXPECT_NEAR(absolute.imag(), 0, 1e-10);
  }
}

TEST(Linearisation, BobOnTopFalls) {
  const Linearised l = linearised(compiled(read_model(R"({ "mbgen": 1, "gravity": [0, 0, -9.81],
    "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
      "bob": { "mass": 1, "com": [0, 0, 1], "inertia": [0, 0, 0], "points": { "A": [0, 0, 0] } } },
    "joints": { "pin": { "type": "revolute", "from": "ground.A", "to": "bob.A", "axis": "y" } } })",
                                                      "test.json")),
                                  0, 0);
  const auto values = eigenvalues(l.system);
  ASSERT_EQ(values.size(), 2u);
  EXPECT_NEAR(values[0].real(), -std::sqrt(9.81), 1e-12);
  EXPECT_NEAR(values[1].real(), std::sqrt(9.81), 1e-12);
}

/// Results of the generic runtime at a state beside the point.
struct Beside {
  Eigen::VectorXd deviations;  ///< of the states and the inputs, once the loops are closed
  Eigen::VectorXd results;     ///< rates of the states and outputs
};

/// The values of the states of the linear system among those of a whole state or its rates.
Eigen::VectorXd picked(const std::vector<LinearState>& states, const std::vector<double>& positions,
                       const std::vector<double>& velocities, const std::vector<double>& auxiliary) {
  const std::vector<double>* const groups[] = {&positions, &velocities, &auxiliary};
  Eigen::VectorXd values(static_cast<Eigen::Index>(states.size()));
  for (std::size_t i = 0; i < states.size(); ++i) {
    values[static_cast<Eigen::Index>(i)] =
        (*groups[static_cast<int>(states[i].kind)])[static_cast<std::size_t>(states[i].index)];
  }
  return values;
}

/// Moves along a state, the dependent coordinates with it, or along an input. The generic runtime closes the loops by
/// other independent coordinates where it likes: what the states are then is measured.
Beside beside(const Linearised& l, Eigen::Index column, double size) {
  GenericState state = l.state;
  std::vector<double> inputs = l.inputs;
  const std::vector<LinearState>& states = l.system.states;
  const auto count = static_cast<Eigen::Index>(states.size());
  Eigen::VectorXd du = Eigen::VectorXd::Zero(l.system.B.cols());
  if (column >= count) {
    inputs[static_cast<std::size_t>(column - count)] += size;
    du[column - count] = size;
  } else if (const LinearState& moved = states[static_cast<std::size_t>(column)];
             moved.kind == LinearState::Kind::auxiliary) {
    state.x[static_cast<std::size_t>(moved.index)] += size;
  } else {
    const bool is_position = moved.kind == LinearState::Kind::position;
    const auto position = static_cast<Eigen::Index>(
        std::find_if(states.begin(), states.end(), [&](const LinearState& s) { return s.index == moved.index; }) -
        states.begin());  // positions come first
    std::vector<double>& values = is_position ? state.z : state.zd;
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] += size * l.system.coordinates(static_cast<Eigen::Index>(i), position);
    }
  }
  const GenericSolver solver = solver_of(l.compilation, inputs);
  EXPECT_TRUE(solver.project(state).ok());
  GenericDerivative derivative;
  const std::vector<double> no_forces(state.z.size(), 0.0);
  EXPECT_TRUE(solver.accelerations(state, no_forces, derivative).ok());
  const std::vector<double> y = solver.outputs(state, no_forces, derivative).y;
  Beside result;
  result.deviations.resize(count + du.size());
  result.deviations << picked(states, state.z, state.zd, state.x) - picked(states, l.state.z, l.state.zd, l.state.x),
      du;
  result.results.resize(count + static_cast<Eigen::Index>(y.size()));
  result.results << picked(states, state.zd, derivative.zdd, derivative.xd),
      Eigen::Map<const Eigen::VectorXd>(y.data(), static_cast<Eigen::Index>(y.size()));
  return result;
}

/// Central differences of order four.
void expect_differences(const Linearised& l, double step, double tolerance) {
  const auto states = static_cast<Eigen::Index>(l.system.states.size());
  Eigen::MatrixXd all(states + l.system.C.rows(), states + l.system.B.cols());
  all << l.system.A, l.system.B, l.system.C, l.system.D;
  for (Eigen::Index column = 0; column < all.cols(); ++column) {
    const Beside after = beside(l, column, step), before = beside(l, column, -step);
    const Beside far_after = beside(l, column, 2 * step), far_before = beside(l, column, -2 * step);
    const auto derivative = [&](Eigen::VectorXd Beside::*part) -> Eigen::VectorXd {
      return (8 * (after.*part - before.*part) - (far_after.*part - far_before.*part)) / (12 * step);
    };
    const Eigen::VectorXd moved = derivative(&Beside::deviations), expected = derivative(&Beside::results);
    EXPECT_GT(moved.cwiseAbs().maxCoeff(), 0.1) << "column " << column;
    // The results are good to some 1e-15 of the largest of them, a force on the road, which the step divides.
    const double rounding = 1e-14 * after.results.cwiseAbs().maxCoeff() / step;
    const double allowed = tolerance * std::max(1.0, expected.cwiseAbs().maxCoeff()) + rounding;
    EXPECT_LT((all * moved - expected).cwiseAbs().maxCoeff(), allowed) << "column " << column;
  }
}

// Differences of order four with this step have some nine digits.
TEST(Linearisation, FourBarInMotionEqualsDifferences) {
  expect_differences(linearised(compiled(read_model_file(source_path("models/four_bar.json"))), 0.3, 2.0), 1e-3, 1e-8);
}

// At the speed that the model starts with, and with slips: the laws of the tyres have corners where these are zero.
TEST(Linearisation, CoachOnItsTyresEqualsDifferences) {
  Linearised l = linearised(compiled(read_model_file(source_path("models/coach.json"))), 0, 0, true);
  EXPECT_EQ(l.system.states.size(), 36u);
  ASSERT_FALSE(l.compilation.model.initial.velocities.empty());
  for (const InitialValue& velocity : l.compilation.model.initial.velocities) {
    l.state.zd[static_cast<std::size_t>(tree_coordinate(l.compilation.topology, velocity.coordinate))] = velocity.value;
  }
  ASSERT_TRUE(solver_of(l.compilation, l.inputs).project(l.state).ok());
  for (std::size_t i = 0; i < l.state.x.size(); ++i) l.state.x[i] = i % 2 == 0 ? 2e-3 : -1e-3;
  const GenericState& s = l.state;
  Result<LinearSystem> system = linearise(l.compilation, {s.z, s.zd, s.x, s.t, l.inputs});
  ASSERT_TRUE(system);
  l.system = *system;
  expect_differences(l, 1e-5, 1e-7);
}

// A disc that leans and is pushed: of its places, those that only rolling holds are states.
TEST(Linearisation, RollingDiscInMotionEqualsDifferences) {
  Linearised l = linearised(compiled(read_model(R"({ "mbgen": 1, "gravity": [0, 0, -9.81],
    "inputs": { "push": { "unit": "N", "default": 3 }, "lift": { "unit": "m", "derivative": "rate" },
                "rate": { "unit": "m/s" } },
    "bodies": { "ground": { "points": { "O": [0, 0, 0], "C": [0, 0, 0.3] } },
      "table": { "mass": 1, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } },
      "disc": { "mass": 2, "pose": { "origin": [0, 0, 0.3] }, "inertia": [0.045, 0.09, 0.045],
                "points": { "C": [0, 0, 0], "rim": [0.2, 0, 0.1] } } },
    "joints": { "lift": { "type": "prismatic", "from": "ground.O", "to": "table.O", "axis": "z" },
      "disc": { "type": "free", "from": "ground.C", "to": "disc.C", "sequence": "zxy" },
      "contact": { "type": "rolling_disc", "from": "table.O", "to": "disc.C", "axis": [0.1, -0.2, 1], "axis2": "y" } },
    "motions": { "drive": { "joint": "lift", "position": "lift" } },
    "forces": { "push": { "at": "disc.rim", "force": ["push", 0, 0] } },
    "outputs": { "x": { "point": "disc.rim", "axis": "x" }, "y": { "point": "disc.rim", "axis": "y", "quantity": "velocity" },
      "normal": { "multiplier": "contact", "equation": "normal" } } })",
                                                "test.json")),
                            0.3, 2.0);
  EXPECT_EQ(l.system.states.size(), 8u);
  expect_differences(l, 1e-3, 1e-8);
}

// Both of its cams in front stand on the edge of a plank, askew, on a road that is curved. Without friction, whose law
// has a corner where its deflections are zero.
TEST(Linearisation, EnvelopeOnAnEdgeEqualsDifferences) {
  const Linearised l = linearised(compiled(read_model(R"({ "mbgen": 1, "gravity": [0, 0, -9.81],
    "bodies": { "ground": { "points": { "O": [0, 0, 0.2] } },
      "sledge": { "mass": 5, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0.2] } },
      "hub": { "mass": 40, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0.2] } } },
    "joints": { "x": { "type": "prismatic", "from": "ground.O", "to": "sledge.O", "axis": "x" },
      "z": { "type": "prismatic", "from": "sledge.O", "to": "hub.O", "axis": "z" } },
    "roads": { "road": { "height": "0.05*cos(2*y)*x^2", "features": {
      "plank": { "type": "plank", "from": 0.2, "length": 1, "height": 0.1, "ramp": 0 } } } },
    "tyre_data": { "rubber": { "model": "pac2002", "coefficients": { "UNLOADED_RADIUS": 0.3, "FNOMIN": 4000,
      "PCX1": 1.6, "PDX1": 1.1, "PKX1": 20, "PCY1": 1.3, "PDY1": 1, "PKY1": -15, "PKY2": 1.5 } } },
    "tyres": { "tyre": { "centre": "hub.O", "axis": [-0.2, 1, 0.1], "data": "rubber", "stiffness": 1e5, "damping": 300,
      "friction": 0, "enveloping": {} } } })",
                                                      "test.json")),
                                  0.05, 0.5);
  expect_differences(l, 1e-5, 1e-7);
}

TEST(Linearisation, DrivenCoordinatesFollowTheirInputs) {
  const Linearised l = linearised(compiled(read_model(R"({ "mbgen": 1, "gravity": [0, 0, -9.81],
    "inputs": { "angle": { "unit": "rad", "derivative": "rate" }, "rate": { "unit": "rad/s", "derivative": "kick" },
                "kick": { "unit": "rad/s^2" } },
    "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
      "arm": { "mass": 1, "com": [0.3, 0, 0], "inertia": [0.1, 0.1, 0.1], "points": { "A": [0, 0, 0], "B": [0.6, 0, 0] } },
      "bob": { "mass": 1, "com": [0.6, 0, -0.4], "inertia": [0.01, 0.01, 0.01], "points": { "B": [0.6, 0, 0] } } },
    "joints": { "shoulder": { "type": "revolute", "from": "ground.A", "to": "arm.A", "axis": "y" },
                "elbow": { "type": "revolute", "from": "arm.B", "to": "bob.B", "axis": "y" } },
    "motions": { "drive": { "joint": "shoulder", "angle": "angle" } },
    "outputs": { "x": { "unit": "m", "point": "bob.B", "quantity": "position", "axis": "z" } } })",
                                                      "test.json")),
                                  0.4, 0.7);
  EXPECT_EQ(l.system.states.size(), 2u);
  EXPECT_EQ(l.system.B.cols(), 3);
  expect_differences(l, 1e-3, 1e-8);
}

// The four pairs in which the axles hop, -29.68 +- 80.67 i and so on in tests/data or ../shared, at 20 m/s with tyre
// data that the source does not have: here the stiffness of the road is fitted to a static pitch, and nothing holds the
// tyres sideways, which the body's modes need and the hopping axles hardly do.
TEST(Linearisation, IltisHopsAsPublished) {
  const Linearised l = linearised(compiled(read_model_file(source_path("models/published/iltis.json"))), 0, 0, true);
  const std::vector<Mode> list = modes(l.system);
  ASSERT_GE(list.size(), 4u);
  const std::complex<double> published[] = {{-29.37, 84.77}, {-29.38, 81.65}, {-29.68, 80.67}, {-26.56, 71.35}};
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(std::abs(list[i].eigenvalue) / std::abs(published[i]), 1, 0.02) << i;
    EXPECT_NEAR(list[i].eigenvalue.real() / published[i].real(), 1, 0.03) << i;
  }
}

// A mass of 2 kg between two shut chambers of oil, 0.5 m long: stiffness 2 E A / l. Sampled values stand still.
TEST(Linearisation, OilIsASpringAndStatesAreInA) {
  const Linearised l = linearised(compiled(read_model(R"({ "mbgen": 1, "gravity": [0, 0, 0],
    "parameters": { "bulk": 1.4e9, "area": 1e-3 },
    "bodies": { "ground": { "points": { "O": [0, 0, 0], "wall": [-0.5, 0, 0], "stop": [0.5, 0, 0] } },
      "slide": { "mass": 2, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.O", "to": "slide.O", "axis": "x" } },
    "inputs": { "wanted": {} },
    "states": {
      "front": { "derivative": "-bulk*rate.front/length.front", "initial": 5e6 },
      "back": { "derivative": "-bulk*rate.back/length.back", "initial": 5e6 },
      "lag": { "derivative": "(wanted - lag)/0.25" } },
    "sampled": { "held": { "period": 0.01, "value": "z.slide" } },
    "springs": {
      "front": { "from": "ground.wall", "to": "slide.O", "force": "-area*front" },
      "back": { "from": "ground.stop", "to": "slide.O", "force": "-area*back + held" } },
    "outputs": { "lagging": { "expression": "3*lag" } } })",
                                                      "test.json")),
                                  0, 0);
  ASSERT_EQ(l.system.states.size(), 5u);
  const double omega = std::sqrt(2 * 1.4e9 * 1e-3 / 0.5 / 2);
  double fastest = 0, slowest_lag = 0;
  for (const std::complex<double>& value : eigenvalues(l.system)) {
    fastest = std::max(fastest, value.imag());
    slowest_lag = std::min(slowest_lag, value.real());
    EXPECT_TRUE(std::abs(value.real()) < 1e-3 || std::abs(value + 4.0) < 1e-9) << value;
  }
  EXPECT_NEAR(fastest, omega, 1e-6 * omega);
  EXPECT_NEAR(slowest_lag, -4, 1e-9);
  for (const Mode& mode : modes(l.system)) {
    if (std::abs(mode.eigenvalue + 4.0) > 1e-9) continue;
    const Compilation& c = l.compilation;
    EXPECT_EQ(leading_coordinates(c.model, c.topology, c.analysis, mode), "x.lag");
  }
  EXPECT_NEAR(l.system.B(4, 0), 4, 1e-13);
  EXPECT_NEAR(l.system.C(0, 4), 3, 1e-13);
  EXPECT_NEAR(l.system.A(2, 1), -1.4e9 / 0.5, 1e-3);
}

// Pressures of 1e9 Pa/s per m/s beside a lag of 8 ms: the lag is no mode that stays.
TEST(Linearisation, UnitsOfStatesHideNoEigenvalue) {
  LinearSystem system;
  system.A = Eigen::MatrixXd{{0, 1, 0, 0}, {6e-3, -80, 0, 2e-5}, {0, 0, -125, 0}, {0, -6e9, 0, 0}};
  system.coordinates = Eigen::MatrixXd{{1, 0, 0, 0}};
  using Kind = LinearState::Kind;
  system.states = {{Kind::position, 0}, {Kind::velocity, 0}, {Kind::auxiliary, 0}, {Kind::auxiliary, 1}};
  std::vector<bool> neutral;
  for (const Mode& mode : modes(system)) neutral.push_back(mode.is_neutral);
  EXPECT_EQ(neutral, (std::vector<bool>{false, false, true})) << "oscillation, lag, place of shut-in oil";
}

TEST(Linearisation, SingularPositionIsNamed) {
  Compilation compilation = compiled(read_model_file(source_path("models/iftomm/a02_n_four_bar_2.json")));
  std::vector<double> z(static_cast<std::size_t>(compilation.topology.size()), 0.0);
  GenericState state;
  state.z = z;
  // All bars in line: the first at a right angle from the reference, where they stand upright.
  state.z[0] = std::numbers::pi / 2;
  state.zd = z;
  const GenericSolver solver = solver_of(compilation, {});
  solver.project_nearest(state);
  const Result<LinearSystem> system = linearise(compilation, {state.z, state.zd, {}, 0, {}});
  ASSERT_FALSE(system);
  EXPECT_NE(to_text(system.problems()).find("is singular at this position"), std::string::npos);
}

}  // namespace
}  // namespace mbgen
