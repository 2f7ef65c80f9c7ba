// Starts at positions that are singular on the whole branch: the same is said of each.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "compiler/analysis/notes.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
using nlohmann::json;

/// Two straight-line linkages of J. Scott Russell, mirror images 1.1 m apart, whose tips, each on its own vertical, a
/// bar holds at that distance: it says nothing of the first bit of a difference in height, at any angle.
json scott_russell(double degrees) {
  const double angle = degrees * std::numbers::pi / 180, x = 0.8 * std::cos(angle), z = 0.8 * std::sin(angle);
  json points, bodies = {{"ground", json::object()}}, joints;
  const auto add_joint = [&](const std::string& name, const char* type, const std::string& from, const std::string& to,
                             const std::string& at) {
    joints[name] = {{"type", type},
                    {"from", from + "." + at},
                    {"to", to + "." + at},
                    {"axis", std::string(type) == "prismatic" ? "x" : "y"}};
  };
  points["PM"] = {0.55, 0, z};
  bodies["plat"] = {{"mass", 10}, {"inertia", {0.1, 1, 1}}, {"pose", {{"origin", "PM"}}}};
  for (const auto& [n, base, side] : {std::tuple{"1", 0.0, 1.0}, std::tuple{"2", 1.1, -1.0}}) {
    const std::string s = n;
    points["O" + s] = {base, 0, 0};
    points["A" + s] = {base + side * x, 0, 0};
    points["B" + s] = {base, 0, z};
    points["C" + s] = {base + side * x / 2, 0, z / 2};
    for (const auto& [body, at, mass] :
         {std::tuple{"bar", "C", 3.0}, std::tuple{"link", "O", 1.0}, std::tuple{"foot", "A", 0.5}})
      bodies[body + s] = {{"mass", mass}, {"inertia", {0.1, 0.1, 0.1}}, {"pose", {{"origin", at + s}}}};
    add_joint("foot" + s, "prismatic", "ground", "foot" + s, "A" + s);
    add_joint("a" + s, "revolute", "foot" + s, "bar" + s, "A" + s);
    add_joint("o" + s, "revolute", "ground", "link" + s, "O" + s);
    add_joint("c" + s, "revolute", "link" + s, "bar" + s, "C" + s);
    add_joint("p" + s, "revolute", "bar" + s, "plat", "B" + s);
  }
  return {{"mbgen", 1}, {"hardpoints", points}, {"bodies", bodies}, {"joints", joints}};
}

TEST(SingularStart, IsCalledSoAtEveryAngle) {
  for (double degrees = 12.7; degrees < 80; degrees += 3.1) {
    const Result<Model> model = read_model(scott_russell(degrees).dump(), "scott_russell.json");
    ASSERT_TRUE(model) << to_text(model.problems());
    const Diagnostics problems = analysis_problems(*model);
    ASSERT_EQ(problems.size(), 1u) << degrees;
    EXPECT_NE(problems[0].message.find("is singular: its equations hinder all but the first motion"), std::string::npos)
        << degrees << ": " << problems[0].message;
  }
}

/// Two bodies that turn, related; the only note.
std::string note_of_relation(const std::string& relation) {
  const json body = {{"mass", 1}, {"inertia", {1, 1, 1}}, {"points", {{"o", {0, 0, 0}}}}};
  json joints;
  for (const std::string one : {"a", "b"})
    joints["j" + one] = {{"type", "revolute"}, {"from", "ground.o"}, {"to", one + ".o"}, {"axis", "y"}};
  const json model = {{"mbgen", 1},
                      {"bodies", {{"ground", {{"points", {{"o", {0, 0, 0}}}}}}, {"a", body}, {"b", body}}},
                      {"joints", joints},
                      {"couplings", {{"cam", {{"relation", relation}}}}}};
  const Mechanism m = mechanism_of(model.dump());
  const Diagnostics notes = analysis_notes(m.model, m.topology, m.analysis);
  return notes.size() == 1 ? notes[0].message : fmt::format("{} notes", notes.size());
}

/// A cam of a radius of 1e-3 closes within 1e-3 rad of its dead point, at the reference; a gear of 1e-7 moves a little;
/// a cam behind a stop moves from 3 rad on: none of them never moves.
TEST(SingularStart, NoCoordinateIsSaidNeverToMoveThatMoves) {
  EXPECT_EQ(
      note_of_relation("z.jb - sqrt(1e-6 - z.ja^2) + 1e-3"),
      "coordinate jb does not begin to move at the reference, the only configuration in which loop \"cam\" was seen "
      "to close");
  for (const char* relation : {"z.jb - 1e-7*z.ja", "z.jb - max(0, z.ja - 3)"})
    EXPECT_EQ(
        note_of_relation(relation),
        "coordinate jb moves by less than 1e-6 of the motion of loop \"cam\" in each of 25 closed configurations");
  EXPECT_EQ(note_of_relation("z.jb - z.ja^2"), "0 notes");
}

}  // namespace
}  // namespace mbgen
