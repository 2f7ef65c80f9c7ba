// Wraps of ropes, and belts, against closed forms.

#include <array>
#include <cmath>
#include <numbers>

#include "tests/support/ropes_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A body A in free translation, and a rope from it over an obstacle at the origin to a point B of ground, 1 N taut.
std::string over_obstacle(const std::array<double, 3>& a, const std::array<double, 3>& b, const std::string& obstacle) {
  return fmt::format(R"({{ "mbgen": 1, "name": "over", "gravity": [0, 0, 0],
    "bodies": {{ "ground": {{ "points": {{ "O": [0, 0, 0], "A": [{0:.17g}, {1:.17g}, {2:.17g}],
                                           "B": [{3:.17g}, {4:.17g}, {5:.17g}] }} }},
      "a": {{ "mass": 1, "inertia": [1, 1, 1], "pose": {{ "origin": [{0:.17g}, {1:.17g}, {2:.17g}] }},
              "points": {{ "O": [0, 0, 0] }} }} }},
    "joints": {{ "a": {{ "type": "free", "from": "ground.A", "to": "a.O" }} }},
    "ropes": {{ "rope": {{ "path": [{{ "point": "a.O" }}, {6}, {{ "point": "ground.B" }}], "EA": 1e6, "pretension": 1 }} }} }})",
                     a[0], a[1], a[2], b[0], b[1], b[2], obstacle);
}

// Its end is pulled along the line to the tangent point.
TEST(Ropes, WrapOnACircle) {
  for (const Json& row : rope_reference()["wrap_on_a_circle"]["cases"]) {
    const double radius = row["radius"], cx = row["centre"][0], cy = row["centre"][1];
    for (const char* kind : {"pulley", "cylinder"}) {
      Roped m(over_obstacle(
          {double(row["A"][0]) - cx, double(row["A"][1]) - cy, 0},
          {double(row["B"][0]) - cx, double(row["B"][1]) - cy, 0},
          fmt::format(R"({{ "{}": "ground.O", "axis": "z", "radius": {:.17g}, "sense": "negative" }})", kind, radius)));
      EXPECT_NEAR(m.shown(length), double(row["length"]), 1e-12) << kind;
      EXPECT_NEAR(m.shown(wrap), double(row["wrap_angle"]), 1e-12) << kind;
      EXPECT_NEAR(m.shown(tension), 1, 1e-8);
      m.accelerate();
      EXPECT_NEAR(-m.zdd("a_tx"), double(row["dL_dA"][0]), 1e-8) << kind;
      EXPECT_NEAR(-m.zdd("a_ty"), double(row["dL_dA"][1]), 1e-8) << kind;
      const auto& model_rope = m.model().ropes[0];
      if (std::string(kind) == "cylinder") continue;
      for (const auto& [at, key] : {std::pair{model_rope.path[1].meets, "tangent_point_A"},
                                    std::pair{model_rope.path[1].parts, "tangent_point_B"}}) {
        EXPECT_NEAR(at[0] + cx, double(row[key][0]), 1e-11);
        EXPECT_NEAR(at[1] + cy, double(row[key][1]), 1e-11);
      }
    }
  }
}

std::array<double, 3> three(const Json& values) { return {values[0], values[1], values[2]}; }

/// The end's acceleration against the unit vector from a tangent point.
void expect_pull(Roped& m, const std::array<double, 3>& a, const std::array<double, 3>& tangent) {
  m.accelerate();
  const double gap[] = {tangent[0] - a[0], tangent[1] - a[1], tangent[2] - a[2]};
  const double distance = std::hypot(gap[0], gap[1], gap[2]);
  const char* names[] = {"a_tx", "a_ty", "a_tz"};
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(m.zdd(names[i]), gap[i] / distance, 1e-8);
}

TEST(Ropes, WrapOnACylinder) {
  for (const Json& row : rope_reference()["wrap_on_a_cylinder"]["cases"]) {
    const auto a = three(row["A"]), b = three(row["B"]);
    Roped m(over_obstacle(a, b,
                          fmt::format(R"({{ "cylinder": "ground.O", "axis": "z", "radius": {}, "sense": "negative" }})",
                                      double(row["radius"]))));
    EXPECT_NEAR(m.shown(length), double(row["length"]), 1e-12);
    expect_pull(m, a, three(row["tangent_A"]));
  }
}

