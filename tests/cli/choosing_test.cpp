// Linkages that leave their frozen choice of coordinates, pass singular positions, or lock: as a user meets them.

#include <cmath>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

const double kPi = std::acos(-1.0);

/// Lengths of a planar four-bar linkage of uniform bars, 1 kg per m: ground, crank, coupler, rocker; the crank's angle.
struct FourBar {
  std::string name;
  double ground, crank, coupler, rocker, start;
  std::string more;  ///< members of the model: motions, initial values
};

std::string text_of(const FourBar& bars) {
  const std::string bar = R"json("mass": "{0}", "com": ["({1}+{3})/2", "({2}+{4})/2", 0],
    "inertia": ["{0}^3/12", "{0}^3/12", "{0}^3/12"], "points": {{ "P": ["{1}", "{2}", 0], "Q": ["{3}", "{4}", 0] }})json";
  const auto body = [&](const char* length, const char* px, const char* py, const char* qx, const char* qy) {
    return fmt::format(fmt::runtime(bar), length, px, py, qx, qy);
  };
  return fmt::format(R"json({{ "mbgen": 1, "name": "{}", "gravity": [0, -9.81, 0],
  "parameters": {{ "ground": {}, "crank": {}, "coupler": {}, "rocker": {}, "start": {},
    "bx": "crank*cos(start)", "by": "crank*sin(start)", "d": "sqrt((bx-ground)^2+by^2)",
    "c": "atan2(by, bx-ground) - acos((rocker^2+d^2-coupler^2)/(2*rocker*d))",
    "cx": "ground+rocker*cos(c)", "cy": "rocker*sin(c)" }},
  "bodies": {{
    "ground": {{ "points": {{ "A": [0, 0, 0], "D": ["ground", 0, 0] }} }},
    "crank": {{ {} }}, "coupler": {{ {} }}, "rocker": {{ {} }} }},
  "joints": {{
    "crank": {{ "type": "revolute", "from": "ground.A", "to": "crank.P", "axis": "z" }},
    "elbow": {{ "type": "revolute", "from": "crank.Q", "to": "coupler.P", "axis": "z" }},
    "rocker": {{ "type": "revolute", "from": "ground.D", "to": "rocker.P", "axis": "z" }},
    "tip": {{ "type": "revolute", "from": "coupler.Q", "to": "rocker.Q", "axis": "z", "cut": true }} }},
  {} }})json",
                     bars.name, bars.ground, bars.crank, bars.coupler, bars.rocker, bars.start,
                     body("crank", "0", "0", "bx", "by"), body("coupler", "bx", "by", "cx", "cy"),
                     body("rocker", "ground", "0", "cx", "cy"), bars.more);
}

/// Report and table of `simulate`.
struct Motion {
  Json report;
  Table table;
  double last(const std::string& name) const { return table.last(name); }
  Json block() const { return report["blocks"].empty() ? Json::object() : report["blocks"][0]; }
};

class Choosing : public CommandLine {
 protected:
  Motion simulate(const std::string& model, double duration, double step, const std::string& engine) const {
    const Json report = json_of(fmt::format("simulate {} --duration {} --step {} --engine {} --out motion.csv --json",
                                            model, duration, step, engine));
    return {report, table("motion.csv")};
  }

  /// Error of a coordinate of the generated solver at the end, with ever smaller steps, against the generic one, which
  /// chooses by full pivoting at every evaluation, with a tiny step.
  std::vector<double> errors(const std::string& model, const std::string& column, double duration, double step,
                             int halvings) const {
    const double exact = simulate(model, duration, step / std::pow(2.0, halvings + 1), "generic").last(column);
    std::vector<double> result;
    for (int k = 0; k < halvings; ++k) {
      result.push_back(std::abs(simulate(model, duration, step / std::pow(2.0, k), "generated").last(column) - exact));
    }
    return result;
  }
};

