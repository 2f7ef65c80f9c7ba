// A motion that a rope cannot follow, as it is told by every engine.

#include <sstream>

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

// A ball on ropes and a floor as a unit: the steps of the solver.
TEST_F(Ropes, AndContactsMoveInAnFmuAsInTheSolver) {
  const std::string model = kSource + "/tests/data/models/hung_ball.json";
  const Outcome done = mbgen("export " + model + " --fmi 2 --platform x86_64-linux -o ball.fmu");
  ASSERT_EQ(done.exit_code, 0) << done.err;
  ASSERT_EQ(shell("cmake -E tar xf ball.fmu").exit_code, 0);
  write("step.py", "import sys\nsys.dont_write_bytecode = True\nsys.path.insert(0, '" + kSource + R"(/tests/support')
from fmi2_unit import OK, Unit
unit = Unit("binaries/linux64/hung_ball.so", "modelDescription.xml")
unit.enter_initialisation()
unit.exit_initialisation()
for k in range(400):
    assert unit.step(k * 5e-4, 5e-4) == OK
print(*(repr(unit.real(name)) for name in ("line_1", "hoist", "load", "stored")))
)");
  const Outcome stepped = shell("python3 step.py");
  ASSERT_EQ(stepped.exit_code, 0) << stepped.err;
  ASSERT_EQ(mbgen("simulate " + model + " --engine generic --duration 0.2 --out ball.csv").exit_code, 0);
  const Table motion = table("ball.csv");
  std::istringstream words(stepped.out);
  for (const char* name : {"line_1 [N]", "hoist [N]", "load [N]", "stored [J]"}) {
    double value = 0;
    words >> value;
    EXPECT_NEAR(value, motion.last(name), 1e-8) << name;
  }
}

}  // namespace
}  // namespace mbgen::cli_test
