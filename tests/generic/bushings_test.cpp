// Bushings against closed forms: a mass on a bushing, laws of conservation at any deflection, rotations from nothing to
// their limit.

#include <cmath>
#include <numbers>

#include "compiler/model/element_access.hpp"
#include "tests/support/dynamics.hpp"
#include "tests/support/model_support.hpp"
#include "tests/support/reaction_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

/// A body of 2 kg with its centre of mass in a bushing to the ground, in space. bushing: its fields.
std::string mass_on(const std::string& bushing, const std::string& gravity = "[0, 0, 0]") {
  return R"({ "mbgen": 1, "name": "mass", "gravity": )" + gravity + R"(,
    "bodies": { "ground": { "points": { "O": [0.3, 0, 0] } },
      "mass": { "mass": 2, "com": [0.3, 0, 0], "inertia": [0.3, 0.4, 0.5], "points": { "O": [0.3, 0, 0] } } },
    "joints": { "free": { "type": "free", "from": "ground.O", "to": "mass.O" } },
    "bushings": { "rubber": { "from": "ground.O", "to": "mass.O", )" +
         bushing + " } } }";
}

const std::string kSixSprings = R"("tx": { "stiffness": 800 }, "ty": { "stiffness": 1250 },
  "tz": { "stiffness": 450 }, "rx": { "stiffness": 30 }, "ry": { "stiffness": 90 }, "rz": { "stiffness": 12.5 })";
constexpr double kStiffness[] = {800, 1250, 450, 30, 90, 12.5}, kInertia[] = {2, 2, 2, 0.3, 0.4, 0.5};
const char* const kCoordinates[] = {"free_tx", "free_ty", "free_tz", "free_rx", "free_ry", "free_rz"};

void run(MechanismInState& m, double duration, int steps) {
  const Dynamics dynamics{m.solver()};
  for (int k = 0; k < steps; ++k) ASSERT_TRUE(step_rk4(dynamics, m.state(), duration / steps).ok());
}

/// An output of the only bushing.
std::vector<double> outputs_of(const MechanismInState& m, GenericState state) {
  return outputs_at(m.solver(), state, std::vector<double>(state.z.size(), 0.0));
}

/// With outputs of all that a bushing shows: force, moment, deflection, rotation vector.
MechanismInState with_outputs(const std::string& text) {
  Model model = model_of(text);
  for (const char* what : {"force", "moment", "deflection", "rotation_vector"})
    add_vector(model, output_of<Bushing>(what, 0));
  return MechanismInState(analysed(std::move(model)));
}

// About one axis of inertia and along one axis at a time the motion is a harmonic one, far beyond small angles.
TEST(Bushings, MassHasItsSixFrequencies) {
  for (int i = 0; i < kBushingFreedoms; ++i) {
    MechanismInState m(mechanism_of(mass_on(kSixSprings)));
    const double amplitude = i < 3    ? 0.2
                             : i == 4 ? 1.4
                                      : 2.5,
                 period = 2 * std::numbers::pi * std::sqrt(kInertia[i] / kStiffness[i]);
    m.set(kCoordinates[i], amplitude, 0);
    run(m, period / 3, 120);
    EXPECT_NEAR(m.z(kCoordinates[i]), -0.5 * amplitude, 1e-6 * amplitude) << kCoordinates[i];
    run(m, period * 2 / 3, 240);
    EXPECT_NEAR(m.z(kCoordinates[i]), amplitude, 1e-6 * amplitude) << kCoordinates[i];
    EXPECT_NEAR(m.zd(kCoordinates[i]), 0, 1e-4) << kCoordinates[i];
  }
}

