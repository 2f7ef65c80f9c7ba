// Ropes in space: the generic runtime against the judges, whose geometry is another one, and the energy of motions.

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "compiler/model/element_access.hpp"
#include "compiler/model/holds.hpp"
#include "mbgen/solver/rosenbrock.hpp"
#include "runtime/judges/cartesian.hpp"
#include "tests/judges/cartesian_support.hpp"
#include "tests/support/dynamics.hpp"
#include "tests/support/mechanism_support.hpp"
#include "tests/support/reaction_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A frame that moves freely with a wheel on it, a wheel on ground, and a bob that moves freely; with some ropes.
std::string wheels_with(const std::string& ropes, const std::string& tilt = "[0.1, 1, 0.05]") {
  return fmt::format(R"({{ "mbgen": 1, "name": "wheels",
    "inputs": {{ "pull": {{ "derivative": "pull_rate" }}, "pull_rate": {{}} }},
    "bodies": {{
      "ground": {{ "points": {{ "A": [-2, 0.3, 0.2], "B": [2, -0.2, 0.1], "F": [0, 0, 1], "G": [-1.2, -0.1, 0.3], "C": [0.1, 0.2, 3], "W": [1.4, 0.1, 1.9] }} }},
      "frame": {{ "mass": 5, "inertia": [0.5, 0.6, 0.4], "pose": {{ "origin": [0, 0, 1] }},
        "points": {{ "O": [0, 0, 0], "W": [0.2, 0, 0.3], "P": [-0.3, 0.2, -0.1], "S": [0, 0, 0.1] }} }},
      "wheel": {{ "mass": 1, "inertia": [0.02, 0.03, 0.02], "pose": {{ "origin": [0.2, 0, 1.3] }},
        "points": {{ "O": [0, 0, 0] }} }},
      "drum": {{ "mass": 2, "inertia": [0.05, 0.08, 0.05], "pose": {{ "origin": [1.4, 0.1, 1.9] }},
        "points": {{ "O": [0, 0, 0] }} }},
      "bob": {{ "mass": 3, "inertia": [0.1, 0.1, 0.1], "pose": {{ "origin": [-1.2, -0.1, 0.3] }},
        "points": {{ "O": [0, 0, 0], "E": [0.05, 0.02, 0.1] }} }} }},
    "joints": {{
      "frame": {{ "type": "free", "from": "ground.F", "to": "frame.O" }},
      "wheel": {{ "type": "revolute", "from": "frame.W", "to": "wheel.O", "axis": "y" }},
      "drum": {{ "type": "revolute", "from": "drum.O", "to": "ground.W", "axis": {} }},
      "bob": {{ "type": "free", "from": "ground.G", "to": "bob.O" }} }},
    "ropes": {{ {} }} }})",
                     tilt, ropes);
}

constexpr const char* kLaw = R"("EA": 2e3, "damping": 0.003, "pretension": 20)";

struct Case {
  const char* name;
  std::string ropes;
};

