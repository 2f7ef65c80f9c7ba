// The redundancy certificate, and which sets of equations are refused.

#include <algorithm>
#include <cmath>
#include <map>

#include "compiler/reader/read_model.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

constexpr double kDegree = 0.017453292519943295;  // rad

Mechanism made(const std::string& text) {
  const Result<Model> model = read_model(text, "made.json");
  if (!model) throw std::runtime_error(to_text(model.problems()));
  const Result<Topology> topology = build_topology(*model);
  if (!topology) throw std::runtime_error(to_text(topology.problems()));
  const Result<Analysis> analysis = analyse(*model, *topology);
  if (!analysis) throw std::runtime_error(to_text(analysis.problems()));
  return {*model, *topology, *analysis};
}

Model model_of(const std::string& path) {
  Result<Model> model = read_model_file(source_path(path));
  if (!model) throw std::runtime_error(to_text(model.problems()));
  return *model;
}

Joint& joint_named(Model& model, const std::string& name) {
  for (Joint& joint : model.joints)
    if (joint.name == name) return joint;
  throw std::runtime_error("no joint " + name);
}

/// Tilts a joint along y, pin or slide, towards x or out of its plane.
void tilt(Model& model, const std::string& name, double degrees) {
  Joint& joint = joint_named(model, name);
  const double s = std::sin(degrees * kDegree), c = std::cos(degrees * kDegree);
  joint.axis = joint.axis[1] == 1 ? Vector3{s, c, 0} : Vector3{c, s, 0};
  joint.freedoms[0].axis = joint.axis;
}

const Certificate& certificate(const Mechanism& m, std::size_t block = 0) {
  return m.analysis.blocks[block].certificate;
}

std::vector<std::pair<int, int>> counts(const std::vector<RankCount>& ranks) {
  std::vector<std::pair<int, int>> pairs;
  for (const RankCount& seen : ranks) pairs.emplace_back(seen.rank, seen.configurations);
  return pairs;
}

std::vector<std::string> never_moving(const Mechanism& m, std::size_t block = 0) {
  std::vector<std::string> names;
  for (int c : certificate(m, block).immobile)
    names.push_back(m.topology.bodies[m.topology.blocks[block].joints[c]].coordinate);
  return names;
}

/// A body with its points, at rest in the global frame.
std::string body(const std::string& name, const std::string& points) {
  return '"' + name + R"(": { "mass": 1, "com": [0, 0, 0], "inertia": [0.1, 0.1, 0.1], "points": { )" + points + " } }";
}

std::string revolute(const std::string& name, const std::string& from, const std::string& to, const std::string& axis,
                     const std::string& more = "") {
  return '"' + name + R"(": { "type": "revolute", "from": ")" + from + R"(", "to": ")" + to + R"(", "axis": )" + axis +
         more + " }";
}

/// Two bars from A and D, pinned together at T.
std::string truss(const std::string& a, const std::string& d, const std::string& t, const std::string& axis,
                  const std::string& tip_axis) {
  return R"({ "mbgen": 1, "name": "truss", "bodies": { "ground": { "points": { "A": )" + a + R"(, "D": )" + d +
         " } }, " + body("left", "\"A\": " + a + ", \"T\": " + t) + ", " +
         body("right", "\"D\": " + d + ", \"T\": " + t) + " }, \"joints\": { " +
         revolute("left_pin", "ground.A", "left.A", axis) + ", " + revolute("right_pin", "ground.D", "right.D", axis) +
         ", " + revolute("top", "left.T", "right.T", tip_axis, ", \"cut\": true") + " } }";
}

/// An arm on two hinges in line with the y axis.
std::string two_hinges(const std::string& second_axis) {
  return R"({ "mbgen": 1, "name": "flap", "bodies": { "ground": { "points": { "L": [0, 0, 0], "R": [0, 1, 0] } },
    "flap": { "mass": 2, "com": [0.3, 0.4, 0], "inertia": [0.1, 0.2, 0.3], "points": { "L": [0, 0, 0], "R": [0, 1, 0] } } },
    "joints": { )" +
         revolute("left", "ground.L", "flap.L", "\"y\"") + ", " +
         revolute("right", "ground.R", "flap.R", second_axis, ", \"cut\": true") + " } }";
}

