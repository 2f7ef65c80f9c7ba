// Driven coordinates against hand calculations: what a drive has to give, and its sign.

#include <cmath>
#include <fstream>
#include <iterator>

#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

constexpr double kGravity = 9.81;
constexpr double kRounding = 1e-13;  // of sums of a few terms of order 1 to 10

/// A mechanism at an instant, where its motions put it, with its accelerations.
struct Instant {
  GenericState state;
  GenericDerivative derivative;
  GenericOutputs outputs;
  std::vector<double> drive;
  Mechanism mechanism;

  double z(const std::string& name) const { return state.z[find_coordinate(mechanism.topology, name)]; }
  double zd(const std::string& name) const { return state.zd[find_coordinate(mechanism.topology, name)]; }
  double zdd(const std::string& name) const { return derivative.zdd[find_coordinate(mechanism.topology, name)]; }
};

/// guess: positions and velocities of the coordinates that no motion gives, by name.
struct Guess {
  std::string name;
  double position = 0, velocity = 0;
};

Instant instant(const std::string& model, double t, const std::vector<Guess>& guesses = {},
                const std::vector<double>& inputs = {}) {
  Instant at{{}, {}, {}, {}, mechanism_of(model)};
  const Mechanism& m = at.mechanism;
  GenericSolver solver(m.model, m.topology, m.analysis);
  if (!inputs.empty()) solver.set_inputs(inputs);
  const std::size_t n = m.topology.bodies.size();
  at.state = {std::vector<double>(n, 0.0), std::vector<double>(n, 0.0), {}, t};
  for (const Guess& guess : guesses) {
    at.state.z[find_coordinate(m.topology, guess.name)] = guess.position;
    at.state.zd[find_coordinate(m.topology, guess.name)] = guess.velocity;
  }
  const std::vector<double> no_tau(n, 0.0);
  EXPECT_TRUE(solver.project(at.state).ok());
  EXPECT_TRUE(solver.accelerations(at.state, no_tau, at.derivative).ok());
  at.outputs = solver.outputs(at.state, no_tau, at.derivative);
  at.drive = solver.driving_forces(at.state, no_tau, at.derivative);
  return at;
}

// z = 0.4 sin(3 t): the drive turns the inertia about the pin and lifts the weight.
TEST(DrivenPendulum, TorqueIsInertiaAndGravity) {
  const double mass = 3, length = 0.7, inertia = 0.2;
  for (const double t : {0.0, 0.3, 0.9, 1.4}) {
    const Instant at = instant(R"json({ "mbgen": 1, "bodies": {
        "ground": { "points": { "O": [0, 0, 0] } },
        "bob": { "mass": 3, "com": [0, 0, -0.7], "inertia": [0.2, 0.2, 0.01], "points": { "O": [0, 0, 0] } } },
      "joints": { "pin": { "type": "revolute", "from": "ground.O", "to": "bob.O", "axis": "y" } },
      "motions": { "m": { "joint": "pin", "angle": "0.4*sin(3*t)" } },
      "outputs": { "torque": { "motion": "m" } } })json",
                               t);
    const double z = 0.4 * std::sin(3 * t), zd = 1.2 * std::cos(3 * t), zdd = -3.6 * std::sin(3 * t);
    EXPECT_EQ(at.z("pin"), z);
    EXPECT_DOUBLE_EQ(at.zd("pin"), zd);
    EXPECT_NEAR(at.zdd("pin"), zdd, kRounding);
    const double torque = (inertia + mass * length * length) * zdd + mass * kGravity * length * std::sin(z);
    EXPECT_NEAR(at.drive[0], torque, 1e-12);
    EXPECT_EQ(at.outputs.y[0], at.drive[0]);
    EXPECT_NEAR(at.outputs.applied_power, torque * zd, 1e-12) << "what the drive puts in";
    EXPECT_EQ(at.mechanism.model.outputs[0].unit, "N m");
  }
}

