// Potential energy of elements: closed forms, and a sum with kinetic energy and gravity that stays.

#include <cmath>

#include "tests/support/dynamics.hpp"
#include "tests/support/model_support.hpp"
#include "tests/support/reaction_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A bob that hangs on an arm in a bushing, with springs of every kind and nothing that damps.
MechanismInState hung() {
  MechanismInState m(analysed(model_of(R"({ "mbgen": 1, "name": "hung", "gravity": [0, 0, -9.81],
    "bodies": {
      "ground": { "points": { "top": [0, 0, 0], "side": [0.3, 0.2, -0.4], "base": [0, 0, -1] } },
      "arm": { "mass": 2, "com": [0.4, 0, 0], "inertia": [0.01, 0.1, 0.1],
               "points": { "pivot": [0, 0, 0], "tip": [0.8, 0, 0] } },
      "bob": { "pose": { "origin": [0.8, 0, 0] }, "mass": 1, "inertia": [0.02, 0.03, 0.04],
               "points": { "at": [0, 0, 0], "low": [0, 0.1, -0.2] } } },
    "joints": {
      "hinge": { "type": "revolute", "from": "ground.top", "to": "arm.pivot", "axis": "y" },
      "loose": { "type": "free", "from": "arm.tip", "to": "bob.at" } },
    "springs": {
      "coil": { "from": "ground.side", "to": "bob.low", "stiffness": 300, "free_length": 0.5, "preload": 12 },
      "soft": { "from": "ground.base", "to": "arm.tip",
                "stiffness": { "table": [[-0.5, -20], [0, 0], [0.2, 30], [0.6, 50]], "interpolation": "spline" } } },
    "joint_springs": {
      "detent": { "joint": "hinge", "free": 0.1, "stiffness": { "table": [[-1, 0], [0, 3], [1, 1], [2, 0.5]],
                  "interpolation": "spline", "periodic": true } } },
    "bushings": {
      "rubber": { "from": "arm.tip", "to": "bob.at", "stiffness":
        [[4e3, 200, 0, 0, 30, 0], [200, 5e3, 0, 10, 0, 0], [0, 0, 6e3, 0, 0, 0],
         [0, 10, 0, 40, 2, 0], [30, 0, 0, 2, 50, 0], [0, 0, 0, 0, 0, 60]] } },
    "bump_stops": {
      "stop": { "joint": "hinge", "side": "above", "clearance": 0.3, "stiffness": 200, "exponent": 3 } },
    "outputs": {
      "kinetic": { "bodies": "all", "quantity": "kinetic_energy" },
      "gravity": { "bodies": "all", "quantity": "potential_energy" },
      "stored": { "elements": "all", "quantity": "potential_energy" },
      "coil": { "spring": "coil", "quantity": "potential_energy" },
      "soft": { "spring": "soft", "quantity": "potential_energy" },
      "detent": { "joint_spring": "detent" },
      "rubber": { "bushing": "rubber", "quantity": "potential_energy" },
      "stop": { "bump_stop": "stop", "quantity": "potential_energy" } } })")));
  m.set("hinge", 0, 2);
  return m;
}

/// Largest change of kinetic, gravitational and stored energy together within one second, J.
double change_of_energy(double h) {
  MechanismInState m = hung();
  const Dynamics dynamics{m.solver()};
  const std::vector<double> tau(m.state().z.size());
  double first = 0, largest = 0, deepest = 0;
  for (int k = 0; k <= std::lround(1 / h); ++k) {
    const std::vector<double> y = outputs_at(m.solver(), m.state(), tau);
    EXPECT_NEAR(y[2], y[3] + y[4] + y[5] + y[6] + y[7], 1e-13);
    if (k == 0) first = y[0] + y[1] + y[2];
    largest = std::max(largest, std::abs(y[0] + y[1] + y[2] - first));
    deepest = std::max(deepest, y[7]);
    EXPECT_TRUE(step_rk4(dynamics, m.state(), h).ok());
  }
  EXPECT_GT(deepest, 0.1);  // the stop is met
  return largest;
}

TEST(StoredEnergy, OfElementsAndTheBodiesStaysToTheOrderOfTheSteps) {
  const double coarse = change_of_energy(2e-3), fine = change_of_energy(1e-3);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_LT(fine, coarse / 12);
}

TEST(StoredEnergy, HasTheClosedFormsOfSprings) {
  Model model = model_of(R"({ "mbgen": 1, "name": "slide", "parameters": { "k": { "value": 50, "tunable": true } },
    "bodies": { "ground": { "points": { "O": [0, 0, 0], "wall": [1, 0, 0] } },
      "mass": { "mass": 1, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.O", "to": "mass.O", "axis": "x" } },
    "springs": { "line": { "from": "ground.wall", "to": "mass.O", "stiffness": "2*k", "preload": 7 },
      "bent": { "from": "ground.wall", "to": "mass.O", "free_length": 0.9,
                "stiffness": { "table": [[0, 0], [0.1, 10], [0.3, 50]] } } },
    "joint_springs": { "pull": { "joint": "slide", "stiffness": 30, "free": 0.2, "preload": 4 } },
    "bushings": { "rubber": { "from": "ground.O", "to": "mass.O",
      "tx": { "stiffness": 80, "damping": 5, "maxwell_stiffness": 60, "maxwell_time": 0.5 } } },
    "bump_stops": { "power": { "joint": "slide", "side": "above", "clearance": 0.1, "stiffness": 1000, "exponent": 1.5 },
      "table": { "joint": "slide", "side": "below", "clearance": 0.1, "stiffness": { "table": [[0, 0], [1, 40]] } } },
    "outputs": { "line": { "spring": "line", "quantity": "potential_energy" },
      "bent": { "spring": "bent", "quantity": "potential_energy" }, "pull": { "joint_spring": "pull" },
      "rubber": { "bushing": "rubber", "quantity": "potential_energy" },
      "power": { "bump_stop": "power", "quantity": "potential_energy" },
      "table": { "bump_stop": "table", "quantity": "potential_energy" } } })");
  MechanismInState m(analysed(std::move(model)));
  const auto energies = [&](double z, double extension) {
    m.set("slide", z, 1);
    m.state().x[0] = extension;
    return outputs_at(m.solver(), m.state(), {0});
  };
  std::vector<double> y = energies(0.35, 0.02);  // the springs are 0.65 m long
  EXPECT_NEAR(y[0], 0.5 * 100 * 0.35 * 0.35 - 7 * 0.35, 1e-13);
  EXPECT_NEAR(y[1], 0.5 * 100 * 0.25 * 0.25, 1e-13);  // the first piece goes on
  EXPECT_NEAR(y[2], 0.5 * 30 * 0.15 * 0.15 + 4 * 0.15, 1e-13);
  EXPECT_NEAR(y[3], 0.5 * 80 * 0.35 * 0.35 + 0.5 * 60 * 0.02 * 0.02, 1e-13);
  EXPECT_NEAR(y[4], 1000 * std::pow(0.25, 2.5) / 2.5, 1e-12);
  EXPECT_EQ(y[5], 0);
  y = energies(-0.1, 0);  // at the stop below; the springs are 1.1 m long
  EXPECT_NEAR(y[1], 0.5 * 10 * 0.1 + 0.1 * (10 + 30) / 2, 1e-13);
  EXPECT_EQ(y[4], 0);
  EXPECT_NEAR(y[5], 0, 1e-15);
  EXPECT_NEAR(energies(-0.6, 0)[5], 0.5 * 40 * 0.25, 1e-13);
}

}  // namespace
}  // namespace mbgen