TEST(Certificate, FourBarLosesWhatIsOutOfItsPlane) {
  const Mechanism m = load("models/four_bar.json");
  const Certificate& c = certificate(m);
  EXPECT_EQ(c.closed_configurations, 25);
  EXPECT_EQ(counts(c.ranks), (std::vector<std::pair<int, int>>{{2, 25}}));
  EXPECT_TRUE(c.singular.empty());
  EXPECT_GT(c.reach, 1.0);
  EXPECT_GT(c.smallest_kept, 0.1);
  EXPECT_LT(c.largest_dropped, 1e-15);
  EXPECT_EQ(c.degrees_of_freedom, 1);
  EXPECT_TRUE(c.immobile.empty());
  EXPECT_GE(c.steps, 20);
  const std::map<std::string, std::string> expected = {{"rocker_tip.y", "position along y"},
                                                       {"rocker_tip.axis_1", "axis tilt about x"},
                                                       {"rocker_tip.axis_2", "axis tilt about z"}};
  ASSERT_EQ(c.redundant.size(), expected.size());
  for (const RedundantEquation& equation : c.redundant) {
    EXPECT_EQ(equation.meaning, expected.at(equation.name));
    EXPECT_EQ(m.topology.loops[equation.loop].name, "rocker_tip");
    EXPECT_GE(equation.residual, 0);
    EXPECT_LT(equation.residual, 1e-14);  // the tree is planar by construction: only rounding of sines
  }
}

TEST(Certificate, DoubleLoopsLoseThreeEquationsEach) {
  for (const char* path : {"tests/data/models/double_loop.json", "models/iftomm/a02_n_four_bar_2.json"}) {
    const Mechanism m = load(path);
    EXPECT_EQ(certificate(m).redundant.size(), 6u) << path;
    EXPECT_EQ(certificate(m).degrees_of_freedom, 1) << path;
    EXPECT_EQ(certificate(m).ranks[0].rank, 4) << path;
    for (const RedundantEquation& equation : certificate(m).redundant) EXPECT_LT(equation.residual, 1e-12) << path;
  }
}

/// The bars of the N-four-bar line up at crank angles of a quarter turn; Newton's method is drawn there.
TEST(Certificate, NamesTheSingularConfigurationsThatItMet) {
  const Mechanism m = load("models/iftomm/a02_n_four_bar_2.json");
  ASSERT_FALSE(certificate(m).singular.empty());
  for (const SingularConfiguration& met : certificate(m).singular) {
    EXPECT_LT(met.rank, 4);
    for (std::size_t c = 0; c < met.z.size(); ++c) {
      const std::string& name = m.topology.bodies[m.topology.blocks[0].joints[c]].coordinate;
      if (name != "A1" && name != "A2") continue;
      EXPECT_NEAR(std::abs(std::remainder(met.z[c], std::acos(-1.0))), std::acos(0.0), 1e-3) << name;
    }
  }
}

/// IFToMM's benchmark counts 30 equations of rank 29 in Cartesian coordinates: the five tree joints take 25 of them.
TEST(Certificate, BricardHasOneRedundantEquationEverywhere) {
  const Mechanism m = load("models/iftomm/a04_bricard.json");
  const Certificate& c = certificate(m);
  EXPECT_EQ(5 * m.topology.size() + m.topology.blocks[0].equations, 30);
  EXPECT_EQ(5 * m.topology.size() + m.analysis.independent_equations, 29);
  ASSERT_EQ(c.redundant.size(), 1u);
  EXPECT_LT(c.redundant[0].residual, 1e-10);
  EXPECT_GE(c.steps, 20);
  EXPECT_GE(c.ranks[0].configurations, 20);
}

TEST(Certificate, TruckNamesItsElevenByJoint) {
  const Mechanism m = load("models/truck_mechanism.json");
  std::map<std::string, int> by_joint;
  for (const BlockAnalysis& block : m.analysis.blocks) {
    for (const RedundantEquation& equation : block.certificate.redundant) {
      ++by_joint[m.topology.loops[equation.loop].name];
      EXPECT_LT(equation.residual, 1e-12) << equation.name;
    }
    EXPECT_TRUE(block.certificate.immobile.empty());
  }
  EXPECT_EQ(by_joint, (std::map<std::string, int>{{"cab_upper_pivot", 3},
                                                  {"seat_pivot_left", 3},
                                                  {"seat_pivot_right", 3},
                                                  {"relay_ball", 1},
                                                  {"lift_ball", 1}}));
  ASSERT_EQ(m.analysis.ranks.size(), 1u);
  EXPECT_EQ(m.analysis.ranks[0].rank, 40);
  EXPECT_EQ(m.analysis.ranks[0].configurations, m.analysis.closed_configurations);
}

