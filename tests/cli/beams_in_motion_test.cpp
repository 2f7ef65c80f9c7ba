// Motions of beams against geometrically exact ones. Source of the figures: the project's reference data
// flex_beams.json, by Gauss-Lobatto elements and Radau IIA in inertial coordinates: the spin-up of Simo and Vu-Quoc,
// the slider-crank of Meijaard.

#include <cmath>
#include <numbers>

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class BeamsInMotion : public CommandLine {
 protected:
  Table run(const std::string& model, const std::string& more) const {
    const Outcome done = mbgen("simulate " + model + " --engine generic --out m.csv " + more);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return table("m.csv");
  }
};

// 10 m from rest to 6 rad/s in 15 s: the tip lags by 0.571 m, of which four segments miss 2.3 %, eight 1.0 %.
TEST_F(BeamsInMotion, ABeamThatSpinsUpLagsAndStretches) {
  write("spin.json", R"json({ "mbgen": 1, "name": "spin", "gravity": [0, 0, 0],
      "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
        "hub": { "mass": 1, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } } },
      "joints": { "hub": { "type": "revolute", "from": "ground.O", "to": "hub.O", "axis": "z" } },
      "motions": { "hub": { "joint": "hub", "angle": "0.4*(t^2/2 + (15/(2*pi))^2*(cos(2*pi*t/15) - 1))" } },
      "beams": { "rod": { "points": { "a": [0, 0, 0], "b": [10, 0, 0] }, "segments": 4,
        "section": { "shape": "general", "A": 1, "Iy": 5e-4, "Iz": 5e-4, "J": 1e-3 },
        "material": { "E": 2.8e7, "G": 1e7, "density": 1.2 }, "supports": { "a": { "body": "hub" } } } },
      "outputs": { "x": { "point": "rod_b.rod_b", "quantity": "position", "axis": "x" },
        "y": { "point": "rod_b.rod_b", "quantity": "position", "axis": "y" } } })json");
  const Table motion = run("spin.json", "--integrator rosenbrock --step 1e-2 --every 50 --duration 15");
  const double rows[][3] = {{5, -0.0126546362, -0.468476183},
                            {7.5, -0.0177418644, -0.559083429},
                            {10, -0.00707232998, -0.362814278},
                            {15, 0.000513989839, 0.0013035761}};
  for (const auto& [t, stretch, lag] : rows) {
    const std::size_t row = static_cast<std::size_t>(std::lround(2 * t));
    const double x = motion.at(row, "x [m]"), y = motion.at(row, "y [m]"), turn = motion.at(row, "z.hub [rad]");
    EXPECT_NEAR(x * std::cos(turn) + y * std::sin(turn) - 10, stretch, 0.001) << t;
    EXPECT_NEAR(y * std::cos(turn) - x * std::sin(turn), lag, 0.025 * 0.571) << t;
  }
}

// A rod of 0.3 m at 150 rad/s of its crank: its middle leaves the chord by 4.6 mm, of which four
// segments miss 4 %.
TEST_F(BeamsInMotion, AnElasticRodOfASliderCrankBends) {
  write("crank.json", R"({ "mbgen": 1, "name": "crank", "gravity": [0, 0, 0],
      "bodies": { "ground": { "points": { "O": [0, 0, 0], "S": [0.45, 0, 0] } },
        "crank": { "mass": 1, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } },
        "slider": { "mass": 0.033377851148064755, "com": [0.45, 0, 0], "inertia": [1e-5, 1e-5, 1e-5], "points": { "S": [0.45, 0, 0] } } },
      "joints": { "crank": { "type": "revolute", "from": "ground.O", "to": "crank.O", "axis": "z" },
        "slider": { "type": "prismatic", "from": "ground.S", "to": "slider.S", "axis": "x" } },
      "motions": { "crank": { "joint": "crank", "angle": "150*t" } },
      "beams": { "rod": { "points": { "a": [0.15, 0, 0], "m": [0.3, 0, 0], "b": [0.45, 0, 0] }, "segments": 4,
        "section": { "shape": "round", "diameter": 0.006 },
        "material": { "E": 2e11, "G": 7.6923e10, "density": 7870 },
        "supports": { "a": { "body": "crank", "type": "hinge", "axis": "z" },
          "b": { "body": "slider", "type": "hinge", "axis": "z" } } } },
      "initial": { "velocities": { "rod_a": -225, "rod_b": -75 } },
      "outputs": { "ax": { "point": "rod_a.rod_a", "quantity": "position", "axis": "x" },
        "ay": { "point": "rod_a.rod_a", "quantity": "position", "axis": "y" },
        "mx": { "point": "rod_m.rod_m", "quantity": "position", "axis": "x" },
        "my": { "point": "rod_m.rod_m", "quantity": "position", "axis": "y" },
        "bx": { "point": "rod_b.rod_b", "quantity": "position", "axis": "x" } } })");
  // Explicit steps for the waves along the rod; the reference has a row in 7.5 degrees, 48 in a turn.
  const double row_time = 2 * std::numbers::pi / 150 / 48;
  const Table motion =
      run("crank.json", fmt::format("--step {:.17g} --every 150 --duration {:.17g}", row_time / 150, 60 * row_time));
  const std::pair<std::size_t, double> rows[] = {{6, 0.0046043892},   {12, 0.0016842023},  {18, -0.00010427647},
                                                 {24, 0.00091118786}, {36, -0.0022683878}, {48, 0.00014048868},
                                                 {54, 0.0028858357},  {60, 0.0019725598}};
  double worst = 0;
  for (const auto& [row, deflection] : rows) {
    const double ax = motion.at(row, "ax [m]"), ay = motion.at(row, "ay [m]"), bx = motion.at(row, "bx [m]");
    const double x = bx - ax, y = -ay, length = std::hypot(x, y);
    const double left = (x * (motion.at(row, "my [m]") - ay) - y * (motion.at(row, "mx [m]") - ax)) / length;
    worst = std::max(worst, std::abs(left - deflection));
  }
  EXPECT_LT(worst, 0.05 * 0.0046043892);
}

// The left front wheel of the truck is on its hump, 8 cm high, after 0.32 s: over a track of 2 m that is 0.04 rad,
// which the frame of 37 kN m/rad shares with the springs of both axles.
TEST_F(BeamsInMotion, AFrameOfATruckTwists) {
  const Table motion = run(kSource + "/models/beams/truck.json", "--integrator rosenbrock --every 10 --duration 0.34");
  EXPECT_LT(std::abs(motion.at(0, "twist [rad]")), 1e-12);
  EXPECT_GT(motion.last("twist [rad]"), 0.005);
  EXPECT_LT(motion.last("twist [rad]"), 0.03);
}

}  // namespace
}  // namespace mbgen::cli_test
