// Near singular positions and redundant loads at the command line.

#include "tests/support/cli_support.hpp"
#include "workbench/motion/cvode_steps.hpp"

namespace mbgen::cli_test {
namespace {

class Singular : public CommandLine {};

/// A four-bar of 1, 2, `third`, 2 m in the plane of x and z, its crank at 0.5 rad, on the crossed branch.
std::string crossed_four_bar(double third) {
  const double x = std::cos(0.5), z = std::sin(0.5), gap = std::hypot(2 - x, z);
  // The coupler's end is 2 m from the crank's and `third` from the pivot at 2 m, below the line between them.
  const double along = (gap * gap + 4 - third * third) / (2 * gap), across = std::sqrt(4 - along * along);
  const double tip_x = x + (along * (2 - x) - across * z) / gap, tip_z = z + (-along * z - across * (2 - x)) / gap;
  const auto bar = [](double ax, double az, double bx, double bz) {
    return fmt::format(
        R"({{ "mass": 1, "com": [{}, 0, {}], "inertia": [0.1, 0.1, 0.1], "points": {{ "P": [{}, 0, {}], "Q": [{}, 0, {}] }} }})",
        (ax + bx) / 2, (az + bz) / 2, ax, az, bx, bz);
  };
  return fmt::format(R"({{ "mbgen": 1, "name": "crossed", "gravity": [0, 0, 0], "bodies": {{
      "ground": {{ "points": {{ "O": [0, 0, 0], "D": [2, 0, 0] }} }},
      "a": {}, "b": {}, "c": {} }}, "joints": {{
      "ja": {{ "type": "revolute", "from": "ground.O", "to": "a.P", "axis": "-y" }},
      "jb": {{ "type": "revolute", "from": "a.Q", "to": "b.P", "axis": "-y" }},
      "jc": {{ "type": "revolute", "from": "ground.D", "to": "c.P", "axis": "-y" }},
      "jd": {{ "type": "revolute", "from": "b.Q", "to": "c.Q", "axis": "-y", "cut": true }} }},
      "initial": {{ "velocities": {{ "ja": 3 }} }} }})",
                     bar(0, 0, x, z), bar(x, z, tip_x, tip_z), bar(2, 0, tip_x, tip_z));
}

// A bar that is too long by a hundred millionth keeps the branches apart by 0.1 mrad, which steps of 3 mrad leap over.
TEST_F(Singular, BranchesThatComeCloseAreNoCrossing) {
  for (const double more : {1e-6, 1e-8, 1e-10}) {
    write("four_bar.json", crossed_four_bar(1 + more));
    for (const char* with : {"--integrator rk4", "--integrator abm4", "--integrator rosenbrock"}) {
      const Outcome done = mbgen(
          "simulate four_bar.json --engine generic --duration 1 --step 0.001 --out m.csv --json " + std::string(with));
      EXPECT_EQ(done.exit_code, 1) << more << " " << with;
      EXPECT_EQ(Json::parse(done.out)["status"], "loop singular: jd") << more << " " << with;
      EXPECT_LT(Json::parse(done.out)["position_residual"].get<double>(), 2e-12) << more << " " << with;
    }
  }
}

// Steps that have no stage in the gap: only the side on which the loop is tells that they leapt.
TEST_F(Singular, LongStepsDoNotLeapEither) {
  for (const double more : {1e-6, 1e-10, -1e-8}) {
    write("four_bar.json", crossed_four_bar(1 + more));
    for (const char* with : {"generic --integrator rk4", "generic --integrator abm4", "generic --integrator rosenbrock",
                             "augmented", "maggi"}) {
      for (const double step : {0.01, 1.0 / 60, 0.05}) {
        const Outcome done = mbgen(
            fmt::format("simulate four_bar.json --duration 1 --out m.csv --json --step {} --engine {}", step, with));
        EXPECT_EQ(done.exit_code, 1) << more << " " << with << " " << step;
        EXPECT_EQ(Json::parse(done.out)["status"], "loop singular: jd") << more << " " << with << " " << step;
      }
    }
  }
}

