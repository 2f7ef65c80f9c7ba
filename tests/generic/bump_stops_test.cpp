// Bump stops against closed forms: how far a mass goes in, and how fast it comes out again.

#include <cmath>

#include "compiler/model/element_access.hpp"
#include "tests/support/dynamics.hpp"
#include "tests/support/model_support.hpp"
#include "tests/support/reaction_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A mass of 3 kg that slides to a stop 0.1 m away. place: where the stop is, with its side.
MechanismInState sliding(const std::string& place, const std::string& law) {
  Model model = model_of(R"({ "mbgen": 1, "name": "sliding", "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "O": [0, 0, 0], "wall": [0.7, 0, 0], "back": [-0.4, 0, 0] } },
      "mass": { "mass": 3, "inertia": [1, 1, 1], "points": { "O": [0, 0, 0], "nose": [0.2, 0, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.O", "to": "mass.O", "axis": "x" } },
    "springs": { "idle": { "from": "ground.wall", "to": "mass.nose", "preload": 0 } },
    "bump_stops": { "stop": { )" +
                         place + R"(, "clearance": 0.1, )" + law + " } } }");
  for (const char* what : {"force", "deflection"})
    model.outputs.push_back({"probe" + std::to_string(model.outputs.size()), {}, "", output_of<BumpStop>(what, 0)});
  MechanismInState m(analysed(std::move(model)));
  m.set("slide", 0.098, 2);
  return m;
}

/// The deepest penetration and the speed after the contact; no force may pull.
std::array<double, 2> impact(MechanismInState m) {
  const Dynamics dynamics{m.solver()};
  double deepest = 0;
  for (int k = 0; k < 4000 && (m.z("slide") > 0.099 || m.zd("slide") > 0); ++k) {
    EXPECT_TRUE(step_rk4(dynamics, m.state(), 5e-5).ok());
    const std::vector<double> y = outputs_at(m.solver(), m.state(), {0});
    EXPECT_GE(y[0], 0);
    EXPECT_NEAR(y[1], m.z("slide") - 0.1, 1e-15);
    EXPECT_EQ(y[0] > 0, y[1] > 0);
    deepest = std::max(deepest, y[1]);
  }
  return {deepest, -m.zd("slide")};
}

// m v^2 / 2 = k p^(n + 1) / (n + 1), and all of it comes back.
TEST(BumpStops, PowerLawStoresTheEnergy) {
  const double deepest = std::pow(0.5 * 3 * 4 * 2.5 / 5e4, 1 / 2.5);
  for (const char* place : {R"("joint": "slide", "side": "above")", R"("spring": "idle")",
                            R"("from": "ground.wall", "to": "mass.nose", "side": "compression")",
                            R"("from": "ground.back", "to": "mass.O", "side": "extension")",
                            R"("from": "ground.wall", "to": "mass.nose", "axis": "-x")",
                            R"("from": "mass.O", "to": "ground.back", "axis": [2, 0, 0])",
                            R"("from": "ground.O", "to": "mass.O", "axis": "x", "side": "extension")"}) {
    const auto [way, speed] = impact(sliding(place, R"("stiffness": 5e4, "exponent": 1.5)"));
    EXPECT_NEAR(way, deepest, 1e-4 * deepest) << place;
    EXPECT_NEAR(speed, 2, 1e-5) << place;
  }
}

// With the force k p^n (1 + a dp/dt) the speeds before and after obey v - log(1 + a v) / a = -w - log(1 - a w) / a,
// whatever k and n: the integral of v dv / (1 + a v) over the contact is that of p^n dp, zero.
TEST(BumpStops, DampingTakesTheEnergyOfHuntAndCrossley) {
  const double a = 0.6, before = 2 - std::log(1 + a * 2) / a;
  double low = 0, high = 2;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (-middle - std::log(1 - std::min(a * middle, 1 - 1e-12)) / a < before ? low : high) = middle;
  }
  for (const char* law : {R"("stiffness": 5e4, "exponent": 1.5)", R"("stiffness": 2e4)",
                          R"("force": "2e4*penetration + 1e6*penetration^2")",
                          R"("stiffness": { "table": [[0, 0], [0.01, 100], [0.1, 5000]] })"}) {
    const double speed =
        impact(sliding(R"("joint": "slide", "side": "above")", std::string(law) + ", \"damping\": 0.6"))[1];
    EXPECT_NEAR(speed, low, 1e-4) << law;
  }
}

TEST(BumpStops, NeverPullAndAreNotThereBeforeTheClearance) {
  MechanismInState m = sliding(R"("joint": "slide", "side": "above")", R"("stiffness": 1e4, "damping": 0.5)");
  const auto force = [&](double z, double zd) {
    m.set("slide", z, zd);
    return outputs_at(m.solver(), m.state(), {0})[0];
  };
  EXPECT_EQ(force(0.0999, 10), 0);
  EXPECT_NEAR(force(0.12, 0), 200, 1e-9);
  EXPECT_NEAR(force(0.12, 1), 300, 1e-9);
  EXPECT_NEAR(force(0.12, -1), 100, 1e-9);
  EXPECT_EQ(force(0.12, -3), 0);
}

}  // namespace
}  // namespace mbgen