// x'' + 2 d w x' + w^2 x = 0, and with a Maxwell branch the eigenvalue s of m s^2 + k + km s t / (1 + s t) = 0 that is
// real: a motion along its eigenvector decays by exp(s t).
TEST(Bushings, DampingAndMaxwellBranchDecayAsTheyShould) {
  MechanismInState damped(mechanism_of(mass_on(R"("tz": { "stiffness": 450, "damping": 12 })")));
  damped.set("free_tz", 0.1, 0);
  const double w = 15, decay = 3, ringing = std::sqrt(w * w - decay * decay), t = 0.7;
  run(damped, t, 700);
  EXPECT_NEAR(damped.z("free_tz"),
              0.1 * std::exp(-decay * t) * (std::cos(ringing * t) + decay / ringing * std::sin(ringing * t)), 1e-9);
  const double km = 900, tm = 0.05;
  const auto characteristic = [&](double s) { return (2 * s * s + 450) * (1 + s * tm) + km * s * tm; };
  double low = -20, high = 0;  // the only real root
  for (int k = 0; k < 200; ++k) (characteristic((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
  for (const char* freedom : {"tz", "rz"}) {
    const bool turns = freedom[0] == 'r';
    const std::string law = turns ? R"({ "stiffness": 112.5, "maxwell_stiffness": 225, "maxwell_time": 0.05 })"
                                  : R"({ "stiffness": 450, "maxwell_stiffness": 900, "maxwell_time": 0.05 })";
    MechanismInState m(mechanism_of(mass_on("\"" + std::string(freedom) + "\": " + law)));
    const std::string coordinate = "free_" + std::string(freedom);
    m.set(coordinate, 0.1, 0.1 * low);
    ASSERT_EQ(m.state().x.size(), 1u);
    m.state().x[0] = 0.1 * low * tm / (1 + low * tm);
    run(m, 0.1, 400);
    EXPECT_NEAR(m.z(coordinate), 0.1 * std::exp(0.1 * low), 1e-9) << freedom;
  }
}

// Two bodies in space with a bushing of stiffnesses alone between points off their centres, far deflected and turning:
// what it gives to one it takes from the other, at one point, and its energy is that of its deflections.
TEST(Bushings, ConserveEnergyAndMomentumAtLargeDeflections) {
  const double stiffness[] = {300, 500, 200, 20, 35, 8};
  Model model = model_of(R"({ "mbgen": 1, "name": "pair", "gravity": [0, 0, 0],
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
      "first": { "mass": 2, "com": [0.1, 0.2, 0], "inertia": [0.3, 0.4, 0.5, 0.02, 0.01, 0.03],
                 "points": { "O": [0, 0, 0], "seat": [0.6, 0, 0.4], "eye": [0.4, 0.1, 0.3] } },
      "second": { "mass": 3, "com": [0.6, 0, 0.4], "inertia": [0.6, 0.4, 0.3],
                  "points": { "O": [0.6, 0, 0.4], "eye": [0.4, 0.1, 0.3] } } },
    "joints": { "first": { "type": "free", "from": "ground.O", "to": "first.O" },
                "second": { "type": "free", "from": "first.seat", "to": "second.O" } },
    "bushings": { "rubber": { "from": "first.eye", "to": "second.eye", "axis": [1, 2, 3], "axis2": [1, 0, 0.5],
      "tx": { "stiffness": 300 }, "ty": { "stiffness": 500 }, "tz": { "stiffness": 200 },
      "rx": { "stiffness": 20 }, "ry": { "stiffness": 35 }, "rz": { "stiffness": 8 } } } })");
  add_vector(model, output_of<Bushing>("deflection", 0));
  add_vector(model, output_of<Bushing>("rotation_vector", 0));
  add_vector(model, MomentumOutput{MomentumOutput::What::momentum});
  add_vector(model, MomentumOutput{MomentumOutput::What::angular_momentum});
  const auto drift = [&](int steps, double& turn) {
    MechanismInState m(analysed(model));
    m.state().z = {0.1, 0.2, -0.1, 0.3, 0.1, -0.2, 0.1, -0.1, 0.15, 1.1, -0.7, 0.8};
    m.state().zd = {0.5, -0.3, 0.2, 1, -0.5, 0.8, 0.3, 0.4, -0.2, -1.5, 1, 2};
    const std::vector<double> zero(12, 0.0);
    const auto look = [&] {
      GenericDerivative derivative;
      EXPECT_TRUE(m.solver().accelerations(m.state(), zero, derivative).ok());
      const GenericOutputs now = m.solver().outputs(m.state(), zero, derivative);
      double energy = now.kinetic_energy;
      for (int i = 0; i < kBushingFreedoms; ++i) energy += 0.5 * stiffness[i] * now.y[i] * now.y[i];
      turn = std::max(turn, std::hypot(now.y[3], now.y[4], now.y[5]));
      std::vector<double> kept(now.y.begin() + 6, now.y.end());
      kept.push_back(energy);
      return kept;
    };
    const std::vector<double> start = look();
    for (int k = 0; k < steps; ++k) {
      const Dynamics dynamics{m.solver()};
      EXPECT_TRUE(step_rk4(dynamics, m.state(), 0.4 / steps).ok());
      look();
    }
    return relative_error(look(), start);
  };
  double turn = 0;
  const double coarse = drift(200, turn), fine = drift(400, turn);
  EXPECT_GT(turn, 1.2);
  EXPECT_LT(fine, 1e-8);
  EXPECT_LT(fine, coarse / 8);  // the integrator's error alone
}

// Angles on both sides of the border between series and closed form, and up to the limit; beyond it a status.
TEST(Bushings, RotationVectorIsSmoothFromZeroToItsLimit) {
  MechanismInState m = with_outputs(mass_on(kSixSprings));
  for (const double angle :
       {0.0, 1e-17, 1e-12, 1e-8, 1e-5, 1e-3, 0.03, 0.0365, 0.03651, 0.0366, 0.05, 0.7, 1.57, 2.4, 2.9, 2.999}) {
    m.set("free_rz", angle, 0.5);
    const std::vector<double> y = outputs_of(m, m.state());
    EXPECT_NEAR(y[11], angle, 3e-14 * angle) << angle;  // rotation vector, z
    EXPECT_NEAR(y[5], -12.5 * angle, 1e-12 * angle) << angle;
  }
  m.set("free_rz", 3.001, 0);
  GenericDerivative derivative;
  const Status status = m.solver().accelerations(m.state(), std::vector<double>(6, 0.0), derivative);
  EXPECT_EQ(status.code, Code::not_a_number);
}

// The rate of the rotation vector, and so damping, in the small and in the large: by differences of the rotation
// vector.
TEST(Bushings, DampingActsOnTheRateOfTheRotationVector) {
  MechanismInState m = with_outputs(
      mass_on(R"("rx": { "damping": 1 }, "ry": { "damping": 2 }, "rz": { "damping": 3 }, "tx": { "damping": 4 })"));
  for (const double size : {1e-6, 0.02, 0.5, 1.2}) {
    GenericState& state = m.state();
    state.z = {0.1, -0.2, 0.05, 0.9 * size, -0.8 * size, 0.7 * size};
    state.zd = {0.3, 0, 0, 0.4, 0.9, -0.6};
    const double step = 1e-3;
    std::vector<std::vector<double>> near;
    for (const int k : {-2, -1, 1, 2}) {
      GenericState moved = state;
      for (std::size_t i = 0; i < moved.z.size(); ++i) moved.z[i] += k * step * moved.zd[i];
      near.push_back(outputs_of(m, moved));
    }
    const std::vector<double> y = outputs_of(m, state);
    double power = 0, expected = 0;  // of the damper, by its moment on the body and by its rates
    const double damping[] = {1, 2, 3};
    for (int i = 0; i < 3; ++i) {
      const double rate = (near[0][9 + i] - 8 * near[1][9 + i] + 8 * near[2][9 + i] - near[3][9 + i]) / (12 * step);
      expected -= damping[i] * rate * rate;
    }
    const double a = state.z[3], b = state.z[4], da = state.zd[3], db = state.zd[4], dc = state.zd[5];
    const double spin[] = {-db * std::sin(a) + dc * std::cos(a) * std::cos(b),
                           db * std::cos(a) + dc * std::sin(a) * std::cos(b), da - dc * std::sin(b)};
    for (int i = 0; i < 3; ++i) power += y[3 + i] * spin[i];
    EXPECT_NEAR(power, expected, 1e-8 * std::abs(expected)) << size;
    EXPECT_NEAR(y[0], -4 * 0.3, 1e-12);
  }
}

TEST(Bushings, WeightSagsAndMaxwellBranchesRelax) {
  const Mechanism m = mechanism_of(mass_on(kSixSprings + R"(, "stiffness": [[0,0,0,0,0,0], [0,0,0,0,0,0],
    [0,0,50,0,0,0], [0,0,0,0,0,0], [0,0,0,0,0,0], [0,0,0,0,0,0]])",
                                           "[0, 0, -10]"));
  GenericState state = reference_state(m);
  ASSERT_TRUE(GenericSolver(m.model, m.topology, m.analysis).equilibrium(state).ok());
  EXPECT_NEAR(state.z[2], -2 * 10.0 / 500, 1e-10);
  const Mechanism branched =
      mechanism_of(mass_on(R"("tz": { "stiffness": 500, "preload": -4, "maxwell_stiffness": 3000, "maxwell_time": 0.1 },
                 "radial": { "stiffness": 10 }, "conical": { "stiffness": 1 }, "rz": { "stiffness": 1 })",
                           "[0, 0, -10]"));
  state = reference_state(branched);
  state.x = {0.01};
  ASSERT_TRUE(GenericSolver(branched.model, branched.topology, branched.analysis).equilibrium(state).ok());
  EXPECT_NEAR(state.z[2], -(2 * 10.0 - 4) / 500, 1e-10);
  ASSERT_EQ(state.x.size(), 1u);
  EXPECT_NEAR(state.x[0], 0, 1e-15);
}

