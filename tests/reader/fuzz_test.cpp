// Damaged models: whatever the text, the reader gives a model or diagnostics that stand inside the text.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

#include "compiler/reader/read_model.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

/// One of every kind of element.
const std::string kSeed = R"--({ "mbgen": 1, /* a comment */
"parameters": { "k": { "value": 3, "tunable": true }, "c": 2 }, "inputs": { "u": { "default": 7 } },
"hardpoints": { "H": [0, "c", 1] },
"bodies": {
  "ground": { "points": { "A": [0, 0, 0], "T": [0, 0, 2] } },
  "arm": { "mass": "k", "inertia": [1, 1, 1], "points": { "A": [0, 0, 0], "B": [1, 0, 0] } },
  "tip": { "mass": 1, "inertia": [1, 1, 1, 0.1, 0, 0], "points": { "B": [0, -1, 0] },
           "pose": { "rotation": [ { "axis": { "from": "H", "to": [0, 2, 2] }, "angle": { "deg": 90 } } ] } } },
"joints": { "pin": { "type": "revolute", "from": "ground.A", "to": "arm.A", "axis": "y" },
            "ball": { "type": "spherical", "sequence": "zxy", "from": "arm.B", "to": "tip.B" } },
"rods": { "r": { "from": "ground.T", "to": "tip.B" } },
"springs": { "s": { "from": "ground.H", "to": "arm.B", "stiffness": { "table": [[0, 0], [1, 1]] },
                  "force": "length*rate" } },
"air_springs": { "a": { "from": "ground.T", "to": "arm.B", "pressure": 6e5, "area": 0.01, "volume": 0.01 } },
"joint_springs": { "j": { "joint": "pin", "relative_to": "ball_rx", "stiffness": "k^2" } },
"frictions": { "f": { "joint": "pin", "velocity": "k", "coulomb": 1 } },
"forces": { "p": { "at": "arm.B", "force": [0, "sin(t)", 0] } },
"motions": { "m": { "joint": "ball_rz", "angle": "0.3*sin(2*pi*t)" } },
"tyre_data": { "d": { "model": "pac2002", "coefficients": { "UNLOADED_RADIUS": 0.5, "FNOMIN": 3e4 } } },
"tyres": { "w": { "centre": "tip.B", "data": "d", "stiffness": 1e6 } },
"outputs": { "y": { "tyre": "w" }, "q": { "spring": "a" },
             "e": { "expression": "select(z.pin, min(u, c), -z.ball_ry^2)" } },
"initial": { "positions": { "pin": { "value": { "deg": 3 }, "weight": 2, "locked": true } } },
"solver": { "step": 1e-3 } })--";

std::string damaged(std::mt19937& random) {
  constexpr const char* kPieces[] = {
      "{", "}", "[", "]",  "\"", "null", "-1", "1e300", "1e999", "\\",           "z.pin",
      "(", ",", ":", "/*", "//", "\xFF", "t",  "pin",   "0",     "{\"deg\": 1}", "\"k\""};
  std::string text = kSeed;
  for (unsigned change = random() % 3 + 1; change > 0; --change) {
    const std::size_t at = random() % text.size();
    switch (random() % 4) {
      case 0:
        text.erase(at, random() % 8 + 1);
        break;
      case 1:
        text.insert(at, kPieces[random() % std::size(kPieces)]);
        break;
      case 2:
        text[at] = static_cast<char>(random());
        break;
      default:
        text.insert(at, kSeed, random() % kSeed.size(), random() % 60);
        break;
    }
  }
  return text;
}

TEST(Fuzz, EveryTextGivesAModelOrDiagnosticsInsideTheText) {
  ASSERT_EQ(messages(kSeed), "");
  std::mt19937 random(20);
  int models = 0;
  constexpr int kTexts = 5000;
  for (int i = 0; i < kTexts; ++i) {
    const std::string text = damaged(random);
    const Result<Model> result = read_model(text, "fuzz.json");
    if (result) {
      ++models;
      for (const Body& body : result->bodies) ASSERT_TRUE(std::isfinite(body.mass.value)) << text;
      continue;
    }
    ASSERT_FALSE(result.problems().empty());
    const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
    for (const Diagnostic& problem : result.problems()) {
      ASSERT_GE(problem.where.line, 1) << text;
      ASSERT_LE(problem.where.line, lines) << text;
      ASSERT_GE(problem.where.column, 1) << text;
      ASSERT_LE(static_cast<std::size_t>(problem.where.column), problem.where.line_text.size() + 1) << text;
    }
  }
  EXPECT_GT(models, 10) << "the damage should leave some models whole";
}

}  // namespace
}  // namespace mbgen
