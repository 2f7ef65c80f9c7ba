#pragma once
// Parameter studies of a mass on a spring.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {

/// A mass on a spring, released at rest: x(t) = amplitude cos(sqrt(stiffness / mass) t) + force / stiffness (1 - cos).
/// `tilt` stands where a number has to be constant.
inline constexpr const char* kSpring = R"({ "mbgen": 1, "name": "spring", "gravity": [0, 0, 0],
  "parameters": { "mass": { "value": 2, "unit": "kg" }, "stiffness": { "value": 50, "unit": "N/m" },
    "amplitude": 0.1, "double_amplitude": "2 * amplitude", "tilt": 0 },
  "inputs": { "force": { "unit": "N", "default": 0 } },
  "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
    "block": { "mass": "mass", "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
  "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "block.A", "axis": [1, "tilt", 0] } },
  "joint_springs": { "spring": { "joint": "slide", "stiffness": "stiffness" } },
  "joint_forces": { "push": { "joint": "slide", "force": "force" } },
  "initial": { "positions": { "slide": "amplitude" } },
  "outputs": { "x": { "unit": "m", "expression": "z.slide" }, "v": { "unit": "m/s", "expression": "zd.slide" } } })";

inline constexpr const char* kGrid = "--vary mass=1:0.5:3 --vary stiffness=20,80,50 ";
inline constexpr long kCases = 15;
inline constexpr const char* kMetrics = "--metric 'max(abs(x))' --metric 'speed=max(v)' --metric 'rms(x - mean(x))' ";

class Sweep : public CommandLine {
 protected:
  Sweep() { write("spring.json", kSpring); }

  /// The bytes of a study's table, in one go on one processor.
  std::string table_of(const std::string& words) const {
    const Outcome run = mbgen("sweep spring.json " + words + " --jobs 1 --out expected.csv");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return read("expected.csv");
  }

  /// Numbers of the cases in all journals of a table, sorted.
  std::vector<long> journalled(const std::string& table) const {
    std::vector<long> cases;
    for (const std::string& name : leftovers()) {
      if (!name.starts_with(table + ".journal")) continue;
      std::istringstream lines(read(name));
      std::string line;
      std::getline(lines, line);
      while (std::getline(lines, line)) cases.push_back(std::stol(line.substr(line.find(' '))));
    }
    std::sort(cases.begin(), cases.end());
    return cases;
  }
};

}  // namespace mbgen::cli_test