TEST_F(Choosing, DoubleCrankTurnsOnWhileItsChoiceFailsInEveryTurn) {
  write("drag_link.json", text_of({"drag_link", 0.6, 1, 1.2, 1.1, 0.7, R"("initial": {"velocities": {"crank": 6}})"}));
  const std::vector<double> error = errors("drag_link.json", "z.crank [rad]", 2, 4e-3, 4);
  EXPECT_GT(error[0] / error[1], 12);
  EXPECT_GT(error[1] / error[2], 12);
  EXPECT_LT(error[3], 1e-8);
  for (const char* engine : kEngines) {
    const Motion motion = simulate("drag_link.json", 5, 2e-3, engine);
    EXPECT_GT(motion.last("z.crank [rad]"), 6 * 2 * kPi) << engine;
    EXPECT_LT(std::abs(motion.report["relative_energy_error"].get<double>()), 1e-6) << engine;
    EXPECT_LT(motion.report["position_residual"].get<double>(), 1.1e-12) << engine;
    if (engine == std::string("generated")) {
      EXPECT_GT(motion.block()["chosen_again_steps"].get<long>(), 12);
    }
  }
}

TEST_F(Choosing, SliderCrankTurnsThroughItsDeadCentres) {
  const std::string model = MBGEN_SOURCE_DIR "/models/slider_crank.json";
  const double exact = simulate(model, 1, 2e-5, "generic").last("z.crank [rad]");
  EXPECT_GT(exact, 9 * 2 * kPi);
  for (const char* engine : kEngines) {
    const Motion motion = simulate(model, 1, 1e-4, engine);
    EXPECT_NEAR(motion.last("z.crank [rad]"), exact, 1e-6) << engine;
    EXPECT_LT(motion.report["position_residual"].get<double>(), 1.1e-12) << engine;
  }
}

// IFToMM A02: the bars of the N-four-bar line up at t = 0.714 s and 1.228 s.
TEST_F(Choosing, NFourBarPassesThePositionsWhereItsBarsLineUp) {
  for (const char* engine : kEngines) {
    const Motion motion = simulate(MBGEN_SOURCE_DIR "/models/iftomm/a02_n_four_bar_2.json", 10, 1e-3, engine);
    const std::vector<double> times = motion.block()["singular_times"];
    ASSERT_EQ(times.size(), 10u) << engine;
    EXPECT_NEAR(times[0], 0.714, 1e-3) << engine;
    EXPECT_NEAR(times[1], 1.228, 1e-3) << engine;
    const std::string status = motion.report["status"];
    EXPECT_TRUE(status.starts_with("ok, ") && status.find(" singular positions passed, first by loops ") < 8) << status;
    EXPECT_LT(std::abs(motion.report["relative_energy_error"].get<double>()), 1e-9) << engine;
    EXPECT_LT(motion.report["position_residual"].get<double>(), 1e-11) << engine;
  }
}

/// A body at rest below a hook that a rod of `length` m holds above its centre of mass, pushed along x. Or the same
/// with the rod as a link between two pins, a tree without loops.
std::string body_on_rod(double length, double speed, bool has_loop) {
  const std::string loop =
      R"json("joints": { "bob": { "type": "planar", "from": "ground.start", "to": "bob.centre", "axis": "y" } },
    "rods": { "rod": { "from": "ground.hook", "to": "bob.eye" } }, "initial": { "velocities": { "bob_tx": "speed" } })json";
  const std::string tree = R"json("joints": {
      "hook": { "type": "revolute", "from": "ground.hook", "to": "link.hook", "axis": "y" },
      "eye": { "type": "revolute", "from": "link.eye", "to": "bob.eye", "axis": "y" } },
    "initial": { "velocities": { "hook": "-speed/length", "eye": "speed/length" } })json";
  return fmt::format(R"json({{ "mbgen": 1, "name": "body_on_rod", "parameters": {{ "length": {}, "speed": {} }},
    "hardpoints": {{ "eye": [0, 0, "-length"], "start": [0, 0, "-length-0.1"] }},
    "bodies": {{ "ground": {{ "points": {{ "hook": [0, 0, 0] }} }}, {}
      "bob": {{ "mass": 1, "com": "start", "inertia": [0.01, 0.012, 0.008], "points": {{ "centre": "start" }} }} }}, {},
    "outputs": {{ "x": {{ "point": "bob.eye", "axis": "x" }}, "z": {{ "point": "bob.eye", "axis": "z" }} }} }})json",
                     length, speed, has_loop ? "" : R"("link": { "points": { "hook": [0, 0, 0] } },)",
                     has_loop ? loop : tree);
}

