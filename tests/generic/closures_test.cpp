// Joints that are equations only, against closed forms: linkages that draw lines, shafts at an angle, statics.

#include <cmath>
#include <complex>
#include <fstream>
#include <iterator>

#include "tests/support/reaction_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
using Complex = std::complex<double>;

constexpr double kClosed = 1e-12;  // m, of closures whose residuals are at rounding

/// A mechanism whose joint turns by t, and one state.
struct Bench {
  Mechanism m;
  GenericSolver solver{m.model, m.topology, m.analysis};
  GenericState state = reference_state(m);

  Bench(Model model, const std::string& joint) : m(analysed(driven(std::move(model), joint))) {}
  double z(const std::string& name) const { return state.z[find_coordinate(m.topology, name)]; }
  double zd(const std::string& name) const { return state.zd[find_coordinate(m.topology, name)]; }
  /// To an angle of the driven joint, in moves of 0.02 rad; everything else follows.
  void turn(double to) {
    const double from = state.t;
    const int moves = 1 + static_cast<int>(std::abs(to - from) / 0.02);
    for (int k = 1; k <= moves; ++k) {
      state.t = from + (to - from) * k / moves;
      ASSERT_TRUE(solver.project(state).ok()) << state.t;
    }
  }
  std::vector<double> outputs() { return outputs_at(solver, state, std::vector<double>(state.z.size(), 0.0)); }

 private:
  static Model driven(Model model, const std::string& joint) {
    ExpressionNode time;
    time.kind = ExpressionNode::Kind::time;
    Motion motion;
    motion.name = "drive";
    motion.joint = {index_of(model.joints, joint), 0};
    motion.position.expression = static_cast<int>(model.expressions.size());
    model.expressions.push_back({"t", {time}});
    model.motions.push_back(motion);
    return model;
  }
};

/// The text of a file with more elements at the start of a section.
std::string with_more(std::string text, const std::string& section, const std::string& elements) {
  const std::string start = "\"" + section + "\": {";
  const std::size_t place = text.find(start);
  return text.insert(place + start.size(), elements);
}

// The inversion of a line is a circle through its centre: O, C and D are in line, |OC| |OD| = L^2 - s^2 = 0.12 m^2, and
// C is 0.1 m from Q. So a crank from Q to C takes no freedom away, be D held or not.
TEST(Peaucellier, TurnsALineIntoACircle) {
  std::ifstream file(source_path("models/peaucellier.json"));
  const std::string cell{std::istreambuf_iterator<char>(file), {}};
  std::string cranked = with_more(cell, "bodies", R"(
      "crank": { "mass": 1, "inertia": [1, 1, 1], "points": { "Q": [0.1, 0, 0], "C": [0.2, 0, 0] } },)");
  cranked = with_more(cranked, "joints", R"(
      "crank": { "type": "revolute", "from": "ground.Q", "to": "crank.Q", "axis": "y" },
      "crank_C": { "type": "revolute", "from": "crank.C", "to": "top_near.C", "axis": "y", "cut": true },)");
  for (const std::string& text : {cell, cranked}) {
    Bench bench(model_of(text), "long_top");
    EXPECT_EQ(bench.m.analysis.degrees_of_freedom, 1);
    double way = 0;
    for (const double angle : {-0.2, -0.1, 0.0, 0.1, 0.3}) {
      bench.turn(angle);
      const std::vector<double> y = bench.outputs();
      const Complex d(y[0], y[1]), c(y[2], y[3]);
      EXPECT_NEAR(d.real(), 0.6, kClosed);
      EXPECT_NEAR(std::abs(c * std::conj(d) - 0.12), 0, kClosed) << "in line, and inverse";
      EXPECT_NEAR(std::abs(c - 0.1), 0.1, kClosed);
      way = std::max(way, std::abs(d.imag()));
    }
    EXPECT_GT(way, 0.1);
  }
}

// P on its line; A, P and B by intersecting circles. B is 0.52 m from the point right in two of them.
TEST(Roberts, OtherWayRoundIsTheIntersectionOfCircles) {
  Bench bench(load("models/roberts.json").model, "rocker");
  EXPECT_EQ(bench.m.analysis.degrees_of_freedom, 1);
  const double radius = 0.52;
  const Complex left(-0.4, 0), right(0.4, 0);
  for (const double angle : {-0.28, -0.2, 0.0, 0.15, 0.4}) {
    bench.turn(angle);
    const std::vector<double> y = bench.outputs();
    const double along = y[0];
    EXPECT_NEAR(y[1], 0, kClosed);
    // A above the middle of left and P; B is P plus A less P, turned by the angle at the top of the triangle.
    const Complex p(along, 0), half = (p - left) / 2.0;
    const Complex a = left + half + Complex(0, std::sqrt(radius * radius - std::norm(half)));
    const Complex b = p + (a - p) * std::polar(1.0, -2 * std::asin(0.2 / radius));
    EXPECT_NEAR(y[2], b.real(), kClosed);
    EXPECT_NEAR(y[3], b.imag(), kClosed);
    // Positive turns about y go from z to x.
    EXPECT_NEAR(angle, std::arg(Complex(0.2, 0.48)) - std::arg(a - left), kClosed);
  }
  // P in the middle, and P in right.
  for (const double angle : {0.0, std::atan2(0.48, 0.2) - std::acos(0.4 / radius)}) {
    bench.turn(angle);
    const std::vector<double> y = bench.outputs();
    EXPECT_NEAR(std::abs(Complex(y[2], y[3]) - right), radius, kClosed);
  }
}

