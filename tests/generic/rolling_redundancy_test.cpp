// Rolling rows that repeat rows of positions: balls and discs that are guided, in closed form.

#include <Eigen/Dense>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>

#include "compiler/reader/read_model.hpp"
#include "runtime/judges/cartesian.hpp"
#include "tests/support/dynamics.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using nlohmann::json;

/// MBGEN_ROLLING_CASES: models of each family.
int cases() {
  const char* text = std::getenv("MBGEN_ROLLING_CASES");
  return text == nullptr ? 60 : std::atoi(text);
}

/// Numbers of one body.
class Chance {
 public:
  explicit Chance(int seed) : random_(static_cast<std::uint64_t>(seed)) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vector3d vector(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }
  Vector3d direction() {
    for (;;)
      if (const Vector3d v = vector(1); v.norm() > 0.2) return v.normalized();
  }

 private:
  std::mt19937_64 random_;
};

json numbers(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// A body that turns about an axis `about` while its point C goes along with the turn: C' = way per rad.
struct Guided {
  Vector3d gravity, place, com, about, way;
  Matrix3d axes;
  double mass = 0;
  Vector3d inertia;

  /// Acceleration of the turn from rest, by virtual work.
  double turn_from_rest() const {
    const Vector3d arm = axes * com, rate = way + about.cross(arm);
    const Matrix3d about_com = axes * inertia.asDiagonal() * axes.transpose();
    return mass * gravity.dot(rate) / (mass * rate.squaredNorm() + about.dot(about_com * about));
  }
};

Guided random_guided_body(Chance& chance) {
  Guided body;
  body.gravity = {1, 0.3, -9};
  body.place = chance.vector(1);
  body.com = chance.vector(0.2);
  body.axes = Eigen::AngleAxisd(chance.between(-3, 3), chance.direction()).toRotationMatrix();
  body.mass = chance.between(0.5, 4);
  body.inertia = Vector3d(0.3, 0.4, 0.5) + chance.vector(0.05);
  return body;
}

/// Free, with a point C at the origin of the body; joints: what guides it.
json guided_model(const Guided& body, json ground, json joints) {
  const Eigen::AngleAxisd turn(body.axes);
  ground["C"] = numbers(body.place);
  joints["f"] = {{"type", "free"}, {"from", "ground.C"}, {"to", "b.C"}};
  return {
      {"mbgen", 1},
      {"gravity", numbers(body.gravity)},
      {"bodies",
       {{"ground", {{"points", ground}}},
        {"b",
         {{"mass", body.mass},
          {"com", numbers(body.com)},
          {"inertia", numbers(body.inertia)},
          {"pose",
           {{"origin", numbers(body.place)}, {"rotation", {{"axis", numbers(turn.axis())}, {"angle", turn.angle()}}}}},
          {"points", {{"C", {0, 0, 0}}}}}}}},
      {"joints", joints}};
}

/// From rest, the turn has the acceleration of the closed form, the judges find the same, and rolling goes on closed.
void expect_turn(const Guided& body, const json& model, const std::string& seed) {
  const Result<Model> read = read_model(model.dump(), "guided.json");
  ASSERT_TRUE(read) << to_text(read.problems());
  ASSERT_TRUE(analysis_problems(*read).empty()) << seed << to_text(analysis_problems(*read)) << model.dump();
  const Mechanism m = analysed(read);
  EXPECT_EQ(m.analysis.degrees_of_freedom, 1) << seed;
  for (const BlockAnalysis& block : m.analysis.blocks)
    for (const std::string& name : block.redundant_names)
      EXPECT_NE(name, "guide.plane") << seed << ": rows of positions stay";
  const GenericSolver solver(m.model, m.topology, m.analysis);
  GenericState state = reference_state(m);
  const std::vector<double> no_tau(state.z.size(), 0.0);
  GenericDerivative expected, other;
  ASSERT_TRUE(solver.accelerations(state, no_tau, expected).ok()) << seed;
  const auto of = [&](const char* name) {
    return expected.zdd[static_cast<std::size_t>(find_coordinate(m.topology, name))];
  };
  const Vector3d linear(of("f_tx"), of("f_ty"), of("f_tz"));
  const Vector3d wanted = body.turn_from_rest() * body.way;  // in the axes of the plane of ground
  EXPECT_LT((linear - wanted).norm(), 1e-9 * (1 + wanted.norm())) << seed << " " << linear.transpose();
  for (const CartesianMethod method : {CartesianMethod::augmented, CartesianMethod::maggi}) {
    const CartesianSolver judge(m.model, m.topology, method, Stabilisation::projection);
    ASSERT_TRUE(judge.accelerations(state, no_tau, other).ok()) << seed;
    for (std::size_t i = 0; i < other.zdd.size(); ++i)
      EXPECT_NEAR(other.zdd[i], expected.zdd[i], 1e-8 * (1 + std::abs(expected.zdd[i]))) << seed;
    GenericState open = state;
    for (double& z : open.z) z += 1e-3;
    EXPECT_TRUE(judge.project(open).ok()) << seed << ": a judge closes it, too";
  }
  const Dynamics dynamics{solver};
  for (int k = 0; k < 100; ++k) ASSERT_TRUE(step_rk4(dynamics, state, 2e-3).ok()) << seed << " step " << k;
  for (const double open : solver.position_residuals(state)) EXPECT_LT(std::abs(open), 1e-11) << seed;
  for (const double slip : solver.velocity_residuals(state)) EXPECT_LT(std::abs(slip), 1e-10) << seed;
}

/// A ball on a plane, whose centre a plane and whose turn the same plane guide: one joint, or two.
json guided_ball(Chance& chance, bool is_one_joint, Guided& body) {
  body = random_guided_body(chance);
  Vector3d plane, guide;
  do plane = chance.direction(), guide = chance.direction();
  while (plane.cross(guide).norm() < 0.3);
  const double radius = chance.between(0.1, 0.4);
  body.about = guide;
  body.way = guide.cross(radius * plane);
  const Vector3d contact = body.place - radius * plane + plane.cross(chance.vector(0.5));
  json joints = {
      {"roll",
       {{"type", "rolling_ball"}, {"from", "ground.a"}, {"to", "b.C"}, {"axis", numbers(plane)}, {"radius", radius}}}};
  const json axis = numbers(guide);
  if (is_one_joint) {
    joints["guide"] = {{"type", "planar"}, {"from", "ground.C"}, {"to", "b.C"}, {"axis", axis}, {"cut", true}};
  } else {
    joints["guide"] = {{"type", "point_on_plane"}, {"from", "ground.C"}, {"to", "b.C"}, {"axis", axis}};
    joints["turn"] = {{"type", "parallel_axes"}, {"from", "ground.C"}, {"to", "b.C"}, {"axis", axis}};
  }
  return guided_model(body, {{"a", numbers(contact)}}, joints);
}

TEST(RollingBesidePositions, BallsInAPlaneTurnAsVirtualWorkSays) {
  for (int seed = 1; seed <= cases(); ++seed) {
    Chance chance(seed);
    Guided body;
    const json model = guided_ball(chance, seed % 2 == 0, body);
    expect_turn(body, model, "ball " + std::to_string(seed));
  }
}

TEST(RollingBesidePositions, LeaningDiscsRollStraightOn) {
  for (int seed = 1; seed <= cases(); ++seed) {
    Chance chance(seed);
    Guided body = random_guided_body(chance);
    const double lean = -1.1 + 2.2 * (seed % 12) / 11, radius = chance.between(0.1, 0.4);
    const Vector3d plane = seed <= 12 ? Vector3d(0, 0, 1) : chance.direction();
    const Vector3d level = plane.cross(chance.direction()).normalized();
    const Vector3d axle = std::cos(lean) * level + std::sin(lean) * plane;
    const Vector3d up = (plane - plane.dot(axle) * axle).normalized();
    body.about = axle;
    body.way = axle.cross(radius * up);
    const json joints = {
        {"guide", {{"type", "planar"}, {"from", "ground.C"}, {"to", "b.C"}, {"axis", numbers(axle)}, {"cut", true}}},
        {"roll",
         {{"type", "rolling_disc"},
          {"from", "ground.q"},
          {"to", "b.C"},
          {"axis", numbers(plane)},
          {"axis2", numbers(axle)},
          {"radius", radius}}}};
    expect_turn(body, guided_model(body, {{"q", numbers(body.place - radius * up)}}, joints),
                "disc " + std::to_string(seed));
  }
}

TEST(RollingBesidePositions, AHeldBallHasNothingLeftToRoll) {
  Chance chance(7);
  const Guided body = random_guided_body(chance);
  const json joints = {
      {"hold", {{"type", "fixed"}, {"from", "ground.C"}, {"to", "b.C"}, {"cut", true}}},
      {"roll", {{"type", "rolling_ball"}, {"from", "ground.a"}, {"to", "b.C"}, {"axis", "z"}, {"radius", 0.2}}}};
  const json model = guided_model(body, {{"a", numbers(body.place - Vector3d(0, 0, 0.2))}}, joints);
  const Mechanism m = analysed(read_model(model.dump(), "held.json"));
  EXPECT_EQ(m.analysis.degrees_of_freedom, 0);
  for (const std::string& name : m.analysis.blocks[0].redundant_names) EXPECT_EQ(name.substr(0, 5), "roll.") << name;
}

}  // namespace
}  // namespace mbgen
