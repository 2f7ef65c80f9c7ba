// States of the user's own in an equilibrium: their rates vanish, or the search fails with the one that drifts.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class StatesAtRest : public CommandLine {
 protected:
  /// A mass on a spring with a state.
  void write_state(const std::string& more, const std::string& state) {
    write("state.json", R"json({ "mbgen": 1, "name": "state", "gravity": [0, 0, 0], )json" + more + R"json(
  "states": { "speed": )json" +
                            state + R"json( },
  "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
              "mass": { "mass": 1, "inertia": [0, 0, 0], "points": { "A": [0, 0, 0] } } },
  "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "mass.A", "axis": "x" } },
  "joint_springs": { "spring": { "joint": "slide", "stiffness": 10, "damping": 1 } },
  "initial": { "equilibrium": true } })json");
  }

  static constexpr const char* kEngine = R"json(
  "maps": { "engine": { "x": [50, 80, 250], "y": [0, 0.25, 1],
    "z": [[-100, 450, 1100], [-120, 500, 1600], [-320, -320, -320]], "outside": "hold" } },
  "values": { "throttle": "max(0, min(1, 0.05*(60 - speed)))" },)json";
};

// At 59.07 rad/s the idle governor balances the drag: the root of the bilinear map by hand. Newton's first step from 60
// leads to -100 rad/s, where throttle and map are saturated and nothing changes the rate.
TEST_F(StatesAtRest, AnEngineIdlesWhereItsGovernorHoldsIt) {
  for (const double initial : {60.0, 0.0, 240.0}) {
    write_state(kEngine, fmt::format(R"json({{ "initial": {}, "nominal": 100,
      "derivative": "table('engine', speed, throttle)/3" }})json",
                                     initial));
    const Outcome run = mbgen("simulate state.json --engine generic --duration 0.01 --out o.csv");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NEAR(table("o.csv").rows.front()[table("o.csv").column("x.speed [1]")], 59.07165737560818, 1e-6) << initial;
  }
}

TEST_F(StatesAtRest, AStateThatDriftsIsNamed) {
  write_state("", R"json({ "initial": 0, "nominal": 100, "derivative": 50 })json");
  const Outcome run = mbgen("equilibrium state.json");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("there is no static equilibrium near the initial state"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("; state speed changes by 50 a second"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace mbgen::cli_test