// Gaps of some hundredths: what goes on keeps its energy, and a step that is too long for the gap ends the motion.
TEST_F(Singular, StepsThatTurnWithTheGapKeepTheEnergyOrFail) {
  for (const double more : {1e-2, 1e-3, 1e-4, -1e-3}) {
    write("four_bar.json", crossed_four_bar(1 + more));
    for (const char* with :
         {"generic --integrator rk4", "generic --integrator abm4", "generic --integrator rosenbrock", "augmented"}) {
      for (const double part : {0.02, 0.5, 2.5}) {
        const double step = std::min(part * std::sqrt(std::abs(more)), 0.1);
        const Outcome done = mbgen(fmt::format(
            "simulate four_bar.json --duration 1 --out m.csv --json --step {:.2g} --engine {}", step, with));
        const Json report = Json::parse(done.out);
        const std::string status = report["status"], at = fmt::format("{} {} {} {}", more, with, step, status);
        if (part < 0.1) {
          EXPECT_EQ(done.exit_code, 0) << at;
          EXPECT_LT(std::abs(report["relative_energy_error"].get<double>()), 0.01) << at;
        } else {
          EXPECT_EQ(done.exit_code, 1) << at;
          EXPECT_TRUE(status == "loop singular: jd" || status == "loop not closed: jd") << at;
        }
      }
    }
  }
}

// Steps of error control turn at a gap of 10 mrad: the rocker stays between -1.8 and 1.25 rad.
TEST_F(Singular, StepsOfErrorControlTurnWhereTheyLeapt) {
  if (!has_cvode()) GTEST_SKIP() << "built without SUNDIALS";
  for (const char* method : {"cvode", "cvode-adams"}) {
    write("four_bar.json", crossed_four_bar(1 + 1e-3));
    const Json turned = json_of(fmt::format(
        "simulate four_bar.json --engine generic --duration 4 --step 0.01 --out m.csv --json --integrator {}", method));
    EXPECT_EQ(turned["status"], "ok") << method;
    const Table motion = table("m.csv");
    for (const std::vector<double>& row : motion.rows) {
      EXPECT_GT(row[motion.column("z.jc [rad]")], -1.85) << method;
      EXPECT_LT(row[motion.column("z.jc [rad]")], 1.31) << method;
    }
    write("four_bar.json", crossed_four_bar(1));
    const Json passed = json_of(fmt::format(
        "simulate four_bar.json --engine generic --duration 4 --step 0.01 --out m.csv --json --integrator {}", method));
    EXPECT_EQ(passed["blocks"][0]["singular_positions"], 6) << method;
  }
}

TEST_F(Singular, EmittedSolversDoNotTakeThemForACrossingEither) {
  write("four_bar.json", crossed_four_bar(1 + 1e-8));
  for (const char* step : {"0.001", "0.01", "0.02"}) {
    const Outcome done = mbgen(fmt::format("simulate four_bar.json --duration 1 --step {} --out m.csv --json", step));
    EXPECT_EQ(done.exit_code, 1) << step;
    EXPECT_EQ(Json::parse(done.out)["status"], "loop singular: jd") << step;
  }
}

// Crossings of an exact loop, by steps of up to 0.15 rad.
TEST_F(Singular, EmittedSolversPassCrossingsAtEveryStepAndStayClosed) {
  write("four_bar.json", crossed_four_bar(1));
  for (const char* step : {"0.001", "0.005", "0.01", "0.02"}) {
    const Json report = json_of(fmt::format("simulate four_bar.json --duration 2 --step {} --out m.csv --json", step));
    EXPECT_EQ(report["blocks"][0]["singular_positions"], 3) << step << " " << report["status"];
    EXPECT_LT(report["position_residual"].get<double>(), 8e-12) << step;
  }
}