// Equal coordinates of a mirrored instance are mirrored motions: laws that differ to both sides give equal
// accelerations.
TEST(Bushings, MirroredInstanceIsTheMirrorImage) {
  const Mechanism m = load("tests/data/models/mirrored_mounts.json");
  const GenericSolver solver(m.model, m.topology, m.analysis);
  GenericState state = reference_state(m);
  ASSERT_EQ(state.z.size(), 12u);
  ASSERT_EQ(state.x.size(), 2u);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (std::size_t i = 0; i < 6; ++i) {
    state.z[i] = state.z[i + 6] = (i < 3 ? 0.05 : 0.8) * unit(random);
    state.zd[i] = state.zd[i + 6] = unit(random);
  }
  state.x = {0.02, 0.02};
  GenericDerivative derivative;
  const std::vector<double> tau(12, 0.0);
  ASSERT_TRUE(solver.accelerations(state, tau, derivative).ok());
  const std::vector<double> y = solver.outputs(state, tau, derivative).y;
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(derivative.zdd[i], derivative.zdd[i + 6], 1e-11 * (1 + std::abs(derivative.zdd[i]))) << i;
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(y[i], y[i + 4], 1e-11 * (1 + std::abs(y[i]))) << i;
  EXPECT_NEAR(derivative.xd[0], derivative.xd[1], 1e-12);
}

}  // namespace
}  // namespace mbgen