std::vector<Case> cases() {
  const auto wheel = [](const char* contact, const char* sense = "negative") {
    return fmt::format(R"({{ "pulley": "wheel.O", "axis": "y", "radius": 0.12, "sense": "{}"{} }})", sense, contact);
  };
  const auto second = [](const char* kind, const char* sense, const char* contact) {
    return fmt::format(R"({{ "{}": "drum.O", "axis": [0.1, 1, 0.05], "radius": 0.15, "sense": "{}"{} }})", kind, sense,
                       contact);
  };
  const auto rope = [](const std::string& path, const std::string& rest) {
    return fmt::format(R"("rope": {{ "path": [{}], {} }})", path, rest);
  };
  const std::string bob = R"({ "point": "bob.E" })", a = R"({ "point": "ground.A" })", b = R"({ "point": "ground.B" })",
                    eye = R"({ "point": "frame.P" })", grips = R"(, "contact": "grips")",
                    rubs = R"(, "friction": 0.15)";
  const std::string law(kLaw);
  return {
      {"eyelet", rope(a + ", " + eye + ", " + bob, law)},
      {"pulley", rope(b + ", " + wheel("") + ", " + bob, law)},
      {"winch_by_input",
       rope(b + ", " + wheel("") + ", " + bob, R"x("EA": 2e3, "damping": 0.003, "free_length": "3.5 + 0.1*pull")x")},
      {"two_pulleys", rope(b + ", " + second("pulley", "negative", "") + ", " + wheel("") + ", " + bob, law)},
      {"crossed",
       rope(R"({ "point": "ground.C" }, )" + second("pulley", "positive", "") + ", " + wheel("") + ", " + bob, law)},
      {"drum", rope(second("drum", "positive", "") + ", " + wheel("") + ", " + bob, law)},
      {"drum_at_the_end", rope(bob + ", " + wheel("", "positive") + ", " + second("drum", "negative", ""), law)},
      {"grips", rope(b + ", " + wheel(grips.c_str()) + ", " + bob, law)},
      {"grips_with_stiffness",
       rope(b + ", " + wheel(grips.c_str()) + ", " + bob, R"("stiffness": 1e3, "damping": 0.002, "pretension": 20)")},
      {"rubs", rope(b + ", " + wheel(rubs.c_str()) + ", " + bob, law)},
      {"rubs_twice",
       rope(b + ", " + second("pulley", "negative", rubs.c_str()) + ", " + wheel(rubs.c_str()) + ", " + bob, law)},
      {"belt", fmt::format(R"("rope": {{ "closed": true, "path": [{}, {}], "EA": 2e3, "pretension": 30 }})",
                           wheel(grips.c_str(), "positive"), second("pulley", "positive", grips.c_str()))},
      {"rubbing_belt", fmt::format(R"("rope": {{ "closed": true, "path": [{}, {}], "EA": 2e3, "pretension": 30 }})",
                                   wheel(rubs.c_str(), "positive"), second("pulley", "positive", rubs.c_str()))},
      {"belt_with_idler",
       fmt::format(
           R"("rope": {{ "closed": true, "path": [{}, {}, {{ "point": "ground.B" }}], "EA": 2e3, "pretension": 30 }})",
           wheel("", "positive"), second("pulley", "positive", grips.c_str()))},
      {"cylinder",
       rope(a + R"(, { "cylinder": "frame.S", "axis": [0.2, 1, 0.1], "radius": 0.25, "sense": "positive" }, )" + b,
            law)},
      {"cylinder_beside",
       rope(a + R"(, { "cylinder": "drum.O", "axis": "y", "radius": 0.25, "sense": "negative" }, )" + eye + ", " + b,
            law)},
      {"sphere", rope(a + R"(, { "sphere": "frame.S", "radius": 0.95 }, )" + b, law)},
      {"sphere_beside", rope(a + R"(, { "sphere": "drum.O", "radius": 0.25 }, )" + eye + ", " + b, law)},
  };
}

Mechanism mechanism_with(const std::string& ropes) {
  Model model = model_of(wheels_with(ropes));
  for (std::size_t i = 0; i < model.ropes.size(); ++i)
    for (const ElementQuantity& quantity : KindOf<Rope>::quantities)
      model.outputs.push_back({fmt::format("{}{}", quantity.name, i), {}, "", output_of<Rope>(quantity.name, i)});
  return analysed(std::move(model));
}

GenericState near_reference(const Mechanism& m, std::mt19937& random, double size) {
  GenericState state = reference_state(m);
  std::uniform_real_distribution<double> any(-1, 1);
  for (double& z : state.z) z += size * any(random);
  for (double& zd : state.zd) zd = any(random);
  for (double& x : state.x) x = 2e-3 * any(random);
  return state;
}

TEST(RopesInSpace, HaveTheForcesOfTheJudges) {
  std::mt19937 random(4);
  for (const Case& one : cases()) {
    const Mechanism m = mechanism_with(one.ropes);
    GenericSolver generic(m.model, m.topology, m.analysis);
    CartesianSolver judge(m.model, m.topology, CartesianMethod::augmented, Stabilisation::projection);
    const std::vector<double> inputs = {0.2, 0.7};
    generic.set_inputs(inputs);
    judge.set_inputs(inputs);
    int taut = 0;
    for (int s = 0; s < 6; ++s) {
      const GenericState state = near_reference(m, random, 0.08);
      const std::vector<double> tau(state.z.size());
      GenericDerivative expected, actual;
      ASSERT_TRUE(generic.accelerations(state, tau, actual).ok()) << one.name;
      ASSERT_TRUE(judge.accelerations(state, tau, expected).ok()) << one.name;
      EXPECT_LT(relative_error(actual.zdd, expected.zdd), 1e-9) << one.name;
      EXPECT_LT(relative_error(actual.xd, expected.xd), 1e-8) << one.name;
      GenericOutputs by_judge;
      ASSERT_TRUE(judge.outputs(state, tau, by_judge).ok()) << one.name;
      const GenericOutputs y = generic.outputs(state, tau, actual);
      EXPECT_LT(relative_error(y.y, by_judge.y), 1e-9) << one.name;
      for (std::size_t i = 0; i < y.y.size(); i += KindOf<Rope>::quantities.size()) taut += y.y[i] > 1 ? 1 : 0;
    }
    EXPECT_GT(taut, 0) << one.name;
  }
}

