// Loads whose division follows from the choice of equations: what is named is what another choice changes.

#include <fmt/format.h>

#include <map>

#include "compiler/analysis/notes.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

Mechanism mechanism(const std::string& text) { return analysed(read_model(text, "made.json")); }

/// Message of the last note: that of outputs.
std::string last_note(const Mechanism& m) {
  const Diagnostics notes = analysis_notes(m.model, m.topology, m.analysis);
  return notes.empty() ? "" : notes.back().message;
}

/// Outputs at rest at the reference by name.
std::map<std::string, double> values_of(const Mechanism& m) {
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const GenericState state = reference_state(m);
  const std::vector<double> tau(state.z.size(), 0.0);
  GenericDerivative derivative;
  EXPECT_TRUE(solver.accelerations(state, tau, derivative).ok());
  const GenericOutputs outputs = solver.outputs(state, tau, derivative);
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < m.model.outputs.size(); ++i) values[m.model.outputs[i].name] = outputs.y[i];
  return values;
}

/// Names of outputs that two choices of equations see otherwise, where both have them.
std::string different(const Mechanism& a, const Mechanism& b) {
  const std::map<std::string, double> of_a = values_of(a), of_b = values_of(b);
  std::string names;
  for (const auto& [name, value] : of_a) {
    const auto found = of_b.find(name);
    if (found == of_b.end() || std::abs(value - found->second) < 1e-9 * (1 + std::abs(value))) continue;
    names += (names.empty() ? "" : " ") + name;
  }
  return names;
}

/// A table of 12 kg on four upright legs of equal length, load out of its middle, that swings along x and may tilt.
std::string table(const std::vector<std::string>& legs) {
  const std::map<std::string, std::string> places = {{"a", "1, 1"}, {"b", "-1, 1"}, {"c", "-1, -1"}, {"d", "1, -1"}};
  std::string feet, corners, rods, outputs;
  for (const std::string& leg : legs) {
    feet += fmt::format(R"("{}": [{}, 0], )", leg, places.at(leg));
    corners += fmt::format(R"("{}": [{}, 1], )", leg, places.at(leg));
    rods += fmt::format(R"({1}"{0}": {{ "from": "ground.{0}", "to": "top.{0}" }})", leg, rods.empty() ? "" : ", ");
    outputs += fmt::format(R"("f{0}": {{ "reaction": "{0}", "axis": "z" }}, )", leg);
  }
  const std::string part = R"({ "mass": 0.1, "inertia": [0.01, 0.01, 0.01], "points": { "O": [0, 0, 1] } })";
  return R"({ "mbgen": 1, "bodies": { "ground": { "points": { )" + feet + R"("O": [0, 0, 1] } }, "slide": )" + part +
         R"(, "lift": )" + part + R"(, "cross": )" + part +
         R"(, "top": { "mass": 12, "com": [0.3, 0.2, 1], "inertia": [1, 1, 1], "points": { )" + corners +
         R"("O": [0, 0, 1] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.O", "to": "slide.O", "axis": "x" },
      "lift": { "type": "prismatic", "from": "slide.O", "to": "lift.O", "axis": "z" },
      "roll": { "type": "revolute", "from": "lift.O", "to": "cross.O", "axis": "x" },
      "pitch": { "type": "revolute", "from": "cross.O", "to": "top.O", "axis": "y" } },
    "rods": { )" +
         rods + R"( },
    "outputs": { )" +
         outputs + R"("fy": { "reaction": "slide", "axis": "y" },
      "mz": { "reaction": "slide", "quantity": "moment", "axis": "z" } } })";
}

TEST(SharedLoads, OfFourLegsAreNamedAndThoseOfTheGuideAreNot) {
  const Mechanism m = mechanism(table({"a", "b", "c", "d"})), other = mechanism(table({"d", "c", "b", "a"}));
  EXPECT_EQ(different(m, other), "fa fb fc fd");
  EXPECT_EQ(
      last_note(m),
      "1 equation of loops \"a\", \"b\", \"c\", \"d\" repeats others: how \"a\", \"b\", \"c\" and \"d\" share the "
      "load follows from the choice of equations, and with it outputs fa, fb, fc and fd");
}

/// Four bars in a plane, closed by one pin or by another; some weight acts out of the plane.
std::string four_bar(const std::string& cut, const std::string& outputs) {
  const auto pin = [&](const std::string& name, const std::string& from, const std::string& to) {
    return fmt::format(R"("{}": {{ "type": "revolute", "from": "{}", "to": "{}", "axis": "y"{} }})", name, from, to,
                       name == cut ? R"(, "cut": true)" : "");
  };
  return R"({ "mbgen": 1, "gravity": [0, 3, -9.81], "bodies": { "ground": { "points": { "A": [0, 0, 0], "D": [0.4, 0, 0] } },
    "crank": { "mass": 0.8, "com": [0.05, 0.03, 0.02], "inertia": [1e-4, 7e-4, 7e-4], "points": { "A": [0, 0, 0], "B": [0.1, 0, 0.05] } },
    "coupler": { "mass": 1.5, "com": [0.25, 0.02, 0.16], "inertia": [0.006, 0.021, 0.016], "points": { "B": [0.1, 0, 0.05], "C": [0.42, 0, 0.25] } },
    "rocker": { "mass": 1.1, "com": [0.41, -0.02, 0.12], "inertia": [0.006, 0.006, 2e-4], "points": { "D": [0.4, 0, 0], "C": [0.42, 0, 0.25] } } },
    "joints": { )" +
         pin("crank", "ground.A", "crank.A") + ", " + pin("knee", "crank.B", "coupler.B") + ", " +
         pin("rocker", "ground.D", "rocker.D") + ", " + pin("tip", "coupler.C", "rocker.C") + R"( },
    "outputs": { )" +
         outputs + " } }";
}

