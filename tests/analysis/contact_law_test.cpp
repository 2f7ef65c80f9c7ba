// The law of a contact and its derivatives, which implicit steps use.

#include <cmath>
#include <random>

#include "compiler/analysis/configuration.hpp"
#include "compiler/formulation/elements/every_kind.hpp"
#include "tests/support/model_support.hpp"
#include "tests/support/reaction_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
using S = Slope<double>;

/// Penetration, its rate, two speeds of sliding, two deflections.
using Arguments = std::array<double, 6>;
/// Force along the normal, two forces across it, two rates of bristles.
using Results = std::array<double, 5>;

class ContactLaw : public ::testing::Test {
 protected:
  ContactLaw()
      : m_(analysed(model_of(R"({ "mbgen": 1, "name": "ball",
          "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
            "ball": { "mass": 1, "inertia": [1, 1, 1], "points": { "C": [0, 0, 0] } } },
          "joints": { "ball": { "type": "free", "from": "ground.O", "to": "ball.C" } },
          "contacts": { "c": { "from": "ball.C", "radius": 0.1, "to": "ground.O", "stiffness": 1e5, "exponent": 1.5,
            "damping": 0.3, "friction": 0.4, "stiction": 0.6, "stribeck_velocity": 0.3, "bristle": 1e-3,
            "bristle_damping": 1e-3, "lag": 0.01 } } })"))),
        numbers_(m_.model, m_.topology),
        system_(numbers_.at(std::vector<double>(m_.topology.bodies.size(), 0.0))),
        k_(kinematics(system_)),
        v_(velocities(system_, k_)) {}

  template <class A>
  std::array<A, 5> law(const std::array<A, 6>& at) {
    AppliedForces<double> none;
    const detail::ForceWork<double> work{system_, k_, v_, none};
    const A slip[2] = {at[2], at[3]}, deflection[2] = {at[4], at[5]};
    const auto forces = detail::contact_law(work, m_.model.contacts[0], 1.0, at[0], at[1], slip, deflection);
    return {forces.normal, forces.across[0], forces.across[1], forces.rate[0], forces.rate[1]};
  }

  /// Derivatives of all results by one argument.
  Results slopes(const Arguments& at, std::size_t by) {
    std::array<S, 6> moved;
    for (std::size_t i = 0; i < at.size(); ++i) moved[i] = S(at[i], i == by ? 1.0 : 0.0);
    const std::array<S, 5> results = law(moved);
    Results slopes;
    for (std::size_t i = 0; i < slopes.size(); ++i) slopes[i] = results[i].slope;
    return slopes;
  }

  Results differences(Arguments at, std::size_t by) {
    const double h = 1e-6 * std::max(std::abs(at[by]), 1e-3);
    at[by] += h;
    const Results above = law(at);
    at[by] -= 2 * h;
    const Results below = law(at);
    Results slopes;
    for (std::size_t i = 0; i < slopes.size(); ++i) slopes[i] = (above[i] - below[i]) / (2 * h);
    return slopes;
  }

  Mechanism m_;
  NumericSystem numbers_;
  System<double>& system_;
  Kinematics<double> k_;
  Velocities<double> v_;
};

TEST_F(ContactLaw, HasItsTangents) {
  std::mt19937_64 dice(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int n = 0; n < 200; ++n) {
    // Bristles below their limit of sliding, 2/3 mm, so that no derivative is limited.
    const Arguments at{0.01 + 0.005 * any(dice), any(dice),         any(dice), any(dice),
                       0.4e-3 * any(dice),       0.4e-3 * any(dice)};
    for (std::size_t by = 0; by < at.size(); ++by) {
      const Results exact = slopes(at, by), close = differences(at, by);
      for (std::size_t i = 0; i < exact.size(); ++i)
        EXPECT_NEAR(exact[i], close[i], 1e-5 * (std::abs(close[i]) + (i < 3 ? 1.0 : 1e-3)))
            << n << " " << by << " " << i;
    }
  }
}

// Beyond their limit bristles spring back: by their deflection the rate has its derivative, by the speed none that
// would make them faster.
TEST_F(ContactLaw, LimitsTheTangentsOfBristlesBeyondTheirEnd) {
  const Arguments at{0.01, 0, 0.3, 0, 1.2e-3, 0};
  EXPECT_NEAR(slopes(at, 4)[3], differences(at, 4)[3], 1e-4 * std::abs(differences(at, 4)[3]));
  EXPECT_LT(slopes(at, 4)[3], -1);
  const Arguments slow{0.01, 0, 1e-3, 0, 1.2e-3, 0};
  EXPECT_LT(differences(slow, 2)[3], -0.01);
  EXPECT_GT(slopes(slow, 2)[3], -1e-3);
}

}  // namespace
}  // namespace mbgen