TEST_F(Singular, CasesOfASweepTellWhatTheyPassed) {
  std::string text = crossed_four_bar(1);
  text.replace(text.find("\"initial\""), 0, R"("parameters": { "heavy": { "value": 1, "tunable": true } }, )");
  text.replace(text.find("\"mass\": 1,"), 10, R"("mass": "heavy",)");
  write("four_bar.json", text);
  const Outcome done = mbgen(
      "sweep four_bar.json --engine generic --vary heavy=1,2 --duration 1 --step 0.001 --metric \"e=max(z.ja)\" --out "
      "s.csv");
  EXPECT_EQ(done.exit_code, 0) << done.err;
  const std::string table = read("s.csv");
  int told = 0;
  for (std::size_t at = table.find("\"ok, "); at != std::string::npos; at = table.find("\"ok, ", at + 1)) ++told;
  EXPECT_EQ(told, 2) << table;
  EXPECT_NE(table.find("singular position"), std::string::npos) << table;
  EXPECT_NE(table.find("loops jd at t = "), std::string::npos) << table;
}

TEST_F(Singular, BarsThatAreEqualToRoundingPass) {
  for (const double more : {0.0, 4e-16, 1e-14}) {
    write("four_bar.json", crossed_four_bar(1 + more));
    for (const char* with : {"--integrator rk4", "--integrator abm4"}) {
      const Json report = json_of(
          "simulate four_bar.json --engine generic --duration 4 --step 0.001 --out m.csv --json " + std::string(with));
      const std::string status = report["status"];
      EXPECT_TRUE(status.starts_with("ok, 6 singular positions passed, first by loops jd at t = 0.49")) << status;
      EXPECT_GE(report["blocks"][0]["singular_positions"].get<int>(), 3) << more << " " << with;
      EXPECT_LT(report["position_residual"].get<double>(), 1e-11) << more << " " << with;
    }
  }
}

TEST_F(Singular, AVelocityThatTheLoopMultipliesBeyondReasonIsRefused) {
  write("rod.json", R"({ "mbgen": 1, "bodies": { "ground": { "points": { "O": [0, 0, 0], "H": [3, 0, 0] } },
  "crank": { "mass": 1, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0], "P": [1, 0, 1e-10] } },
  "slide": { "mass": 1, "inertia": [1, 1, 1], "points": { "H": [3, 0, 0] } } },
  "joints": { "crank": { "type": "revolute", "from": "ground.O", "to": "crank.O", "axis": "y" },
              "slide": { "type": "prismatic", "from": "ground.H", "to": "slide.H", "axis": "x" } },
  "rods": { "rod": { "from": "crank.P", "to": "slide.H" } },
  "initial": { "velocities": {
    "slide": 1 } } })");
  const Outcome done = mbgen("simulate rod.json --engine generic --duration 0.1 --step 0.001 --out m.csv");
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(
      done.err.find("rod.json:8:5: /initial/velocities/slide: initial velocity of slide cannot be met: with 1 m/s "
                    "the loops would move crank at "),
      std::string::npos)
      << done.err;
  EXPECT_NE(done.err.find("hint: the start is next to a singular position, where slide can hardly move: start "
                          "elsewhere, or give the velocity of crank"),
            std::string::npos)
      << done.err;
}

/// The left and the right hinge of a frame.
std::string framed(const std::string& right) {
  return R"({ "mbgen": 1, "bodies": { "ground": { "points": { "L": [0,0,0], "R": [0,2,0] } },
  "frame": { "mass": 10, "com": [0,1.5,-0.4], "inertia": [1,1,1], "points": { "L": [0,0,0], "R": [0,2,0] } } },
  "joints": { "left": { "type": "revolute", "from": "ground.L", "to": "frame.L", "axis": "y" },
    "right": { "type": ")" +
         right + R"(", "from": "ground.R", "to": "frame.R", "axis": "y" } } })";
}

TEST_F(Singular, TwoHingesThatShareALoadAreNoted) {
  write("frame.json", framed("revolute"));
  const Outcome done = mbgen("check frame.json");
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_EQ(done.err.substr(0, done.err.find('\n')),
            "frame.json:4:5: note: joints \"left\" and \"right\" connect the same bodies, and 5 of 5 equations of the "
            "latter repeat the former: how the two share the load follows from the choice of equations");
}

}  // namespace
}  // namespace mbgen::cli_test
