// Inputs of a run that make what the reader refuses as a number of the file.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {
namespace {

class InputBounds : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    write("block.json", R"({ "mbgen": 1, "name": "block", "gravity": [0, 0, -9.81],
        "inputs": { "grip": { "default": 1 }, "flow": { "default": 5, "max": 9 } },
        "bodies": { "ground": { "points": { "O": [0, 0, 0], "Q": [0, 0, 1] } },
                    "p": { "mass": 1, "com": [0, 0, 0], "inertia": [1, 1, 1], "points": { "P": [0, 0, 0] } } },
        "joints": { "slide": { "type": "prismatic", "from": "ground.O", "to": "p.P", "axis": "z" } },
        "springs": { "s": { "from": "ground.Q", "to": "p.P", "stiffness": 100, "damping": "flow - 2" } },
        "frictions": { "f": { "joint": "slide", "coulomb": "grip", "velocity": 0.1 } } })");
  }
  Json run(const std::string& with) {
    return json_of("simulate block.json --engine generic --duration 0.1 --step 0.001 --out m.csv --json " + with);
  }
};

TEST_F(InputBounds, AreWarningsOfARun) {
  EXPECT_EQ(run("")["status"], "ok");
  Json report = run("--input grip=-3");
  EXPECT_EQ(report["status"], "1 warning");
  EXPECT_EQ(report["warnings"][0], "input grip is -3 at t = 0 s, its least value is 0");
  report = run("--input flow=1");
  EXPECT_EQ(report["warnings"][0], "inputs at t = 0 s make what no model may have: damping of s");
  report = run("--input flow=10");
  EXPECT_EQ(report["warnings"][0], "input flow is 10 at t = 0 s, its largest value is 9");
  write("flow.csv", "t,flow\n0,5\n0.05,1.5\n");
  report = run("--input-table flow.csv");
  EXPECT_EQ(report["warnings"][0], "inputs at t = 0.05 s make what no model may have: damping of s");
}

TEST_F(InputBounds, AreWarningsOfACase) {
  const Outcome done = mbgen(
      "sweep block.json --engine generic --vary grip=-3,1 --duration 0.1 --step 0.001 --metric \"max(z.slide)\" --out "
      "s.csv");
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_NE(read("s.csv").find("\"warning: input grip is -3 at t = 0 s, its least value is 0\""), std::string::npos)
      << read("s.csv");
}

}  // namespace
}  // namespace mbgen::cli_test
