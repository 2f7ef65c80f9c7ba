#pragma once
// A small model for the targets that read tables beside a model.

#include "compiler/compile.hpp"
#include "compiler/reader/read_model.hpp"
#include "fuzz_support.hpp"

namespace mbgen::fuzz {

constexpr const char* kModel = R"({ "mbgen": 1,
  "inputs": { "steer": { "unit": "rad" }, "rate": {} },
  "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
              "arm": { "mass": 1, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0], "B": [1, 0, 0] } },
              "tip": { "mass": 1, "inertia": [1, 1, 1], "points": { "B": [0, 0, 0] }, "pose": { "origin": [1, 0, 0] } } },
  "joints": { "pin": { "type": "revolute", "from": "ground.A", "to": "arm.A", "axis": "y" },
              "ball": { "type": "universal", "from": "arm.B", "to": "tip.B", "axis": "x", "axis2": "y" } } })";

/// Model and tree; analysis and programs stay empty.
inline Compilation small_compilation() {
  const Result<Model> model = read_model(kModel, "model.json");
  require(static_cast<bool>(model), "the model of the target is one");
  return {*model, *build_topology(*model), {}, {}};
}

}  // namespace mbgen::fuzz
