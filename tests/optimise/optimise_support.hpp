#pragma once
// Models whose best designs are closed forms.

#include "tests/support/cli_support.hpp"

namespace mbgen::cli_test {

/// Formulas of two parameters as outputs at the start.
inline constexpr const char* kForms = R"({ "mbgen": 1, "name": "forms",
  "parameters": { "p": { "value": 0.4, "unit": "m" }, "q": { "value": 0.6, "unit": "m" }, "twice": "2 * p" },
  "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
    "block": { "mass": 1, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
  "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "block.A", "axis": "x" } },
  "initial": { "positions": { "slide": 0.1 } },
  "outputs": { "near": { "unit": "m^2", "expression": "p*p + q*q" },
    "far": { "unit": "m^2", "expression": "(p - 1)^2 + q*q" }, "sum": { "unit": "m", "expression": "p + q" },
    "bowl": { "unit": "m^2", "expression": "(p - 2)^2 + (q - 1)^2" },
    "valleys": { "unit": "1", "expression": "(p*p - 1)^2 + 0.2*p + q*q" },
    "root": { "unit": "m", "expression": "sqrt(p - 0.2) - 0.1*p" },
    "verge": { "unit": "m^2", "expression": "p*p + 1e-30*sqrt(p) + 0" } } })";

/// A block on a spring and a damper, released at rest: x'' + 2 d w x' + w^2 x = 0.
inline constexpr const char* kDamped = R"({ "mbgen": 1, "name": "damped", "gravity": [0, 0, 0],
  "parameters": { "mass": { "value": 2, "unit": "kg" }, "stiffness": { "value": 50, "unit": "N/m" },
    "damping": { "value": 3, "unit": "N s/m" }, "start": { "value": 0.1, "unit": "m" } },
  "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
    "block": { "mass": "mass", "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } } },
  "joints": { "slide": { "type": "prismatic", "from": "ground.A", "to": "block.A", "axis": "x" } },
  "joint_springs": { "spring": { "joint": "slide", "stiffness": "stiffness", "damping": "damping" } },
  "initial": { "positions": { "slide": "start" } },
  "outputs": { "x": { "unit": "m", "expression": "z.slide" }, "v": { "unit": "m/s", "expression": "zd.slide" } },
  "solver": { "step": 5e-3, "duration": 8 } })";

class Optimise : public CommandLine {
 protected:
  void SetUp() override {
    if (mbgen("optimise none.json --free p --goal min:start:x").err.find("without NLopt") != std::string::npos)
      GTEST_SKIP() << "built without NLopt";
    write("forms.json", kForms);
    write("damped.json", kDamped);
  }

  /// The entry of this name in a list of a result.
  static Json entry(const Json& result, const char* list, const std::string& name) {
    for (const Json& one : result[list])
      if (one["name"] == name) return one;
    ADD_FAILURE() << "no " << name << " among " << list;
    return {};
  }
  static double value_of(const Json& result, const std::string& name) {
    return entry(result, "variables", name)["value"];
  }
};

}  // namespace mbgen::cli_test
