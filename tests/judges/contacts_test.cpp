// Contacts of every shape: forces as the slope of their energy, the judges' own geometry, the cone of friction.

#include <cmath>
#include <random>

#include "runtime/judges/cartesian.hpp"
#include "tests/support/dynamics.hpp"
#include "tests/support/model_support.hpp"
#include "tests/support/reaction_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// Fields of contacts; the centre of the surface is at the origin.
constexpr const char* kTouched[] = {
    R"("to": "block.O", "axis": [1, 2, 2])",
    R"("shape": "sphere", "to": "block.O", "to_radius": 0.3)",
    R"("shape": "cylinder", "to": "block.O", "axis": [1, 2, 2], "to_radius": 0.25)",
    R"("shape": "cylinder", "to": "block.O", "axis": [1, 2, 2], "to_radius": 0.25, "length": 0.5)",
    R"("shape": "box", "to": "block.O", "axis": [1, 2, 2], "axis2": [0, 1, 0], "size": [0.4, 0.5, 0.6])",
    R"("road": "slope")",
};

/// A ball beside a body that swings; both move freely.
std::string pair_of(const std::string& surface, const std::string& more) {
  return R"x({ "mbgen": 1, "name": "pair", "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
      "block": { "mass": 3, "com": [0.1, 0, 0], "inertia": [0.2, 0.3, 0.4], "points": { "O": [0, 0, 0] } },
      "ball": { "mass": 2, "com": [0, 0.05, 0], "inertia": [0.02, 0.03, 0.04], "points": { "C": [0, 0, 0] } } },
    "joints": { "block": { "type": "free", "from": "ground.O", "to": "block.O" },
      "ball": { "type": "free", "from": "ground.O", "to": "ball.C" } },
    "roads": { "slope": { "origin": [0.1, 0.2, 0.05], "heading": 0.4, "height": "0.2*x - 0.1*y" },
      "waves": { "heading": 0.4, "height": "0.05*sin(3*x)*cos(2*y)", "features": {
        "hump": { "type": "bump", "from": -0.5, "length": 1, "height": 0.05 } },
        "patches": { "ice": { "from": -5, "length": 5, "friction": 0.3 } } } },
    "contacts": { "c": { "from": "ball.C", "radius": 0.2, "stiffness": 1e5, "exponent": 1.5, )x" +
         surface + more + R"( } },
    "outputs": { "n": { "contact": "c", "quantity": "load" }, "p": { "contact": "c", "quantity": "deflection" },
      "rate": { "contact": "c", "quantity": "rate" }, "slip": { "contact": "c", "quantity": "velocity" },
      "fx": { "contact": "c", "quantity": "force", "axis": "x" }, "fy": { "contact": "c", "quantity": "force", "axis": "y" },
      "fz": { "contact": "c", "quantity": "force", "axis": "z" },
      "t": { "contact": "c", "quantity": "lateral_force" },
      "e": { "contact": "c", "quantity": "potential_energy" } } })";
}

enum Shown { kNormal, kPenetration, kRate, kSlip, kForce, kFriction = kForce + 3, kEnergy };

/// Random places of the ball around the surface, most of them in contact with it.
template <class Use>
void each_place(MechanismInState& m, int wanted, const Use& use) {
  std::mt19937_64 dice(7);
  std::uniform_real_distribution<double> any(-1, 1);
  const char* kWays[] = {"tx", "ty", "tz", "rx", "ry", "rz"};
  int met = 0;
  for (int k = 0; k < 400 && met < wanted; ++k) {
    for (const char* way : kWays) {
      m.set(std::string("ball_") + way, 0.45 * any(dice), any(dice));
      m.set(std::string("block_") + way, 0.1 * any(dice), any(dice));
    }
    for (double& x : m.state().x) x = 0.7e-4 * any(dice);  // both within their limit, 0.1 mm
    const std::vector<double> y = outputs_at(m.solver(), m.state(), std::vector<double>(12));
    if (y[kPenetration] < -0.1 || y[kPenetration] > 0.15) continue;
    met += y[kPenetration] > 0 ? 1 : 0;
    use(y);
  }
  EXPECT_EQ(met, wanted);
}

