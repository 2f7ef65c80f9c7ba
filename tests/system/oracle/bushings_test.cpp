// Bushings against Simbody's LinearBushing. It counts rotations by three angles, mbgen by the rotation vector: they
// agree where the bodies turn about one axis of the bushing, and to first order in the angles everywhere.

#include <cstdio>

#include "tests/support/reaction_support.hpp"
#include "tests/system/oracle/oracle_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

constexpr std::array<double, 6> kStiffness = {900, 700, 400, 30, 45, 20}, kDamping = {8, 5, 9, 0.4, 0.3, 0.6};

/// A body that moves in space and one that moves on it by `joint`, with a bushing from the first to the second.
Mechanism pair(const std::string& joint) {
  std::string laws;
  for (std::size_t i = 0; i < kStiffness.size(); ++i)
    laws += ", \"" + std::string(kBushingFreedomNames[i]) + "\": { \"stiffness\": " + std::to_string(kStiffness[i]) +
            ", \"damping\": " + std::to_string(kDamping[i]) + " }";
  return analysed(model_of(R"({ "mbgen": 1, "name": "pair",
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
      "first": { "mass": 2, "com": [0.1, 0.2, 0], "inertia": [0.3, 0.4, 0.5, 0.02, 0.01, 0.03],
                 "points": { "O": [0, 0, 0], "seat": [0.6, 0, 0.4], "eye": [0.4, 0.1, 0.3] } },
      "second": { "mass": 3, "com": [0.6, 0, 0.4], "inertia": [0.6, 0.4, 0.3],
                  "points": { "O": [0.6, 0, 0.4], "eye": [0.4, 0.1, 0.3] } } },
    "joints": { "first": { "type": "free", "from": "ground.O", "to": "first.O" },
                "second": { "type": )" +
                           joint + R"(, "from": "first.seat", "to": "second.O" } },
    "bushings": { "rubber": { "from": "first.eye", "to": "second.eye", "axis": [1, 2, 3], "axis2": [1, 0, 0.5])" +
                           laws + " } } }"));
}

/// The same with Simbody's own bushing.
foreign::SimbodyMechanism with_linear_bushing(const Mechanism& m) {
  foreign::ForceElements elements = *foreign::force_elements_of(m.model, m.topology);
  elements.linear_frames.push_back({elements.frames.front(), kStiffness, kDamping});
  elements.frames.clear();
  return foreign::SimbodyMechanism(foreign::reference_mechanism(m.model, m.topology), elements);
}

/// Largest relative difference of accelerations at random states.
double difference(const std::string& joint, double reach) {
  const Mechanism m = pair(joint);
  const GenericSolver solver(m.model, m.topology, m.analysis);
  foreign::SimbodyMechanism simbody = with_linear_bushing(m);
  const std::vector<double> tau(static_cast<std::size_t>(m.topology.size()), 0.0);
  double error = 0;
  for (const GenericState& state : random_states(m, 5, reach)) {
    GenericDerivative derivative;
    EXPECT_TRUE(solver.accelerations(state, tau, derivative).ok());
    error = std::max(error, relative_error(simbody.accelerations(foreign_state(state, tau)), derivative.zdd));
  }
  std::printf("bushing on %s, angles to %g rad: accelerations as with LinearBushing, %.1e relative\n", joint.c_str(),
              reach, error);
  return error;
}

class BushingInSimbody : public InSimbody<std::string> {};

TEST_P(BushingInSimbody, IsTheLinearBushing) {
  // Along and about an axis of the bushing, however far.
  EXPECT_LT(difference("\"cylindrical\", \"axis\": " + GetParam(), 1.5), 1e-9);
  // In space the two measures of a rotation part with the angle.
  const double small = difference("\"free\"", 1e-4), larger = difference("\"free\"", 1e-3);
  EXPECT_LT(small, 2e-3);
  EXPECT_LT(larger, 2e-2);
  EXPECT_GT(larger, 3 * small);
}

INSTANTIATE_TEST_SUITE_P(Axes, BushingInSimbody, ::testing::Values("[1, 2, 3]", "[23, -10, -1]"));

}  // namespace
}  // namespace mbgen
