// Notes on motions that no element takes part in.

#include "compiler/analysis/unrestrained.hpp"

#include <gtest/gtest.h>

#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A boom that turns about z and drives a slider by a rod; its only spring is elsewhere. elements: more sections.
std::size_t notes_with(const std::string& elements) {
  const Mechanism m = mechanism_of(R"({ "mbgen": 1, "name": "crane",
    "bodies": { "ground": { "points": { "O": [0, 0, 0], "side": [0.5, 1, 0], "rail": [2, 0, 0], "top": [5, 0, 2] } },
      "boom": { "mass": 3, "com": [0.4, 0.1, 0], "inertia": [1, 1, 1], "points": { "O": [0, 0, 0], "tip": [0.5, 0.5, 0] } },
      "slider": { "mass": 1, "inertia": [1, 1, 1], "points": { "O": [2, 0, 0] } },
      "load": { "mass": 1, "inertia": [1, 1, 1], "points": { "O": [5, 0, 2], "eye": [5, 0, 1] } } },
    "joints": { "turn": { "type": "revolute", "from": "ground.O", "to": "boom.O", "axis": "z" },
      "slide": { "type": "prismatic", "from": "ground.rail", "to": "slider.O", "axis": "x" },
      "lift": { "type": "prismatic", "from": "ground.top", "to": "load.O", "axis": "z" } },
    "rods": { "link": { "from": "boom.tip", "to": "slider.O", "mass": 0 } },
    "springs": { "hook": { "from": "ground.top", "to": "load.eye", "stiffness": 100 } })" +
                                   elements + " }");
  return unrestrained_motions(m.model, m.topology, m.analysis).size();
}

TEST(Unrestrained, EveryKindThatHoldsCounts) {
  EXPECT_EQ(notes_with(""), 1u);
  EXPECT_EQ(notes_with(R"(, "forces": { "push": { "at": "boom.tip", "force": [1, 0, 0] } })"), 1u) << "a force moves";
  for (const char* held :
       {R"(, "joint_springs": { "held": { "joint": "turn", "stiffness": 1 } })",
        R"(, "frictions": { "held": { "joint": "turn", "coulomb": 1, "velocity": 0.01 } })",
        R"(, "frictions": { "held": { "rod": "link", "end": "from", "coulomb": 1, "velocity": 0.01 } })",
        R"(, "bump_stops": { "held": { "joint": "turn", "side": "above", "clearance": 1, "stiffness": 1 } })",
        R"(, "bump_stops": { "held": { "from": "ground.side", "to": "boom.tip", "clearance": 1, "stiffness": 1 } })",
        R"(, "bump_stops": { "held": { "from": "ground.side", "to": "boom.tip", "axis": "y", "clearance": 1,
             "stiffness": 1 } })",
        R"(, "bushings": { "held": { "from": "ground.O", "to": "boom.O", "rz": { "stiffness": 1 } } })"})
    EXPECT_EQ(notes_with(held), 0u) << held;
}

}  // namespace
}  // namespace mbgen