TEST(ContactShapes, ForceIsTheSlopeOfTheEnergy) {
  for (const char* surface : kTouched) {
    MechanismInState m(analysed(model_of(pair_of(surface, ""))));
    each_place(m, 40, [&](const std::vector<double>& y) {
      const GenericState kept = m.state();
      const char* kAxes[] = {"ball_tx", "ball_ty", "ball_tz"};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto energy = [&](double by) {
          m.state() = kept;
          m.set(kAxes[axis], m.z(kAxes[axis]) + by, 0);
          return outputs_at(m.solver(), m.state(), std::vector<double>(12))[kEnergy];
        };
        constexpr double h = 1e-6;
        EXPECT_NEAR(y[kForce + axis], -(energy(h) - energy(-h)) / (2 * h), 1e-3 + 1e-6 * y[kNormal]) << surface;
      }
      m.state() = kept;
      EXPECT_NEAR(y[kEnergy], y[kPenetration] > 0 ? y[kNormal] * y[kPenetration] / 2.5 : 0, 1e-9 * (1 + y[kEnergy]));
    });
  }
}

TEST(ContactShapes, RateIsThatOfThePenetration) {
  for (const char* surface : kTouched) {
    MechanismInState m(analysed(model_of(pair_of(surface, R"(, "friction": 0.5)"))));
    each_place(m, 20, [&](const std::vector<double>& y) {
      const GenericState kept = m.state();
      const auto penetration = [&](double time) {
        m.state() = kept;
        for (std::size_t i = 0; i < kept.z.size(); ++i) m.state().z[i] += time * kept.zd[i];
        return outputs_at(m.solver(), m.state(), std::vector<double>(12))[kPenetration];
      };
      constexpr double h = 1e-6;
      EXPECT_NEAR(y[kRate], (penetration(h) - penetration(-h)) / (2 * h), 1e-8) << surface;
      m.state() = kept;
    });
  }
}

TEST(ContactShapes, JudgesFindTheSame) {
  std::vector<std::string> surfaces = {R"("road": "waves")"};
  surfaces.insert(surfaces.end(), std::begin(kTouched), std::end(kTouched));
  for (const std::string& surface : surfaces) {
    const std::string law =
        R"(, "damping": 0.2, "friction": 0.5, "stiction": 0.7, "stribeck_velocity": 0.4, "bristle": 2e-4)";
    const Mechanism mechanism = analysed(model_of(pair_of(surface, law)));
    MechanismInState m(mechanism);
    const CartesianSolver judge(mechanism.model, mechanism.topology, CartesianMethod::augmented,
                                Stabilisation::projection);
    const std::vector<double> tau(12);
    each_place(m, 40, [&](const std::vector<double>& y) {
      GenericOutputs of_judge;
      ASSERT_TRUE(judge.outputs(m.state(), tau, of_judge).ok());
      for (std::size_t i = 0; i < y.size(); ++i)
        EXPECT_NEAR(of_judge.y[i], y[i], 1e-9 * (1 + y[kNormal])) << surface << i;
      GenericDerivative here, there;
      ASSERT_TRUE(m.solver().accelerations(m.state(), tau, here).ok());
      ASSERT_TRUE(judge.accelerations(m.state(), tau, there).ok());
      EXPECT_LT(relative_error(there.zdd, here.zdd), 1e-9) << surface;
      EXPECT_LT(relative_error(there.xd, here.xd), 1e-9) << surface;
    });
  }
}

TEST(ContactShapes, FrictionStaysWithinItsConeAndAgainstSteadySliding) {
  for (const char* surface : kTouched) {
    MechanismInState m(analysed(model_of(pair_of(surface, R"(, "damping": 0.2, "friction": 0.5)"))));
    each_place(m, 20, [&](const std::vector<double>& y) {
      const double size = y[kFriction], whole = std::hypot(y[kForce], y[kForce + 1], y[kForce + 2]);
      EXPECT_LE(size, 0.5 * y[kNormal] + 1e-12) << surface;
      EXPECT_NEAR(whole, std::hypot(size, y[kNormal]), 1e-9 * (1 + y[kNormal]));  // one is across the other
      if (y[kPenetration] <= 0) {
        EXPECT_LT(whole, 1e-12) << surface;
      }
    });
  }
}

}  // namespace
}  // namespace mbgen