TEST(Certificate, CoachHasNothingToSpare) {
  const Mechanism m = load("models/coach_mechanism.json");
  for (const BlockAnalysis& block : m.analysis.blocks) {
    EXPECT_TRUE(block.certificate.redundant.empty());
    EXPECT_EQ(block.certificate.steps, 0);
    EXPECT_EQ(block.certificate.ranks.size(), 1u);
  }
}

/// By hand: an axis (-0.6, 0.64, 0.48) has the perpendicular directions axis x z and axis x (axis x z), both normed.
TEST(Certificate, SkewAxesAreNamedByTheirDirections) {
  const Mechanism m = made(
      truss("[0, 0, 0]", "[0.8, 0.48, 0.36]", "[0.32, -0.168, 0.624]", "[-0.6, 0.64, 0.48]", "[-0.6, 0.64, 0.48]"));
  std::map<std::string, std::string> meaning;
  for (const RedundantEquation& equation : certificate(m).redundant) meaning[equation.name] = equation.meaning;
  EXPECT_EQ(meaning["top.axis_1"], "axis tilt about (-0.328, 0.35, -0.877)");
  EXPECT_EQ(meaning["top.axis_2"], "axis tilt about (0.73, 0.684, 0)");
}

/// Every way to tilt one pin of a planar linkage is refused where the pin stands, with the angle.
TEST(Incompatible, ATiltedPinIsNamedAtEveryAngle) {
  for (const char* name : {"crank_pin", "coupler_pin", "rocker_pin", "rocker_tip"})
    for (const auto& [degrees, text] : std::map<double, std::string>{
             {0.01, " 0.01 deg off"}, {1, " 1 deg off"}, {5, " 5 deg off"}, {30, " 30 deg off"}, {60, " 60 deg off"}}) {
      Model model = model_of("models/four_bar.json");
      tilt(model, name, degrees);
      const Diagnostics problems = analysis_problems(model);
      ASSERT_EQ(problems.size(), 1u) << name << " " << degrees;
      EXPECT_EQ(problems[0].where.pointer, std::string("/joints/") + name) << degrees;
      EXPECT_NE(problems[0].message.find("redundant equations of loop \"rocker_tip\" contradict each other"),
                std::string::npos)
          << problems[0].message;
      EXPECT_NE(problems[0].hint.find(text), std::string::npos) << problems[0].hint;
    }
}

/// By hand: while the coupler pin turns by 1, the rocker's tip turns by -1/5 (velocities of the four-bar at the
/// reference), so 0.1 rad of it turns an axis that is 1 deg off by 0.02 sin(1 deg), to first order in the motion.
TEST(Incompatible, TheResidualIsThatOfAFiniteMotion) {
  Model model = model_of("models/four_bar.json");
  tilt(model, "rocker_tip", 1);
  const Diagnostics problems = analysis_problems(model);
  ASSERT_EQ(problems.size(), 1u);
  const std::string& message = problems[0].message;
  const std::string before =
      "moving coupler_pin by 0.1 rad opens rocker_tip.axis_2 (axis tilt about (1, -0.017, 0)) by ";
  const std::size_t at = message.find(before);
  ASSERT_NE(at, std::string::npos) << message;
  const double residual = std::stod(message.substr(at + before.size()));
  EXPECT_NEAR(residual, 0.02 * std::sin(kDegree), 0.1 * 0.02 * std::sin(kDegree));
}

TEST(Incompatible, ATiltBelowTheRankToleranceShowsAsAnOpenEquation) {
  Model model = model_of("models/four_bar.json");
  tilt(model, "coupler_pin", 2e-7);
  const Diagnostics problems = analysis_problems(model);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("contradict the others"), std::string::npos) << problems[0].message;
}

TEST(Incompatible, OneTiltedPinOfTheTruckIsFoundInItsBlock) {
  for (const auto& [joint, loop] : std::map<std::string, std::string>{{"cab", "cab_upper_pivot"},
                                                                      {"cab_upper_pivot", "cab_upper_pivot"},
                                                                      {"seat_link_right", "seat_pivot_right"},
                                                                      {"pitman_arm", "relay_ball"}})
    for (const double degrees : {0.01, 30.0}) {
      if (joint == "pitman_arm" && degrees == 30.0) continue;  // see below
      Model model = model_of("models/truck_mechanism.json");
      tilt(model, joint, degrees);
      const Diagnostics problems = analysis_problems(model);
      ASSERT_EQ(problems.size(), 1u) << joint << " " << degrees;
      const Where& written = joint_named(model, joint).where;
      EXPECT_EQ(problems[0].where.file, written.file) << joint;
      EXPECT_EQ(problems[0].where.pointer, written.pointer) << joint;
      EXPECT_NE(problems[0].message.find("loop \"" + loop + "\""), std::string::npos) << problems[0].message;
    }
}

