// Blocks and vehicles that stand on edges against closed forms, through the command line. Source of the figures: the
// project's reference data contacts_driveline.json: Housner's rocking block, thresholds of tipping.

#include <cmath>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class Rocking : public CommandLine {
 protected:
  Table run(const std::string& model, const std::string& more) const {
    const Outcome done = mbgen("simulate " + model + " --engine generic --out m.csv " + more);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return table("m.csv");
  }
};

/// A rigid block of half diagonal 1.2 m and slenderness 0.25 rad, tilted about its right edge at rest. k: N/m over kg.
std::string rocking_block(double tilt, double k, double damping) {
  const double half = 1.2 * std::sin(0.25), height = 2.4 * std::cos(0.25);
  return fmt::format(R"({{ "mbgen": 1, "name": "block",
    "bodies": {{ "ground": {{ "points": {{ "R": [{0:.17g}, 0, 0] }} }},
      "x": {{ "points": {{ "R": [{0:.17g}, 0, 0] }} }}, "z": {{ "points": {{ "R": [{0:.17g}, 0, 0] }} }},
      "block": {{ "mass": 1, "com": [0, 0, {1:.17g}], "inertia": [1, 0.48, 1],
        "points": {{ "R": [{0:.17g}, 0, 0], "L": [-{0:.17g}, 0, 0] }} }} }},
    "joints": {{ "x": {{ "type": "prismatic", "from": "ground.R", "to": "x.R", "axis": "x" }},
      "z": {{ "type": "prismatic", "from": "x.R", "to": "z.R", "axis": "z" }},
      "turn": {{ "type": "revolute", "from": "z.R", "to": "block.R", "axis": "y" }} }},
    "contacts": {{
      "right": {{ "from": "block.R", "to": "ground.R", "stiffness": {2}, "damping": {3}, "friction": 5, "bristle": 1e-5, "bristle_damping": 1e-5 }},
      "left": {{ "from": "block.L", "to": "ground.R", "stiffness": {2}, "damping": {3}, "friction": 5, "bristle": 1e-5, "bristle_damping": 1e-5 }} }},
    "initial": {{ "positions": {{ "turn": {4}, "z": -{5:.17g} }} }} }})",
                     half, height / 2, k, damping, tilt, 9.81 / k);
}

// Housner: time until a block that rocks about its edge stands upright, by quadrature.
TEST_F(Rocking, RockingBlockHasHousnersQuarterPeriod) {
  const double cases[][2] = {
      {0.05, 0.2809496450355731}, {0.1, 0.444726965184631}, {0.15, 0.6336383821647328}, {0.2, 0.9264705657565407}};
  for (const auto& [tilt, quarter] : cases) {
    write("block.json", rocking_block(tilt, 1e6, 20));
    const Table motion =
        run("block.json", fmt::format("--step 5e-5 --every 10 --duration {}", 0.001 * std::ceil(1.01e3 * quarter)));
    std::size_t row = 0;
    while (motion.at(row, "z.turn [rad]") > 0) ++row;
    const double before = motion.at(row - 1, "z.turn [rad]"),
                 share = before / (before - motion.at(row, "z.turn [rad]"));
    const double time = motion.rows[row - 1][0] + share * (motion.rows[row][0] - motion.rows[row - 1][0]);
    EXPECT_NEAR(time / quarter, 1, 5e-5) << tilt;
  }
}

// An impact without bounce on the other edge leaves 1 - 3/2 sin^2 alpha of the rate (Housner); energy while the block
// rocks about an edge leads back to the impact.
TEST_F(Rocking, BlockLosesHousnersShareAtAnImpact) {
  const auto rate_upright = [](const Table& motion, std::size_t row) {
    const double rate = motion.at(row, "zd.turn [rad/s]"), tilt = std::abs(motion.at(row, "z.turn [rad]"));
    return std::sqrt(rate * rate + 2 * 3 * 9.81 / 4.8 * (std::cos(0.25 - tilt) - std::cos(0.25)));
  };
  for (const auto& [tilt, duration] : {std::pair{0.1, 0.52}, std::pair{0.15, 0.71}}) {
    write("block.json", rocking_block(tilt, 1e6, 200));
    const Table motion = run("block.json", fmt::format("--step 4e-5 --every 5 --duration {}", duration));
    std::size_t row = 0;
    while (motion.at(row, "z.turn [rad]") > 0.001) ++row;
    EXPECT_NEAR(rate_upright(motion, motion.rows.size() - 1) / rate_upright(motion, row), 0.9081869214177796, 5e-4);
  }
}

