// A motion that a rope cannot follow, as it is told by every engine.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class Ropes : public CommandLine {};

/// A load that goes up at 2 m/s with the end of a taut rope, which then lifts off its wheel.
TEST_F(Ropes, NameTheWheelThatATautOneLiftsOff) {
  write("lift.json", R"({ "mbgen": 1, "name": "lift",
    "bodies": { "ground": { "points": { "A": [-1, 0, 0.1], "O": [0, 0, 0], "L": [1, 0, -1] } },
      "wheel": { "mass": 1, "inertia": [0.1, 0.1, 0.1], "points": { "O": [0, 0, 0] } },
      "load": { "mass": 1, "inertia": [1, 1, 1], "pose": { "origin": [1, 0, -1] }, "points": { "O": [0, 0, 0] } } },
    "joints": { "wheel": { "type": "revolute", "from": "ground.O", "to": "wheel.O", "axis": "y" },
      "load": { "type": "prismatic", "from": "ground.L", "to": "load.O", "axis": "z" } },
    "ropes": { "hoist": { "EA": 1e3, "pretension": 300, "path": [{ "point": "ground.A" },
      { "pulley": "wheel.O", "axis": "y", "radius": 0.1, "sense": "positive" }, { "point": "load.O" }] } },
    "motions": { "load": { "joint": "load", "position": "2*t" } },
    "solver": { "step": 1e-3, "duration": 1 } })");
  for (const char* engine : {"generated", "generic", "augmented"}) {
    const Outcome done = mbgen(fmt::format("simulate lift.json --engine {} --out lift.csv", engine));
    EXPECT_EQ(done.exit_code, 1) << engine;
    EXPECT_NE((done.out + done.err).find("taut rope lifts off a pulley, or has no way: hoist at wheel.O"),
              std::string::npos)
        << engine << done.out << done.err;
  }
}

}  // namespace
}  // namespace mbgen::cli_test