/// The steering's balls ask for one thing twice while its pins are parallel. Well apart they ask for as many things as
/// there are equations, and nothing contradicts: that is another mechanism, with one freedom less.
TEST(Compatible, AClearTiltThatLeavesNoEquationToSpareIsAccepted) {
  Model model = model_of("models/truck_mechanism.json");
  tilt(model, "pitman_arm", 30);
  const Result<Topology> built = build_topology(model);
  ASSERT_TRUE(built);
  const Topology& topology = *built;
  const Result<Analysis> analysed = analyse(model, topology);
  ASSERT_TRUE(analysed) << to_text(analysed.problems());
  const Analysis& analysis = *analysed;
  const auto steering = std::find_if(topology.blocks.begin(), topology.blocks.end(), [&](const LoopBlock& block) {
    return std::any_of(block.loops.begin(), block.loops.end(),
                       [&](int l) { return topology.loops[l].name == "relay_ball"; });
  });
  ASSERT_NE(steering, topology.blocks.end());
  EXPECT_EQ(analysis.blocks[steering - topology.blocks.begin()].rank, steering->equations);
}

TEST(Incompatible, TwoTiltedLinkagesAreBothNamed) {
  Model model = model_of("models/truck_mechanism.json");
  tilt(model, "cab", 1);
  tilt(model, "seat_link_right", 1);
  const Diagnostics problems = analysis_problems(model);
  ASSERT_EQ(problems.size(), 2u) << to_text(problems);
  EXPECT_EQ(problems[0].where.pointer, "/joints/cab");
  EXPECT_EQ(problems[1].where.pointer, joint_named(model, "seat_link_right").where.pointer);
}

TEST(Incompatible, AMotionDoesNotHideIt) {
  Model model = model_of("models/four_bar.json");
  Motion motion;
  motion.name = "drive";
  for (std::size_t j = 0; j < model.joints.size(); ++j)
    if (model.joints[j].name == "crank_pin") motion.joint = {static_cast<int>(j), 0};
  model.motions = {motion};
  EXPECT_TRUE(analysis_problems(model).empty());
  tilt(model, "coupler_pin", 1);
  const Diagnostics problems = analysis_problems(model);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("contradict each other"), std::string::npos) << problems[0].message;
}

/// Rigid on purpose: the plane's equations hold by themselves, the others hold the bars and nothing is left over.
TEST(Compatible, ATrussInAPlaneIsRigid) {
  const std::vector<std::string> trusses = {
      truss("[0, 0, 0]", "[1, 0, 0]", "[0.4, 0, 0.6]", "\"y\"", "\"y\""),
      // the same turned by the 3-4-5 triangle about z, then about x
      truss("[0, 0, 0]", "[0.8, 0.48, 0.36]", "[0.32, -0.168, 0.624]", "[-0.6, 0.64, 0.48]", "[-0.6, 0.64, 0.48]")};
  for (const std::string& text : trusses) {
    const Mechanism m = made(text);
    EXPECT_EQ(certificate(m).degrees_of_freedom, 0);
    EXPECT_EQ(certificate(m).redundant.size(), 3u);
    EXPECT_EQ(certificate(m).steps, 0);
    EXPECT_EQ(certificate(m).redundant[0].residual, -1);  // it cannot move, so nothing was watched
    EXPECT_EQ(never_moving(m), (std::vector<std::string>{"left_pin", "right_pin"}));
  }
  const Result<Model> tilted =
      read_model(truss("[0, 0, 0]", "[1, 0, 0]", "[0.4, 0, 0.6]", "\"y\"", "[0.1, 1, 0]"), "tilted.json");
  ASSERT_TRUE(tilted);
  ASSERT_EQ(analysis_problems(*tilted).size(), 1u);
  EXPECT_EQ(analysis_problems(*tilted)[0].where.pointer, "/joints/top");
}