// The sphere of the reference is not touched: its bracket is negative. A larger one is.
TEST(Ropes, WrapOnASphere) {
  const Json& row = rope_reference()["wrap_on_a_sphere"];
  const auto a = three(row["A"]), b = three(row["B"]);
  const auto text = [&](double radius) {
    return over_obstacle(a, b, fmt::format(R"({{ "sphere": "ground.O", "radius": {} }})", radius));
  };
  Roped beside(text(row["radius"]));
  EXPECT_NEAR(beside.shown(length), double(row["length"]), 1e-12);
  EXPECT_NEAR(beside.shown(length), double(row["straight"]), 1e-12);
  EXPECT_EQ(beside.shown(wrap), 0);
  expect_pull(beside, a, b);
  const double r = 0.5, A = std::hypot(a[0], a[1], a[2]), B = std::hypot(b[0], b[1], b[2]);
  const double between = std::acos((a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / (A * B));
  const double arc = between - std::acos(r / A) - std::acos(r / B);
  ASSERT_GT(arc, 0);
  Roped over(text(r));
  EXPECT_NEAR(over.shown(length), std::sqrt(A * A - r * r) + std::sqrt(B * B - r * r) + r * arc, 1e-12);
  EXPECT_NEAR(over.shown(wrap), arc, 1e-12);
}

std::string belt(const std::string& first, const std::string& second, bool crossed, const std::string& law,
                 double j1 = 1, double j2 = 1) {
  const Json& row = rope_reference()["belt"];
  return plane_model({{"one", "turn", 1, 0, 0, j1}, {"two", "turn", 1, row["distance"], 0, j2}}, R"("A": [0, 0, 0])",
                     ropes(rope({circle("one.O", row["R1"], true, first), circle("two.O", row["R2"], !crossed, second)},
                                R"("closed": true, )" + law)),
                     0);
}

TEST(Belts, AreAsLongAsTheirPulleysAsk) {
  const Json& row = rope_reference()["belt"];
  for (const bool crossed : {false, true}) {
    Roped slides(belt("", "", crossed, R"("EA": 1e5)"));
    EXPECT_NEAR(slides.shown(length), double(row[crossed ? "crossed_length" : "open_length"]), 1e-12);
    const double wraps =
        crossed ? 2 * double(row["crossed_wrap"]) : double(row["open_wraps"][0]) + double(row["open_wraps"][1]);
    EXPECT_NEAR(slides.shown(wrap), wraps, 1e-12);
    const std::string grips = R"(, "contact": "grips")";
    Roped spans(belt(grips, grips, crossed, R"("EA": 1e5)"));
    EXPECT_NEAR(spans.shown(wrap, 0), crossed ? double(row["crossed_wrap"]) : double(row["open_wraps"][1]), 1e-12);
    EXPECT_NEAR(spans.shown(wrap, 1), crossed ? double(row["crossed_wrap"]) : double(row["open_wraps"][0]), 1e-12);
    // A belt that is 1 % too short has that strain; its spans share it.
    const double whole = row[crossed ? "crossed_length" : "open_length"];
    Roped tight(belt(grips, grips, crossed, fmt::format(R"("EA": 1e5, "free_length": {:.17g})", whole / 1.01)));
    EXPECT_NEAR(tight.shown(tension, 0), 1e3, 1e-8);
    EXPECT_NEAR(tight.shown(tension, 1), 1e3, 1e-8);
  }
}

TEST(Belts, OscillateAtTheFrequencyOfTwoPulleys) {
  const Json& row = rope_reference()["belt"]["two_pulleys"];
  const std::string grips = R"(, "contact": "grips")";
  double trace = 0;
  for (const char* wheel : {"one", "two"}) {
    Roped m(belt(grips, grips, false, fmt::format(R"("stiffness": {}, "pretension": 400)", double(row["k"])), row["J1"],
                 row["J2"]));
    m.set(wheel, 1e-3, 0);
    m.accelerate();
    trace -= m.zdd(wheel) / 1e-3;
  }
  EXPECT_NEAR(std::sqrt(trace), double(row["omega"]), 1e-9 * double(row["omega"]));
  Roped turned(belt(grips, grips, false, R"("stiffness": 4e4, "pretension": 400)"));
  turned.set("one", 300, 0);  // many turns of both: the second frequency is zero
  turned.set("two", 100, 0);
  turned.accelerate();
  EXPECT_NEAR(turned.zdd("one"), 0, 1e-6);
}

TEST(Belts, SlipAtTheLimitOfFriction) {
  const Json& row = rope_reference()["belt"]["friction_limit"];
  const double mu = row["mu"], f0 = row["F0"], limit = row["M"];
  const auto text = [&](const char* motion) {
    std::string model = belt(fmt::format(R"(, "friction": {})", mu), R"(, "contact": "grips")", false,
                             fmt::format(R"("stiffness": 2e4, "pretension": {}, "damping": 1e-3)", f0), 0.002, 0.05);
    model.pop_back();
    return model + fmt::format(R"(, "motions": {{ "two": {{ "joint": "two", "angle": 0 }}{} }} }})", motion);
  };
  Roped drawn(text(R"(, "one": { "joint": "one", "angle": "2*t" })"));
  drawn.run(0.5, 1e-3);
  const double difference = std::abs(drawn.shown(tension, 0) - drawn.shown(tension, 1));
  EXPECT_NEAR(difference * double(rope_reference()["belt"]["R1"]), limit, 1e-6 * limit);
  EXPECT_NEAR(drawn.shown(tension, 0) + drawn.shown(tension, 1), 2 * f0, 1e-6);
  for (const double share : {0.97, 1.03}) {
    std::string model = text("");
    model.pop_back();
    Roped m(model + fmt::format(R"x(, "joint_forces": {{ "push": {{ "joint": "one",
        "force": "{:.17g}*min(1, t/0.1)" }} }} }})x",
                                share * limit));
    m.run(0.3, 2e-4);
    EXPECT_EQ(std::abs(m.zd("one")) > 1, share > 1) << share;
  }
}

}  // namespace
}  // namespace mbgen
