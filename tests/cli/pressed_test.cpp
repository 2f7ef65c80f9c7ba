// Frictions that reactions press, through the command line: engines, integrators, and what a motion warns of.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class PressedFriction : public CommandLine {
 protected:
  /// The motion of the linkage over 0.05 s, by these options.
  Table motion(const std::string& options, double step = 5e-4) {
    const Outcome run =
        mbgen(fmt::format("simulate {}/tests/data/models/pressed.json --duration 0.05 --step {} --out motion.csv {}",
                          kSource, step, options));
    EXPECT_EQ(run.exit_code, 0) << options << run.err;
    return table("motion.csv");
  }

  /// A block on a plane that is pushed along it, and pressed by so many N.
  /// period: a field of the friction, or nothing.
  void write_block(const std::string& press, const std::string& period = "") {
    write("block.json", R"({ "mbgen": 1, "name": "block",
      "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
                  "block": { "mass": 2, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } } },
      "joints": { "x": { "type": "prismatic", "from": "ground.O", "to": "block.O", "axis": "x" } },
      "forces": { "press": { "at": "block.O", "force": [20, 0, ")" +
                            press + R"("] } },
      "frictions": { "floor": { "joint": "x", "reaction": "x", "coulomb": 0.3, "velocity": 0.01)" +
                            period + " } } }");
  }
};

TEST_F(PressedFriction, EnginesAgree) {
  const Table generic = motion("--engine generic");
  EXPECT_GT(generic.last("x.crank_pin_load [N]"), 1);
  EXPECT_GT(generic.last("x.stay_ball_load [N]"), 1);
  expect_same_motion(generic, motion("--engine generated"), 1e-9);
  expect_same_motion(generic, motion("--engine augmented"), 1e-6);
}

TEST_F(PressedFriction, IntegratorsAgree) {
  const Table runge_kutta = motion("--engine generic");
  expect_same_motion(motion("--engine generic --integrator abm4"), motion("--engine generated --integrator abm4"),
                     1e-9);
  EXPECT_NEAR(motion("--integrator rosenbrock").last("z.crank [rad]"), runge_kutta.last("z.crank [rad]"), 1e-6);
  EXPECT_NEAR(motion("--integrator cvode --tolerance 1e-9").last("z.crank [rad]"), runge_kutta.last("z.crank [rad]"),
              1e-6);
}

// The generic runtime projects along other directions than the frozen ones, where implicit steps differ by their error.
TEST_F(PressedFriction, EnginesDifferInImplicitStepsByTheirErrorOfOrderThree) {
  const auto gap = [&](double step) {
    const Table generic = motion("--integrator rosenbrock --engine generic", step);
    return std::abs(motion("--integrator rosenbrock", step).last("x.pull [N]") - generic.last("x.pull [N]"));
  };
  const double coarse = gap(5e-4), fine = gap(2.5e-4);
  EXPECT_GT(coarse, 0);
  EXPECT_LT(fine, coarse / 5);
}

TEST_F(PressedFriction, LoadsThatJumpAreWarnedOf) {
  const auto warnings = [&](const std::string& press) {
    write_block(press);
    const Outcome run = mbgen("simulate block.json --engine generic --duration 0.2 --step 1e-3 --out block.csv");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.err;
  };
  EXPECT_NE(warnings("-30*(1 + tanh(1e5*(t - 0.1004)))").find("x.floor_load jumps by 60 N before t = 0.102 s"),
            std::string::npos)
      << warnings("-30*(1 + tanh(1e5*(t - 0.1004)))");
  EXPECT_EQ(warnings("-30*sin(10*t)").find("floor_load"), std::string::npos);
}

TEST_F(PressedFriction, PeriodIsAMultipleOfTheStep) {
  const std::string simulate = "simulate block.json --engine generic --duration 0.2 --step 4e-3 --out block.csv";
  write_block("-10");
  EXPECT_EQ(mbgen(simulate).exit_code, 0) << "one that is not given follows the step";
  write_block("-10", R"(, "period": 1e-3)");
  const Outcome run = mbgen(simulate);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("\"floor_load\" is set every 0.001 s"), std::string::npos) << run.err;
}

TEST_F(PressedFriction, ExplainTellsWhatPresses) {
  write_block("-10");
  const Outcome run = mbgen("explain block.json");
  EXPECT_NE(run.out.find("floor is pressed by the force of x across its axis, x.floor_load"), std::string::npos)
      << run.out;
}

}  // namespace
}  // namespace mbgen::cli_test