const double kBend = std::atan2(0.5, 1.0);  // rad, of the shafts below

/// Two shafts in ground that meet at an angle; the joint between them closes the loop.
std::string shafts(const std::string& joint) {
  return R"({ "mbgen": 1, "gravity": [0, 0, 0], "bodies": {
      "ground": { "points": { "O": [0, 0, 0] } },
      "driver": { "mass": 1, "inertia": [0.3, 0.2, 0.2], "points": { "O": [0, 0, 0] } },
      "driven": { "mass": 1, "inertia": [0.5, 0.5, 0.5], "points": { "O": [0, 0, 0] } } },
    "joints": {
      "driver": { "type": "revolute", "from": "ground.O", "to": "driver.O", "axis": "x" },
      "driven": { "type": "revolute", "from": "ground.O", "to": "driven.O", "axis": [1, 0.5, 0] },
      "joint": { "type": )" +
         joint + R"(, "from": "driver.O", "to": "driven.O" } },
    "outputs": { "mx": { "reaction": "joint", "quantity": "moment", "axis": "x" },
      "my": { "reaction": "joint", "quantity": "moment", "axis": "y" },
      "mz": { "reaction": "joint", "quantity": "moment", "axis": "z" } } })";
}

TEST(Shafts, HomokineticJointKeepsTheSpeedAndCardansDoesNot) {
  Bench constant(model_of(shafts(R"("homokinetic", "axis": "x", "axis2": [1, 0.5, 0])")), "driver");
  Bench cardan(model_of(shafts(R"("universal", "axis": "y", "axis2": "z", "cut": true)")), "driver");
  EXPECT_EQ(constant.m.analysis.degrees_of_freedom, 1);
  EXPECT_EQ(cardan.m.analysis.degrees_of_freedom, 1);
  for (const double angle : {0.0, 0.7, 1.9, 3.5, 6.0}) {
    constant.turn(angle);
    cardan.turn(angle);
    EXPECT_NEAR(constant.z("driven"), angle, kClosed);
    EXPECT_NEAR(constant.zd("driven"), 1, kClosed);
    // The fork of the driver stands along y, in the plane of the shafts, at angle 0.
    const double part = std::sin(kBend) * std::cos(angle);
    EXPECT_NEAR(cardan.zd("driven"), std::cos(kBend) / (1 - part * part), kClosed) << angle;
  }
}

// A torque T on the driver: the joint gives it to the driven shaft as a moment half way between the shafts' axes, whose
// part along each of them is the same: I2 / (I1 + I2) of T.
TEST(Shafts, HomokineticJointGivesItsMomentAlongTheBisector) {
  const Mechanism m = mechanism_of(shafts(R"("homokinetic", "axis": "x", "axis2": [1, 0.5, 0])"));
  GenericState state = reference_state(m);
  state.z = {0.8, 0.8};
  std::vector<double> tau(state.z.size(), 0.0);
  tau[find_coordinate(m.topology, "driver")] = 16;
  const std::vector<double> y = outputs_at(GenericSolver(m.model, m.topology, m.analysis), state, tau);
  const double along_shafts = 16 * 0.5 / (0.3 + 0.5), size = along_shafts / std::cos(kBend / 2);
  expect_vector({y[0], y[1], y[2]}, {size * std::cos(kBend / 2), size * std::sin(kBend / 2), 0}, 1e-9, "moment");
}

// 100 N on a table of three feet on a plane: by levers 50, 30 and 20 N; it slides and turns on.
TEST(Table, FeetOnAPlaneCarryByLevers) {
  const Reading r = read_reactions(model_of(R"({ "mbgen": 1, "gravity": [0, 0, -10], "bodies": {
      "ground": { "points": { "O": [0, 0, 0], "P": [0.5, 0.6, 1] } },
      "table": { "mass": 10, "com": [0.6, 0.4, 1], "inertia": [1, 1, 1],
        "points": { "P": [0.5, 0.6, 1], "a": [0, 0, 0], "b": [2, 0, 0], "c": [0, 2, 0] } } },
    "joints": {
      "table": { "type": "free", "from": "ground.P", "to": "table.P" },
      "a": { "type": "point_on_plane", "from": "ground.O", "to": "table.a", "axis": "z" },
      "b": { "type": "point_on_plane", "from": "ground.O", "to": "table.b", "axis": "z" },
      "c": { "type": "point_on_plane", "from": "ground.O", "to": "table.c", "axis": "z" } } })"),
                                   {});
  expect_vector(r.force.at("a"), {0, 0, 50}, 1e-9, "a");
  expect_vector(r.force.at("b"), {0, 0, 30}, 1e-9, "b");
  expect_vector(r.force.at("c"), {0, 0, 20}, 1e-9, "c");
  expect_vector(r.moment.at("c"), {0, 0, 0}, 1e-9, "moment about the foot");
}

}  // namespace
}  // namespace mbgen
