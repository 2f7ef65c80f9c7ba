#pragma once
// A quarter vehicle with measured data of others, and a block on a spring with data in closed form.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {

/// A block on a spring, released at rest: x(t) = x0 + start cos(sqrt(stiffness / mass) t), with x0 = force / stiffness
/// where the force acts from the start.
inline constexpr const char* kBlock = R"({ "mbgen": 1, "name": "block", "gravity": [0, 0, 0],
  "parameters": { "mass": { "value": 2, "unit": "kg" }, "stiffness": { "value": 50, "unit": "N/m" },
    "start": { "value": 0.1, "unit": "m" } },
  "inputs": { "force": { "unit": "N", "default": 0 } },
  "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
    "block": { "mass": "mass", "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
  "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "block.A", "axis": "x" } },
  "joint_springs": { "spring": { "joint": "slide", "stiffness": "stiffness" } },
  "joint_forces": { "push": { "joint": "slide", "force": "force" } },
  "initial": { "positions": { "slide": "start" } },
  "outputs": { "x": { "unit": "m", "expression": "z.slide" }, "v": { "unit": "m/s", "expression": "zd.slide" } } })";

class Fit : public CommandLine {
 protected:
  void SetUp() override {
    if (mbgen("fit none.json --data a --match b --free c").err.find("without Ceres") != std::string::npos)
      GTEST_SKIP() << "built without Ceres";
    write("block.json", kBlock);
  }

  /// The reference, and its data as run.csv.
  Json quarter_vehicle() const {
    std::ifstream file(kSource + "/tests/data/reference/fit_quarter_vehicle.json");
    const Json reference = Json::parse(file);
    std::string text = "t [s],body_acceleration [m/s^2],spring_length [m]\n";
    for (const Json& row : reference["data"])
      text += fmt::format("{},{},{}\n", row[0].get<double>(), row[1].get<double>(), row[2].get<double>());
    write("run.csv", text);
    return reference;
  }

  /// x of the block with this angular frequency at times `step` apart, through a channel with gain, bias and delay.
  static std::string block_data(double omega, double start, double step, double gain = 1, double bias = 0,
                                double delay = 0) {
    std::string text = "t [s],x [m]\n";
    for (int k = 0; k * step <= 4; ++k) {
      const double t = k * step;
      text += fmt::format("{},{}\n", t, gain * start * std::cos(omega * std::max(0.0, t - delay)) + bias);
    }
    return text;
  }
};

inline const std::string kVehicle = kSource +
                                    "/models/fit/quarter_vehicle.json --step 5e-4 --data run.csv "
                                    "--match body_acceleration:0.08,spring_length:2e-4 ";

}  // namespace mbgen::cli_test