/// Largest distance of the columns x and z of two motions in rows that are 0.05 s apart.
double farthest(const Table& a, const Table& b) {
  double result = 0;
  EXPECT_EQ(a.rows.size(), b.rows.size());
  for (const char* column : {"x [m]", "z [m]"})
    for (std::size_t row = 0; row < std::min(a.rows.size(), b.rows.size()); ++row)
      result = std::max(result, std::abs(a.rows[row][a.column(column)] - b.rows[row][b.column(column)]));
  return result;
}

// The rod's equation is solved for one translation, whose slope is zero twice a turn: a drift that were put back along
// it alone would push the body along its circle.
TEST_F(Choosing, ABodyOnARodIsAsAccurateAsWithEveryChoiceMadeAnew) {
  struct Case {
    double length, speed;
  };
  for (const Case& c : {Case{0.2, 4.5}, Case{0.4, 4.5}, Case{0.9, 7.5}}) {
    write("rod.json", body_on_rod(c.length, c.speed, true));
    write("link.json", body_on_rod(c.length, c.speed, false));
    const auto motion = [&](const char* model, const char* engine, double step) {
      const std::string run = "simulate {} --engine {} --duration 2 --step {} --every {} --out motion.csv";
      EXPECT_EQ(mbgen(fmt::format(fmt::runtime(run), model, engine, step, std::lround(0.05 / step))).exit_code, 0);
      return table("motion.csv");
    };
    const Table exact = motion("link.json", "generated", 2e-5);
    for (const double step : {1e-3, 2e-3}) {
      const double generated = farthest(motion("rod.json", "generated", step), exact);
      EXPECT_LT(generated, 2 * farthest(motion("rod.json", "generic", step), exact)) << c.length << " m, " << step;
      EXPECT_GT(generated, 1e-9);
    }
  }
}

/// A crank driven further than coupler and rocker reach: they are in line when it stands at angle `limit`.
TEST_F(Choosing, ALinkageDrivenPastItsReachEndsInAStatus) {
  const FourBar bars{"lock", 1, 1, 0.7, 0.6, 0.8, R"("motions": {"drive": {"joint": "crank", "angle": "0.5*t"}})"};
  write("lock.json", text_of(bars));
  // ground and crank enclose the angle at which the distance of their ends is coupler + rocker
  const double reach = bars.coupler + bars.rocker;
  const double limit = std::acos(1 - reach * reach / 2) - bars.start;
  for (const char* engine : kEngines) {
    const Outcome run =
        mbgen(fmt::format("simulate lock.json --duration 5 --step 1e-3 --out lock.csv --engine {}", engine));
    EXPECT_EQ(run.exit_code, 1) << engine;
    EXPECT_NE(run.err.find("s: loop not closed: tip; lock.csv holds the motion up to there"), std::string::npos)
        << run.err;
    const Table motion = table("lock.csv");
    EXPECT_NEAR(motion.last("z.crank [rad]"), limit, 1.5 * 0.5e-3) << engine << ": two steps before the limit at most";
    EXPECT_LE(motion.last("z.crank [rad]"), limit + 1e-12) << engine;
    for (const std::vector<double>& row : motion.rows)
      for (const double value : row) EXPECT_LT(std::abs(value), 1e5) << engine;
  }
}

}  // namespace
}  // namespace mbgen::cli_test