TEST(Compatible, OneRodMayHoldOneJoint) {
  const Mechanism m = made(R"({ "mbgen": 1, "name": "held", "bodies": {
      "ground": { "points": { "A": [0, 0, 0], "D": [1, 0, 0] } }, )" +
                           body("arm", R"("A": [0, 0, 0], "T": [0.4, 0, 0.6])") + R"( },
      "joints": { )" + revolute("pin", "ground.A", "arm.A", "\"y\"") +
                           R"( },
      "rods": { "strut": { "from": "ground.D", "to": "arm.T" } } })");
  EXPECT_EQ(certificate(m).degrees_of_freedom, 0);
  EXPECT_EQ(never_moving(m), std::vector<std::string>{"pin"});
}

/// Parallel cranks of equal length move by their special lengths, at which Newton's method also meets singular places.
TEST(Compatible, ThreeEqualCranksMove) {
  Model model = model_of("tests/data/refused/cranks_of_unequal_length.json");
  for (Body& b : model.bodies)
    for (Point& point : b.points)
      if (point.name == "R") point.position = {2.1, 0.0, 0.3};
  const Result<Topology> topology = build_topology(model);
  ASSERT_TRUE(topology);
  const Result<Analysis> analysis = analyse(model, *topology);
  ASSERT_TRUE(analysis) << to_text(analysis.problems());
  EXPECT_EQ(analysis->blocks[0].rank, 3);
  EXPECT_EQ(analysis->blocks[0].certificate.degrees_of_freedom, 1);
  EXPECT_EQ(analysis->blocks[0].certificate.redundant.size(), 7u);
}

/// Two hinges in line: all five equations are redundant. The flap swings as a physical pendulum on one hinge does.
TEST(Compatible, ASecondHingeInLineChangesNothing) {
  const Mechanism m = made(two_hinges("\"y\""));
  EXPECT_EQ(m.analysis.blocks[0].rank, 0);
  EXPECT_EQ(certificate(m).redundant.size(), 5u);
  EXPECT_EQ(certificate(m).degrees_of_freedom, 1);
  for (const RedundantEquation& equation : certificate(m).redundant) EXPECT_LT(equation.residual, 1e-14);
  const GenericSolver solver(m.model, m.topology, m.analysis);
  GenericState state{{0.4}, {0.7}, {}, 0.0};
  ASSERT_TRUE(solver.project(state).ok());
  GenericDerivative derivative;
  ASSERT_TRUE(solver.accelerations(state, {0.0}, derivative).ok());
  // m g c cos z about y: positive z lowers the centre of mass, I = 0.2 + 2 * 0.3^2
  EXPECT_NEAR(derivative.zdd[0], 2 * 9.81 * 0.3 * std::cos(0.4) / (0.2 + 2 * 0.09), 1e-12);

  const Result<Model> tilted = read_model(two_hinges("[0.01, 1, 0]"), "tilted.json");
  ASSERT_TRUE(tilted);
  ASSERT_EQ(analysis_problems(*tilted).size(), 1u);
}

/// A redundant rod whose length changes at run time contradicts its twin: the generic engine says so.
TEST(Incompatible, ContradictionAtRunTimeIsAStatus) {
  const Mechanism m = made(R"({ "mbgen": 1, "name": "twins",
      "parameters": { "length": { "value": 1, "unit": "m", "tunable": true } },
      "bodies": { "ground": { "points": { "A": [0, 0, 0], "D": [1, 0, 0] } }, )" +
                           body("arm", R"("A": [0, 0, 0], "B": [0.2, 0, 0.4])") + ", " +
                           body("fork", R"("B": [0.2, 0, 0.4], "T": [0.4, 0, 0.8])") + R"( },
      "joints": { )" + revolute("pin", "ground.A", "arm.A", "\"y\"") +
                           ", " + revolute("knee", "arm.B", "fork.B", "\"y\"") + R"( },
      "rods": { "strut": { "from": "ground.D", "to": "fork.T", "length": 1 },
                "stay": { "from": "ground.D", "to": "fork.T", "length": "length" } } })");
  EXPECT_EQ(m.analysis.blocks[0].rank, 1);
  GenericSolver solver(m.model, m.topology, m.analysis);
  GenericState state{{0.1, 0.0}, {0.3, 0.0}, {}, 0.0};
  ASSERT_TRUE(solver.project(state).ok());
  const GenericState good = state;
  solver.set_parameters({1.001});
  const Status status = solver.project(state);
  EXPECT_EQ(status.code, Code::loop_not_closed);
  EXPECT_EQ(status.index, 0);
  EXPECT_EQ(state.z, good.z);
}

}  // namespace
}  // namespace mbgen
