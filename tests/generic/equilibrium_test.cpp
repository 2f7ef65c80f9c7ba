// Static equilibrium: by hand where a hand can, the truck from the air, and what has none.

#include <cmath>
#include <numbers>

#include "tests/support/mechanism_support.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A mass of 2 kg that slides on z and a bob of 3 kg, 0.5 m below a pin about y, each with a spring to taste.
std::string mass_and_bob(const std::string& joint_springs) {
  return R"({ "mbgen": 1, "gravity": [0, 0, -9.81],
    "bodies": {
      "ground": { "points": { "A": [0, 0, 0], "B": [1, 0, 0] } },
      "mass": { "mass": 2, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } },
      "bob": { "mass": 3, "com": [1, 0, -0.5], "inertia": [0, 0, 0], "points": { "B": [1, 0, 0] } }
    },
    "joints": {
      "slide": { "type": "prismatic", "from": "ground.A", "to": "mass.A", "axis": "z" },
      "pin": { "type": "revolute", "from": "ground.B", "to": "bob.B", "axis": "y" }
    },
    "joint_springs": { )" +
         joint_springs + " } }";
}

TEST(Equilibrium, MassHangsOnItsSpring) {
  const Mechanism m = mechanism_of(mass_and_bob(R"("soft": { "joint": "slide", "stiffness": 15, "free": 0.4 })"));
  GenericState state = reference_state(m);
  state.zd = {3, 1};
  ASSERT_TRUE(GenericSolver(m.model, m.topology, m.analysis).equilibrium(state).ok());
  EXPECT_NEAR(state.z[0], 0.4 - 2 * 9.81 / 15, 1e-10);
  EXPECT_EQ(state.zd, std::vector<double>(2, 0.0));
}

// Sources of the values: cos(q) = q for a spring that holds the bob at 1 rad if it hung level, and m g / k.
TEST(Equilibrium, SmallPartsBesideALargeOneComeToRest) {
  const Mechanism m = mechanism_of(R"({ "mbgen": 1, "gravity": [0, 0, -9.81],
    "bodies": {
      "ground": { "points": { "A": [0, 0, 0], "B": [0, 0, 1] } },
      "bob": { "mass": 1e-12, "com": [1e-4, 0, 0], "inertia": [0, 0, 0], "points": { "A": [0, 0, 0] } },
      "large": { "mass": 2, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0] } }
    },
    "joints": {
      "pin": { "type": "revolute", "from": "ground.A", "to": "bob.A", "axis": "y" },
      "slide": { "type": "prismatic", "from": "ground.A", "to": "large.A", "axis": "z" }
    },
    "springs": { "large": { "from": "ground.B", "to": "large.A", "stiffness": 2e5 } },
    "joint_springs": { "hair": { "joint": "pin", "stiffness": 9.81e-16 } } })");
  GenericState state = reference_state(m);
  ASSERT_TRUE(GenericSolver(m.model, m.topology, m.analysis).equilibrium(state).ok());
  EXPECT_NEAR(state.z[0], 0.73908513321516064, 1e-9);
  EXPECT_NEAR(state.z[1], -2 * 9.81 / 2e5, 1e-12);
}

// A step of Newton from near the top would end at the top.
TEST(Equilibrium, BobGoesDownhillFromNearTheTop) {
  const Mechanism m = mechanism_of(mass_and_bob(R"("soft": { "joint": "slide", "stiffness": 15 })"));
  const GenericSolver solver(m.model, m.topology, m.analysis);
  for (const double start : {3.0, -3.0, 1.6}) {
    GenericState state = reference_state(m);
    state.z[1] = start;
    ASSERT_TRUE(solver.equilibrium(state).ok()) << start;
    EXPECT_NEAR(state.z[1], 0, 1e-10) << start;
  }
}