// A crank at constant rate, an eccentric weight on it, a massless rod, a piston: x = r cos a + sqrt(l^2 - r^2 sin^2 a).
TEST(DrivenSliderCrank, TorqueOfAConstantRate) {
  const double r = 0.05, l = 0.16, piston = 0.6, crank = 2, eccentric = 0.01, rate = 40;
  const std::string model = R"({ "mbgen": 1, "bodies": {
      "ground": { "points": { "O": [0, 0, 0], "cylinder": [0.21, 0, 0] } },
      "crank":  { "mass": 2, "com": [0.01, 0, 0], "inertia": [0.001, 0.002, 0.001],
                  "points": { "O": [0, 0, 0], "pin": [0.05, 0, 0] } },
      "piston": { "mass": 0.6, "com": [0.22, 0, 0], "inertia": [1e-4, 1e-4, 1e-4], "points": { "wrist": [0.21, 0, 0] } } },
    "joints": {
      "crank":  { "type": "revolute", "from": "ground.O", "to": "crank.O", "axis": "-y" },
      "piston": { "type": "prismatic", "from": "ground.cylinder", "to": "piston.wrist", "axis": "x" } },
    "rods": { "rod": { "from": "crank.pin", "to": "piston.wrist" } },
    "motions": { "turn": { "joint": "crank", "angle": "40*t" } } })";
  for (const double a : {0.2, 0.8, 1.5, 2.6, 4.0, 5.5}) {
    const double s = std::sin(a), c = std::cos(a), root = std::sqrt(l * l - r * r * s * s);
    const double x = r * c + root, slope = -r * s - r * r * s * c / root;
    const double curve = -r * c - r * r * (c * c - s * s) / root - std::pow(r * r * s * c, 2) / std::pow(root, 3);
    const Instant at = instant(model, a / rate, {{"piston", x - r - l}});
    EXPECT_NEAR(at.z("piston"), x - r - l, 1e-12);
    EXPECT_NEAR(at.zd("piston"), slope * rate, 1e-11);
    EXPECT_NEAR(at.zdd("piston"), curve * rate * rate, 1e-9);
    const double torque = piston * curve * rate * rate * slope + crank * kGravity * eccentric * c;
    EXPECT_NEAR(at.drive[0], torque, 1e-11) << a;
    EXPECT_NEAR(at.outputs.applied_power, torque * rate, 1e-9) << a;
  }
}

// Inputs give angle, rate and acceleration; the torque is inertia times acceleration.
TEST(DrivenRotor, IsSpunUpByInputs) {
  const Instant at = instant(R"({ "mbgen": 1, "inputs": {
      "acceleration": {}, "angle": { "derivative": "rate" }, "rate": { "derivative": "acceleration" } },
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
      "rotor": { "mass": 4, "inertia": [0.2, 0.2, 0.3], "points": { "O": [0, 0, 0] } } },
    "joints": { "shaft": { "type": "revolute", "from": "ground.O", "to": "rotor.O", "axis": "z" } },
    "motions": { "spin": { "joint": "shaft", "angle": "2*angle" } } })",
                             0.5, {}, {7, 0.25, 3});
  EXPECT_EQ(at.z("shaft"), 0.5);
  EXPECT_EQ(at.zd("shaft"), 6);
  EXPECT_EQ(at.zdd("shaft"), 14);
  EXPECT_NEAR(at.drive[0], 0.3 * 14, kRounding);
  EXPECT_NEAR(at.outputs.kinetic_energy, 0.5 * 0.3 * 36, kRounding);
  EXPECT_NEAR(at.outputs.applied_power, 0.3 * 14 * 6, 1e-12);
}