TEST(SharedLoads, OfAPlaneMechanismAreThoseOutOfItsPlane) {
  const std::string in_plane =
      R"("fx": { "reaction": "knee", "axis": "x" }, "fz": { "reaction": "rocker", "axis": "z" },
    "angle": { "joint": "crank" })";
  const std::string all = in_plane + R"(, "fy": { "reaction": "knee", "axis": "y" },
    "mx": { "reaction": "rocker", "quantity": "moment", "axis": "x" },
    "my": { "reaction": "rocker", "quantity": "moment", "axis": "y" })";
  const Mechanism m = mechanism(four_bar("tip", all));
  EXPECT_EQ(different(m, mechanism(four_bar("rocker", all))), "fy mx");
  EXPECT_EQ(last_note(m),
            "3 equations of loop \"tip\" repeat others: how \"crank\", \"knee\", \"rocker\" and \"tip\" share the load "
            "follows from the choice of equations, and with it outputs fy and mx");
  EXPECT_EQ(last_note(mechanism(four_bar("tip", in_plane))), "");
  EXPECT_EQ(last_note(mechanism(four_bar("tip", R"("angle": { "joint": "crank" })"))), "");
}

/// A door of 20 kg on hinges one above the other; load: of a friction.
std::string door(const std::string& more) {
  const auto hinge = [](const std::string& name) {
    return fmt::format(R"("{0}": {{ "type": "revolute", "from": "ground.{0}", "to": "door.{0}", "axis": "z" }})", name);
  };
  const std::string points = R"("low": [0, 0, 0], "middle": [0, 0, 1], "high": [0, 0, 2])";
  return R"({ "mbgen": 1, "bodies": { "ground": { "points": { )" + points + R"( } },
    "door": { "mass": 20, "com": [0.5, 0, 1], "inertia": [7, 8, 2], "points": { )" +
         points + R"( } } },
    "joints": { )" +
         hinge("low") + ", " + hinge("middle") + ", " + hinge("high") + " }, " + more + " }";
}

TEST(SharedLoads, OfThreeHingesAndOfTheFrictionThatTheyPress) {
  const Mechanism m =
      mechanism(door(R"("outputs": { "turning": { "reaction": "low", "quantity": "moment", "axis": "z" },
    "force": { "reaction": "high", "axis": "x" } },
    "frictions": { "pin": { "joint": "low", "reaction": "low", "coulomb": 0.001, "velocity": 0.05 } })"));
  EXPECT_EQ(analysis_notes(m.model, m.topology, m.analysis).size(), 3u);
  EXPECT_EQ(last_note(m),
            "10 equations of loops \"middle\", \"high\" repeat others: how \"low\", \"middle\" and \"high\" share "
            "the load follows from the choice of equations, and with it output force and friction pin");
}

/// Three wheels of which each turns each other one: one mesh is one too many.
TEST(SharedLoads, OfGearsThatAreDoubled) {
  const auto gears = [](const std::vector<std::string>& meshes) {
    const std::map<std::string, std::string> relations = {
        {"ab", "z.a + 2*z.b"}, {"bc", "z.b + 3*z.c"}, {"ac", "z.a - 6*z.c"}};
    std::string bodies, joints, couplings, outputs, points;
    for (const std::string name : {"a", "b", "c"}) {
      const std::string at = fmt::format(R"("{0}": [{1}, 0, 0])", name, name[0] - 'a');
      points += (points.empty() ? "" : ", ") + at;
      bodies += fmt::format(R"(, "{0}": {{ "mass": 1, "inertia": [1, 1, 1], "points": {{ {1} }} }})", name, at);
      joints += fmt::format(R"({0}"{1}": {{ "type": "revolute", "from": "ground.{1}", "to": "{1}.{1}", "axis": "y" }})",
                            joints.empty() ? "" : ", ", name);
    }
    for (const std::string& mesh : meshes) {
      couplings +=
          fmt::format(R"({}"{}": {{ "relation": "{}" }})", couplings.empty() ? "" : ", ", mesh, relations.at(mesh));
      outputs += fmt::format(R"("{0}": {{ "multiplier": "{0}" }}, )", mesh);
    }
    return mechanism(R"({ "mbgen": 1, "bodies": { "ground": { "points": { )" + points + " } }" + bodies +
                     R"( }, "joints": { )" + joints + R"( }, "couplings": { )" + couplings + R"( },
      "joint_forces": { "drive": { "joint": "a", "force": 5 } },
      "outputs": { )" +
                     outputs + R"("fz": { "reaction": "a", "axis": "z" } } })");
  };
  const Mechanism m = gears({"ab", "bc", "ac"});
  EXPECT_EQ(different(gears({"ab", "ac"}), gears({"ab", "bc"})), "ab");
  EXPECT_EQ(different(gears({"bc", "ac"}), gears({"ab", "bc"})), "bc");
  EXPECT_EQ(different(gears({"ab", "ac"}), gears({"bc", "ac"})), "ac");
  EXPECT_EQ(last_note(m),
            "1 equation of loops \"ab\", \"bc\", \"ac\" repeats others: how the load is divided follows from the "
            "choice of equations, and with it outputs ab, bc and ac");
}

}  // namespace
}  // namespace mbgen
