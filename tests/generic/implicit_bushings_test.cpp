// Implicit steps of models in rubber: the matrix of bushings, and a step that Runge-Kutta does not bear.

#include <cstdio>

#include "tests/support/implicit_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A plate on a bushing with a full matrix and a Maxwell branch, held by another one to an arm; at rest in their
/// middle.
constexpr const char* kRubberBlock = R"json({ "mbgen": 1, "name": "rubber", "gravity": [0, 0, 0],
  "bodies": {
    "ground": { "points": { "a": [0, 0, 0], "m": [0.5, 0.1, 0.2] } },
    "arm": { "mass": 2, "com": [0, 0, 0.2], "inertia": [0.03, 0.03, 0.002],
      "points": { "a": [0, 0, 0], "tip": [0.1, 0, 0.4] } },
    "plate": { "mass": 3, "com": [0.4, 0.1, 0.3], "inertia": [0.1, 0.2, 0.15],
      "points": { "m": [0.5, 0.1, 0.2], "tip": [0.1, 0, 0.4], "o": [0.4, 0.1, 0.3] } }
  },
  "joints": {
    "arm": { "type": "revolute", "from": "ground.a", "to": "arm.a", "axis": "y" },
    "plate": { "type": "free", "from": "ground.m", "to": "plate.m" }
  },
  "bushings": {
    "mount": { "from": "ground.m", "to": "plate.m", "axis": [1, 0.2, 0.1],
      "stiffness": [[3e7, 200, 0, 0, 7e3, 0], [200, 5e6, 0, -900, 0, 0], [0, 0, 2e5, 0, 0, 100],
        [0, -900, 0, 150, 5, 0], [7e3, 0, 0, 5, 140, 0], [0, 0, 100, 0, 0, 60]],
      "tx": { "damping": 4e3, "maxwell_stiffness": 2e6, "maxwell_time": 1e-3 },
      "rz": { "force": "40*sin(deflection) + 2*tanh(rate)" } },
    "between": { "from": "arm.tip", "to": "plate.tip", "axis": "y",
      "radial": { "stiffness": 1e7, "damping": 1500 }, "tz": { "stiffness": 1e5, "damping": 60 },
      "conical": { "stiffness": 800, "damping": 0.6 }, "rz": { "stiffness": 60 } }
  }
})json";

TEST(Implicit, MatrixOfBushingsIsThatOfTheirLaws) {
  const Free rubber{mechanism_of(kRubberBlock)};
  const GenericState state = reference_state(rubber.m);
  ASSERT_LT(rubber.rates(state).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT(largest_difference(rubber.matrix(state), rubber.differences(state)), 1e-7);
}

// Stiff arms, up to 730 Hz: at a millisecond beyond Runge-Kutta's region. They start at rest under the load that the
// road then changes: released from anywhere else they ring, which steps of a millisecond damp instead of following.
TEST(Implicit, WishboneInRubberAtAMillisecond) {
  const Free wishbone{load("models/rubber_wishbone.json")};
  GenericState start = reference_state(wishbone.m);
  ASSERT_TRUE(wishbone.solver.equilibrium(start).ok());
  constexpr double kDuration = 0.03;
  const std::vector<double> exact = positions_after(wishbone, start, kDuration, 300, false),
                            implicit = positions_after(wishbone, start, kDuration, 30, true);
  ASSERT_FALSE(exact.empty());
  ASSERT_FALSE(implicit.empty());
  double moved = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) moved = std::max(moved, std::abs(exact[i] - start.z[i]));
  const double error = distance_of(implicit, exact);
  std::printf("wishbone in rubber at 1 ms: error %.2e of %.2e\n", error, moved);
  EXPECT_LT(error, 1e-3 * moved);
  const std::vector<double> diverged = positions_after(wishbone, start, kDuration, 30, false);
  EXPECT_TRUE(diverged.empty() || !(distance_of(diverged, exact) < moved));
}

}  // namespace
}  // namespace mbgen