// M_ff zdd_f = b_f - M_fg zdd_g and M_gf zdd_f + M_gg zdd_g - b_g (theory.md section 4), with the matrices by hand.
TEST(DrivenCart, PendulumFollowsAndPullsBack) {
  const double cart = 5, bob = 2, length = 0.5, a = 0.7, w = -1.9, acceleration = 1.2, torque = 0.8;
  Mechanism m = load("tests/data/models/driven_cart.json");
  GenericSolver solver(m.model, m.topology, m.analysis);
  solver.set_inputs({0.1, 0.6, acceleration, torque});
  GenericState state{{0, a}, {0, w}, {}, 0};
  GenericDerivative derivative;
  ASSERT_TRUE(solver.project(state).ok());
  ASSERT_TRUE(solver.accelerations(state, {0, 0}, derivative).ok());
  EXPECT_EQ(state.z[0], 0.1);
  EXPECT_EQ(state.zd[0], 0.6);
  EXPECT_EQ(derivative.zdd[0], acceleration);
  // Turning by a about y moves the bob to (-l sin a, 0, -l cos a).
  const double m_ff = bob * length * length, m_fg = -bob * length * std::cos(a), m_gg = cart + bob;
  const double b_f = torque - bob * kGravity * length * std::sin(a);
  const double b_g = -bob * length * w * w * std::sin(a);
  const double zdd = (b_f - m_fg * acceleration) / m_ff;
  EXPECT_NEAR(derivative.zdd[1], zdd, 1e-12);
  const double force = m_fg * zdd + m_gg * acceleration - b_g;
  EXPECT_NEAR(solver.driving_forces(state, {0, 0}, derivative)[0], force, 1e-12);
  EXPECT_NEAR(solver.outputs(state, {0, 0}, derivative).applied_power, force * 0.6 + torque * w, 1e-12);
}

// At rest only weight is carried. In a parallelogram all bars keep their directions, so virtual work lifts the two
// arms by half of what it lifts the table: T da = -(m1/2 + m2 + m3/2) g r sin(a) da.
TEST(DrivenParallelogram, HoldsItsWeight) {
  const double r = 0.5;
  for (const double angle : {0.0, 0.4, -0.9, 1.2}) {
    const Instant at = instant(R"({ "mbgen": 1, "parameters": { "hold": )" + std::to_string(angle) + R"( },
      "bodies": {
        "ground": { "points": { "A": [0, 0, 0], "D": [0.8, 0, 0] } },
        "left":  { "mass": 1.5, "com": [0, 0, 0.25], "inertia": [0.03, 0.03, 0.01],
                   "points": { "A": [0, 0, 0], "B": [0, 0, 0.5] } },
        "table": { "mass": 6, "com": [0.5, 0, 0.7], "inertia": [0.3, 0.5, 0.6],
                   "points": { "B": [0, 0, 0.5], "C": [0.8, 0, 0.5] } },
        "right": { "mass": 2.5, "com": [0.8, 0, 0.25], "inertia": [0.03, 0.03, 0.01],
                   "points": { "D": [0.8, 0, 0], "C": [0.8, 0, 0.5] } } },
      "joints": {
        "left":  { "type": "revolute", "from": "ground.A", "to": "left.A", "axis": "y" },
        "table": { "type": "revolute", "from": "left.B", "to": "table.B", "axis": "-y" },
        "right": { "type": "revolute", "from": "ground.D", "to": "right.D", "axis": "y" },
        "tip":   { "type": "revolute", "from": "table.C", "to": "right.C", "axis": "y", "cut": true } },
      "motions": { "hold": { "joint": "left", "angle": "hold" } } })",
                               0, {{"table", angle}, {"right", angle}});
    EXPECT_NEAR(at.z("right"), angle, 1e-12) << "the parallelogram, not its crossed mirror image";
    EXPECT_EQ(largest_absolute(at.state.zd), 0);
    EXPECT_NEAR(largest_absolute(at.derivative.zdd), 0, 1e-12);
    EXPECT_NEAR(at.drive[0], -(0.75 + 6 + 1.25) * kGravity * r * std::sin(angle), 1e-11);
  }
}