// Pushed slowly, a slender block tips at g tan(alpha), and slides where the friction is below tan(alpha) = 0.2553.
TEST_F(Rocking, BlockTipsOrSlides) {
  for (const double friction : {0.5, 0.2}) {
    std::string text = rocking_block(0, 1e6, 200);
    for (std::size_t at = 0; (at = text.find(R"("friction": 5)", at)) != std::string::npos;)
      text.replace(at, 13, fmt::format(R"("friction": {})", friction));
    text.pop_back();
    text += R"(, "forces": { "a": { "at": "block.com", "force": ["0.5*t", 0, 0] } },
      "outputs": { "left": { "contact": "left", "quantity": "load" } } })";
    text.replace(text.find(R"("points": {)", text.find(R"("block": {)")), 11,
                 fmt::format(R"("points": {{ "com": [0, 0, {:.17g}],)", 1.2 * std::cos(0.25)));
    write("pushed.json", text);
    const Table motion = run("pushed.json", "--step 1e-4 --every 10 --duration 5.2");
    std::size_t row = 1;
    while (row + 1 < motion.rows.size() && motion.at(row, "left [N]") > 0 && motion.at(row, "z.x [m]") < 1e-4) ++row;
    const bool tips = motion.at(row, "left [N]") <= 0;
    EXPECT_EQ(tips, friction > 0.2553) << friction;
    // 1e-4 m of sliding need 0.1 s.
    EXPECT_NEAR(0.5 * motion.rows[row][0], tips ? 2.504904247178366 : 0.2 * 9.81, tips ? 0.005 : 0.06) << friction;
  }
}

/// A vehicle across its course, pushed at its centre of mass by its mass times `acceleration`. roll: stiffness of its
/// roll axis, N m/rad, 0: rigid.
std::string tipping(double roll, const std::string& acceleration) {
  const std::string force = fmt::format(R"x("forces": {{ "a": {{ "at": "{}.com", "force": [0, "14000*({})", 0] }} }})x",
                                        roll > 0 ? "body" : "axle", acceleration);
  const std::string body = R"({ "mass": 14000, "com": [0, 0, 1.3], "inertia": [10000, 1, 10000],
        "points": { "com": [0, 0, 1.3], "roll": [0, 0, 0.6], "O": [0, 0, 0], "L": [0, 1, 0], "R": [0, -1, 0] } })";
  const std::string axle = R"({ "mass": 0.01, "com": [0, 0, 0.6], "inertia": [1000, 1, 1000],
        "points": { "roll": [0, 0, 0.6], "O": [0, 0, 0], "L": [0, 1, 0], "R": [0, -1, 0] } })";
  const std::string rolls = fmt::format(
      R"(, "roll": {{ "type": "revolute", "from": "axle.roll", "to": "body.roll", "axis": "x" }} }},
    "joint_springs": {{ "roll": {{ "joint": "roll", "stiffness": {}, "damping": 100000 }} }},)",
      roll);
  return R"({ "mbgen": 1, "name": "tipping",
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
      "y": { "points": { "O": [0, 0, 0] } }, "z": { "points": { "O": [0, 0, 0] } }, "axle": )" +
         (roll > 0 ? axle + ", \"body\": " + body : body) + R"( },
    "joints": { "y": { "type": "prismatic", "from": "ground.O", "to": "y.O", "axis": "y" },
      "z": { "type": "prismatic", "from": "y.O", "to": "z.O", "axis": "z" },
      "tilt": { "type": "revolute", "from": "z.O", "to": "axle.O", "axis": "x" })" +
         (roll > 0 ? rolls : " },") + R"(
    "contacts": {
      "left": { "from": "axle.L", "to": "ground.O", "stiffness": 1e9, "damping": 20, "friction": 2 },
      "right": { "from": "axle.R", "to": "ground.O", "stiffness": 1e9, "damping": 20, "friction": 2 } },
    "outputs": { "inner": { "contact": "right", "quantity": "load" } },
    "initial": { "positions": { "z": -6.867e-5 } }, )" +
         force + " }";
}

/// Time at which the load of the inner wheels goes to zero, from its course before.
double unloaded_at(const Table& motion, double least) {
  std::size_t row = 0;
  while (motion.rows[row][0] < least || motion.at(row, "inner [N]") > 100) ++row;
  const double load = motion.at(row, "inner [N]"), before = motion.at(row - 20, "inner [N]");
  return motion.rows[row][0] + load / (before - load) * (motion.rows[row][0] - motion.rows[row - 20][0]);
}

// g T/(2 h); with a roll axis at hr the centre of mass moves out. The closed form for small angles gives 6.843; the
// angle is 0.13 rad, with which the same equilibrium gives the threshold below.
TEST_F(Rocking, VehiclesTipAtTheirThreshold) {
  write("rigid.json", tipping(0, "t"));
  const Table rigid = run("rigid.json", "--step 5e-4 --every 10 --duration 7.7");
  EXPECT_NEAR(unloaded_at(rigid, 5), 7.546153846153846, 2e-3);
  const double g = 9.81, m = 14000, arm = 0.7, roll = 600000;
  double angle = 0, acceleration = 0;
  for (int k = 0; k < 100; ++k) {
    acceleration = g * (1 - arm * std::sin(angle)) / (0.6 + arm * std::cos(angle));
    angle = m * arm * (acceleration * std::cos(angle) + g * std::sin(angle)) / roll;
  }
  EXPECT_NEAR(acceleration, 6.84309638480158, 0.01 * 6.84);
  write("rolls.json", tipping(roll, fmt::format("min(0.7*t, {0}) + 0.05*max(t - 12, 0)", acceleration - 0.2)));
  const Table rolls = run("rolls.json", "--step 5e-4 --every 10 --duration 17");
  EXPECT_NEAR(acceleration - 0.2 + 0.05 * (unloaded_at(rolls, 12) - 12), acceleration, 3e-3);
}

}  // namespace
}  // namespace mbgen::cli_test