/// The place at which the rope of a load at x, z is lost, by the generic runtime and by a judge; "" where it holds.
std::string lost_place(const std::string& path, double x, double z, double pretension = 100) {
  const Mechanism m = analysed(model_of(fmt::format(R"({{ "mbgen": 1, "name": "lost", "bodies": {{
    "ground": {{ "points": {{ "A": [-1, 0, 0.1], "O": [0, 0, 0], "L": [1, 0, -1] }} }},
    "wheel": {{ "mass": 1, "inertia": [0.1, 0.1, 0.1], "points": {{ "O": [0, 0, 0] }} }},
    "load": {{ "mass": 1, "inertia": [1, 1, 1], "pose": {{ "origin": [1, 0, -1] }}, "points": {{ "O": [0, 0, 0] }} }} }},
  "joints": {{ "wheel": {{ "type": "revolute", "from": "ground.O", "to": "wheel.O", "axis": "y" }},
    "load": {{ "type": "planar", "from": "ground.L", "to": "load.O", "axis": "y" }} }},
  "ropes": {{ "hoist": {{ "EA": 1e3, "pretension": {}, "path": [{}, {{ "point": "load.O" }}] }} }} }})",
                                                    pretension, path)));
  GenericState state = reference_state(m);
  for (std::size_t i = 0; i < state.z.size(); ++i) {
    const std::string& name = m.topology.bodies[i].coordinate;
    if (name.ends_with("tx")) state.z[i] = x - 1;
    if (name.ends_with("tz")) state.z[i] = z + 1;
    if (name == "wheel") state.z[i] = x > 50 ? -30 : 0;
  }
  const std::vector<double> tau(state.z.size());
  GenericDerivative rates;
  const Status generic = GenericSolver(m.model, m.topology, m.analysis).accelerations(state, tau, rates);
  const Status judged = CartesianSolver(m.model, m.topology, CartesianMethod::augmented, Stabilisation::projection)
                            .accelerations(state, tau, rates);
  EXPECT_EQ(generic.code, judged.code);
  EXPECT_EQ(generic.index, judged.index);
  if (generic.ok()) return "";
  EXPECT_EQ(generic.code, Code::rope_lost) << text(generic.code);
  return generic.index < 0 ? "?" : hold_names(m.model)[static_cast<std::size_t>(generic.index)];
}

TEST(RopesInSpace, NameThePlaceWhereTheyAreLost) {
  const auto over = [](const char* kind, const char* at, const char* rest) {
    return fmt::format(R"({{ "{}": "{}", "axis": "y", "radius": 0.1, "sense": "positive"{} }})", kind, at, rest);
  };
  const std::string a = R"({ "point": "ground.A" }, )", pulley = a + over("pulley", "wheel.O", "");
  EXPECT_EQ(lost_place(pulley, 1, -1), "");
  EXPECT_EQ(lost_place(pulley, 1, 1), "hoist at wheel.O");
  EXPECT_EQ(lost_place(pulley, 0.2, 0.2, 0), "");  // slack
  EXPECT_EQ(lost_place(pulley, 0.05, -0.05), "hoist from wheel.O to load.O");
  EXPECT_EQ(lost_place(a + over("pulley", "wheel.O", R"(, "contact": "grips")"), 1, 1), "hoist at wheel.O");
  EXPECT_EQ(lost_place(a + over("pulley", "wheel.O", R"(, "friction": 0.2)"), 1, 1), "hoist at wheel.O");
  EXPECT_EQ(lost_place(over("drum", "wheel.O", ""), 0.05, -0.05), "hoist from wheel.O to load.O");
  EXPECT_EQ(lost_place(over("drum", "wheel.O", ""), 60, -1), "hoist");  // wound up
  EXPECT_EQ(lost_place(a + over("cylinder", "ground.O", ""), 0.05, -0.05), "hoist from ground.A to load.O");
  EXPECT_EQ(lost_place(a + R"({ "point": "ground.O" })", 0, 0), "hoist from ground.O to load.O");
}