// Every engine that drives follows the motion's rate and acceleration: differences of the motion's own position agree.
TEST(DrivenFiveBar, MovesAsItsExpressionsSay) {
  Mechanism m = load("tests/data/models/driven_five_bar.json");
  GenericSolver solver(m.model, m.topology, m.analysis);
  const int left = find_coordinate(m.topology, "left"), right = find_coordinate(m.topology, "right");
  const double h = 1e-4, t = 0.4, lift = 0.06, rate = 0.8, acceleration = -3;
  const auto at = [&](double dt) {
    solver.set_inputs({lift + dt * (rate + dt / 2 * acceleration), rate + dt * acceleration, acceleration});
    GenericState state{std::vector<double>(4, 0.0), std::vector<double>(4, 0.0), {}, t + dt};
    EXPECT_TRUE(solver.project(state).ok());
    return state;
  };
  const GenericState before = at(-h), after = at(h), here = at(0);
  GenericDerivative derivative;
  ASSERT_TRUE(solver.accelerations(here, std::vector<double>(4, 0.0), derivative).ok());
  EXPECT_EQ(here.z[left], 0.25 * std::sin(3 * t));
  EXPECT_EQ(here.z[right], lift + 0.1 * std::sin(lift) * std::cos(2 * t));
  for (std::size_t i = 0; i < 4; ++i) {  // dependent ones too; h^2/6 of a third derivative below 50
    EXPECT_NEAR(here.zd[i], (after.z[i] - before.z[i]) / (2 * h), 1e-7) << i;
    EXPECT_NEAR(derivative.zdd[i], (after.zd[i] - before.zd[i]) / (2 * h), 2e-7) << i;
  }
}

/// The model of driven_cut.json with other joints cut.
std::string driven_cut(const std::string& cut_in_plane, const std::string& cut_in_space) {
  std::ifstream file(source_path("tests/data/models/driven_cut.json"));
  std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::string mark = ", \"cut\": true";
  for (std::size_t at; (at = text.find(mark)) != std::string::npos;) text.erase(at, mark.size());
  for (const std::string& name : {cut_in_plane, cut_in_space})
    text.insert(text.find(" }", text.find("\"" + name + "\": ", text.find("\"joints\""))), mark);
  return text;
}

// Where a loop is cut is nobody's business: the motions, the forces of the drives and all reactions are those of the
// same mechanism cut where nothing is driven.
TEST(DrivenCut, IsTheMechanismCutElsewhere) {
  for (const double t : {0.0, 0.35, 1.1}) {
    const std::vector<double> inputs{0.1 + 0.2 * t, 0.7, -2};
    const Instant cut = instant(driven_cut("tip", "slide"), t, {{"arm", 0.1, 1.5}, {"slide_tx", 0.02, 0.4}}, inputs);
    EXPECT_EQ(cut.mechanism.topology.loops.size(), 2u);
    EXPECT_EQ(cut.mechanism.topology.loops[0].name, "tip_closure");
    std::vector<Guess> closed;
    for (std::size_t i = 0; i < cut.state.z.size(); ++i)
      closed.push_back({cut.mechanism.topology.bodies[i].coordinate, cut.state.z[i], cut.state.zd[i]});
    const Mechanism other = mechanism_of(driven_cut("elbow", "ball"));
    std::erase_if(closed, [&](const Guess& g) { return find_coordinate(other.topology, g.name) < 0; });
    const Instant plain = instant(driven_cut("elbow", "ball"), t, closed, inputs);
    for (const TreeBody& body : other.topology.bodies) {
      EXPECT_NEAR(cut.z(body.coordinate), plain.z(body.coordinate), 1e-11) << body.coordinate;
      EXPECT_NEAR(cut.zd(body.coordinate), plain.zd(body.coordinate), 1e-10) << body.coordinate;
      EXPECT_NEAR(cut.zdd(body.coordinate), plain.zdd(body.coordinate), 1e-8) << body.coordinate;
    }
    EXPECT_EQ(cut.z("tip"), 0.3 * std::sin(2 * t));
    EXPECT_NEAR(cut.zdd("tip"), -1.2 * std::sin(2 * t), kRounding);
    EXPECT_GT(std::abs(cut.drive[0]) * std::abs(cut.drive[1]), 0.01);
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(cut.drive[k], plain.drive[k], 1e-8 * (1 + std::abs(plain.drive[k])));
    for (std::size_t k = 0; k < plain.outputs.y.size(); ++k)
      EXPECT_NEAR(cut.outputs.y[k], plain.outputs.y[k], 1e-8 * (1 + std::abs(plain.outputs.y[k])))
          << plain.mechanism.model.outputs[k].name;
    EXPECT_NEAR(cut.outputs.kinetic_energy, plain.outputs.kinetic_energy, 1e-11);
    EXPECT_NEAR(cut.outputs.applied_power, plain.outputs.applied_power, 1e-7);
  }
}

}  // namespace
}  // namespace mbgen