// A lift on scissors whose cylinder pushes with one force: it sinks from below the balance and rises from above.
TEST(Equilibrium, OneThatHoldsNothingIsFoundNearby) {
  const Mechanism m = mechanism_of(R"({ "mbgen": 1, "name": "lift", "gravity": [0, 0, -9.81],
    "bodies": {
      "ground": { "points": { "A": [0, 0, 0], "rail": [1, 0, 0] } },
      "arm": { "mass": 2, "com": [0.5, 0, 0.25], "inertia": [0.2, 0.2, 0.2],
               "points": { "A": [0, 0, 0], "mid": [0.5, 0, 0.25] } },
      "strut": { "mass": 1, "com": [0.75, 0, 0.125], "inertia": [0.1, 0.1, 0.1],
                 "points": { "mid": [0.5, 0, 0.25], "foot": [1, 0, 0] } },
      "roller": { "mass": 1, "com": [1, 0, 0], "inertia": [0.1, 0.1, 0.1], "points": { "rail": [1, 0, 0] } } },
    "joints": {
      "arm": { "type": "revolute", "from": "ground.A", "to": "arm.A", "axis": "y" },
      "mid": { "type": "revolute", "from": "arm.mid", "to": "strut.mid", "axis": "y" },
      "rail": { "type": "prismatic", "from": "ground.rail", "to": "roller.rail", "axis": "x" },
      "foot": { "type": "revolute", "from": "roller.rail", "to": "strut.foot", "axis": "y", "cut": true } },
    "joint_forces": { "cylinder": { "joint": "rail", "force": -25 } } })");
  const GenericSolver solver(m.model, m.topology, m.analysis);
  GenericState state = reference_state(m);
  ASSERT_TRUE(solver.equilibrium(state).ok());
  int rail = 0;
  while (m.topology.bodies[rail].coordinate != "rail") ++rail;
  // Virtual work: the middle falls by span / (4 height) as the span grows, and the strut's centre by half of that.
  const double span = 1 + state.z[static_cast<std::size_t>(rail)], height = std::sqrt(0.3125 - span * span / 4);
  EXPECT_NEAR(2.5 * 9.81 * span / (4 * height), 25, 1e-8);
  GenericDerivative rates;
  ASSERT_TRUE(solver.accelerations(state, std::vector<double>(state.z.size(), 0.0), rates).ok());
  EXPECT_LT(largest_absolute(rates.zdd), 1e-8);
}

TEST(Equilibrium, FallingMassHasNone) {
  const Mechanism m = mechanism_of(mass_and_bob(""));
  GenericState state = reference_state(m);
  state.z[1] = 0.3;
  EXPECT_EQ(GenericSolver(m.model, m.topology, m.analysis).equilibrium(state).code, Code::no_equilibrium);
  EXPECT_LT(state.z[0], -1) << "the search ends where it sank to";
}

// With the road far below its wheels the truck comes down and stands as it does on the road at its wheels.
TEST(Equilibrium, TruckComesDownToItsRoad) {
  const auto standing = [](double lower) {
    Mechanism m = load("models/truck.json");
    for (Tyre& tyre : m.model.tyres) tyre.road_height = Quantity(tyre.road_height.value - lower);
    const GenericSolver solver(m.model, m.topology, m.analysis);
    GenericState state = reference_state(m);
    EXPECT_TRUE(solver.equilibrium(state).ok()) << lower;
    EXPECT_LT(largest_absolute(solver.position_residuals(state)), 1e-12);
    const std::vector<double> no_tau(state.z.size(), 0.0);
    GenericDerivative derivative;
    EXPECT_TRUE(solver.accelerations(state, no_tau, derivative).ok());
    EXPECT_LT(largest_absolute(derivative.zdd), 1e-6) << lower;
    std::vector<double> loads;
    const std::vector<double> y = solver.outputs(state, no_tau, derivative).y;
    for (std::size_t i = 0; i < y.size(); ++i)
      if (m.model.outputs[i].name.starts_with("load")) loads.push_back(y[i]);
    return loads;
  };
  const std::vector<double> near = standing(0), far = standing(0.3);
  ASSERT_EQ(near.size(), 10u);
  EXPECT_LT(relative_error(far, near), 1e-6);  // standing tyres may be strained sideways in more than one way
}

}  // namespace
}  // namespace mbgen