/// Kinetic and potential energy, with the strain energy of the rope.
double energy_of(const GenericSolver& solver, const GenericState& state) {
  GenericDerivative rates;
  const std::vector<double> tau(state.z.size());
  EXPECT_TRUE(solver.accelerations(state, tau, rates).ok());
  const GenericOutputs y = solver.outputs(state, tau, rates);
  double energy = y.kinetic_energy + y.potential_energy;
  for (std::size_t i = KindOf<Rope>::quantities.size(); i <= y.y.size(); i += KindOf<Rope>::quantities.size())
    energy += y.y[i - 1];
  return energy;
}

std::string without(std::string text, const std::string& part) {
  if (const std::size_t at = text.find(part); at != std::string::npos) text.erase(at, part.size());
  return text;
}

/// Largest rise and change of the energy of a motion of 0.2 s.
std::pair<double, double> energy_of_motion(const std::string& ropes, int steps) {
  const Mechanism m = mechanism_with(ropes);
  GenericSolver solver(m.model, m.topology, m.analysis);
  solver.set_inputs({0, 0});
  const Dynamics dynamics{solver};
  std::mt19937 random(9);
  GenericState state = near_reference(m, random, 0.05);
  for (double& zd : state.zd) zd *= 0.3;
  double before = energy_of(solver, state), rise = 0, change = 0;
  const double first = before;
  for (int k = 0; k < steps; ++k) {
    if (!step_rk4(dynamics, state, 0.2 / steps).ok()) {  // a rope lifts off its pulley
      EXPECT_GT(k, steps / 2);
      break;
    }
    const double now = energy_of(solver, state);
    rise = std::max(rise, now - before);
    change = std::max(change, std::abs(now - first));
    before = now;
  }
  return {rise, change};
}

// Motions with large swings in space, over pulleys that tilt against each other, onto drums.
TEST(RopesInSpace, ConserveEnergyWithoutDampingAndFriction) {
  for (const Case& one : cases()) {
    const std::string name = one.name,
                      ropes = without(without(one.ropes, R"(, "damping": 0.003)"), R"(, "damping": 0.002)");
    if (name.starts_with("rub")) continue;
    EXPECT_LT(energy_of_motion(ropes, 800).second, 5e-5) << name;  // of 20 to 60 J
  }
}

TEST(RopesInSpace, LoseEnergyByDampingAndFriction) {
  for (const Case& one : cases()) {
    const auto [rise, change] = energy_of_motion(one.ropes, 800);
    EXPECT_LT(rise, 1e-5) << one.name;
    if (std::string(one.name).starts_with("rubs")) {
      EXPECT_GT(change, 1e-2) << one.name;
    }
  }
}

// The matrix of an implicit step has the derivatives of tensions over lengths, rates and slips. Turns of directions,
// which it leaves out, are small beside the stiffness.
TEST(RopesInSpace, HaveTheirStiffnessInImplicitSteps) {
  for (const Case& one : cases()) {
    const Mechanism m = mechanism_with(one.ropes);
    GenericSolver solver(m.model, m.topology, m.analysis);
    solver.set_inputs({0, 0});
    const Dynamics dynamics{solver};
    GenericState state = reference_state(m), exact = state;
    for (int k = 0; k < 4000; ++k) ASSERT_TRUE(step_rk4(dynamics, exact, 2.5e-5).ok()) << one.name;
    double errors[2];
    for (int halving = 0; halving < 2; ++halving) {
      GenericState rough = state;
      const int steps = 50 << halving;
      for (int k = 0; k < steps; ++k) ASSERT_TRUE(step_rosenbrock(dynamics, rough, 0.1 / steps).ok()) << one.name;
      errors[halving] = 0;
      for (std::size_t i = 0; i < rough.z.size(); ++i)
        errors[halving] = std::max(errors[halving], std::abs(rough.z[i] - exact.z[i]));
    }
    EXPECT_LT(errors[1], 1e-4) << one.name;
    EXPECT_LT(errors[1], errors[0] + 2e-5) << one.name;
  }
}

}  // namespace
}  // namespace mbgen
