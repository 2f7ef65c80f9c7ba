// Linear systems of bodies that roll or slide on blades: closed forms, and the benchmark of the bicycle.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/compile.hpp"
#include "compiler/linearisation/linearisation.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

Compilation compilation_of(const Result<Model>& model) {
  if (!model) throw std::runtime_error(to_text(model.problems()));
  Result<Compilation> compilation = compile(*model);
  if (!compilation) throw std::runtime_error(to_text(compilation.problems()));
  return std::move(*compilation);
}

/// Linearises about a state with these positions and velocities; all others are zero or follow.
LinearSystem system_at(const Compilation& c, const std::vector<std::pair<const char*, double>>& positions,
                       const std::vector<std::pair<const char*, double>>& velocities) {
  GenericState state;
  state.z.assign(static_cast<std::size_t>(c.topology.size()), 0.0);
  state.zd = state.z;
  for (const auto& [name, value] : positions) state.z[find_coordinate(c.topology, name)] = value;
  for (const auto& [name, value] : velocities) state.zd[find_coordinate(c.topology, name)] = value;
  EXPECT_TRUE(GenericSolver(c.model, c.topology, c.analysis).project(state).ok());
  Result<LinearSystem> system = linearise(c, {state.z, state.zd, state.x, 0, {}});
  if (!system) throw std::runtime_error(to_text(system.problems()));
  return *system;
}

/// Eigenvalues that are not zero, those that turn forward, the largest first.
std::vector<std::complex<double>> lively(const LinearSystem& system) {
  std::vector<std::complex<double>> values;
  for (const Mode& mode : modes(system))
    if (!mode.is_neutral) values.push_back(mode.eigenvalue);
  std::sort(values.begin(), values.end(), [](auto a, auto b) { return std::abs(a) > std::abs(b); });
  return values;
}

std::vector<std::string> states_of(const Compilation& c, const LinearSystem& system) {
  std::vector<std::string> names;
  for (const LinearState& state : system.states)
    names.push_back((state.kind == LinearState::Kind::position ? "z." : "zd.") +
                    c.topology.bodies[static_cast<std::size_t>(state.index)].coordinate);
  std::sort(names.begin(), names.end());
  return names;
}

// E. J. Routh: an upright disc with inertia C about its axle and A across wobbles at the rate
// ((C + m r^2) C W^2 / A - m g r) / (A + m r^2) squared, and falls over where that is negative: W^2 < g / 3 r of a thin
// one. All else stays: places, headings, turns, speeds, and the circles of a disc that leans.
TEST(RollingDisc, WobblesAsRouthSays) {
  const Compilation c = compilation_of(read_model_file(source_path("models/rolling_disc.json")));
  const double r = 0.3, m = 2, g = 9.81, across = m * r * r / 4, axial = m * r * r / 2;
  for (const double heading : {0.0, 1.1}) {
    for (const double spin : {0.0, 2.0, 3.2, 3.4, 8.0}) {
      const LinearSystem system = system_at(
          c, {{"disc_rz", heading}},
          {{"disc_ry", spin}, {"disc_tx", r * spin * std::cos(heading)}, {"disc_ty", r * spin * std::sin(heading)}});
      const std::vector<std::string> expected = {"z.disc_rx", "z.disc_ry",  "z.disc_rz",  "z.disc_tx",
                                                 "z.disc_ty", "zd.disc_rx", "zd.disc_ry", "zd.disc_rz"};
      EXPECT_EQ(states_of(c, system), expected);
      const double square = ((axial + m * r * r) * axial * spin * spin / across - m * g * r) / (across + m * r * r);
      const std::vector<std::complex<double>> values = lively(system);
      const std::size_t count = square > 0 ? 1 : 2;  // a pair that turns is told once
      ASSERT_EQ(values.size(), count) << spin;
      const std::complex<double> rate = std::sqrt(std::complex<double>(-square));
      for (const std::complex<double> value : values) {
        EXPECT_NEAR(std::abs(value.real()), rate.real(), 1e-9) << spin;
        EXPECT_NEAR(value.imag(), rate.imag(), 1e-9) << spin;
      }
      const std::vector<Mode> all = modes(system);
      const auto growing = std::count_if(all.begin(), all.end(), [](const Mode& mode) { return mode.is_unstable; });
      EXPECT_EQ(growing, spin * spin < g / (3 * r) ? 1 : 0) << spin;
    }
  }
}

// A sleigh with its centre of mass a before the blade runs on where it goes ahead, and turns round where it goes back:
// w' = -m a u / (J + m a^2) w.
TEST(ChaplyginSleigh, TurnsRoundWhereItGoesBack) {
  const Compilation c = compilation_of(read_model_file(source_path("models/chaplygin_sleigh.json")));
  for (const double speed : {5.0, -5.0}) {
    const LinearSystem system = system_at(c, {}, {{"sleigh_tx", speed}});
    EXPECT_EQ(system.states.size(), 5u);
    const std::vector<std::complex<double>> values = lively(system);
    ASSERT_EQ(values.size(), 1u);
    EXPECT_NEAR(values[0].real(), -3 * 0.4 * speed / (0.2 + 3 * 0.4 * 0.4), 1e-10);
    // Across the blade it goes by its heading alone.
    const auto state = [&](LinearState::Kind kind, const char* name) {
      const int index = find_coordinate(c.topology, name);
      return std::find_if(system.states.begin(), system.states.end(),
                          [&](const LinearState& s) { return s.kind == kind && s.index == index; }) -
             system.states.begin();
    };
    const Eigen::Index across = state(LinearState::Kind::position, "sleigh_ty");
    const Eigen::Index heading = state(LinearState::Kind::position, "sleigh_rz");
    ASSERT_LT(across, 5);
    EXPECT_NEAR(system.A(across, heading), speed, 1e-12);
    EXPECT_NEAR(system.A.row(across).cwiseAbs().sum(), std::abs(speed), 1e-12);
  }
}

// Table 1 of the benchmark, its axes turned by half a turn about x: z is up. The lowest points of both wheels hold
// height and pitch, and the slip rows their rates: a rigid combination that closing moves together.
std::string bicycle() {
  return R"({ "mbgen": 1, "name": "bicycle", "gravity": [0, 0, -9.81], "bodies": {
    "ground": { "points": { "O": [0, 0, 0] } },
    "frame": { "mass": 85, "com": [0.3, 0, 0.9], "inertia": [9.2, 11, 2.8, 0, -2.4, 0],
      "points": { "O": [0, 0, 0], "rear": [0, 0, 0.3], "head": [1.1, 0, 0] } },
    "rear": { "mass": 2, "com": [0, 0, 0.3], "inertia": [0.0603, 0.12, 0.0603], "points": { "C": [0, 0, 0.3] } },
    "fork": { "mass": 4, "com": [0.9, 0, 0.7], "inertia": [0.05892, 0.06, 0.00708, 0, 0.00756, 0],
      "points": { "head": [1.1, 0, 0], "front": [1.02, 0, 0.35] } },
    "front": { "mass": 3, "com": [1.02, 0, 0.35], "inertia": [0.1405, 0.28, 0.1405], "points": { "C": [1.02, 0, 0.35] } } },
  "joints": {
    "frame": { "type": "free", "from": "ground.O", "to": "frame.O", "sequence": "zxy" },
    "steer": { "type": "revolute", "from": "frame.head", "to": "fork.head",
      "axis": [-0.30901699437494742, 0, 0.95105651629515357] },
    "rear": { "type": "revolute", "from": "frame.rear", "to": "rear.C", "axis": "y" },
    "front": { "type": "revolute", "from": "fork.front", "to": "front.C", "axis": "y" },
    "behind": { "type": "rolling_disc", "from": "ground.O", "to": "rear.C", "axis": "z", "axis2": "y" },
    "ahead": { "type": "rolling_disc", "from": "ground.O", "to": "front.C", "axis": "z", "axis2": "y" } } })";
}

// J. P. Meijaard et al., "Linearized dynamics equations for the balance and steer of a bicycle", Proc. R. Soc. A 463,
// 2007, table 2: at 5 m/s castering, weave, capsize; at rest two ways to fall.
TEST(Bicycle, HasTheEigenvaluesOfTheBenchmark) {
  const Compilation c = compilation_of(read_model(bicycle(), "bicycle.json"));
  EXPECT_EQ(c.analysis.degrees_of_freedom, 3);
  EXPECT_EQ(c.analysis.position_freedoms, 7);
  const double v = 5;
  const LinearSystem moving = system_at(c, {}, {{"frame_tx", v}, {"rear", v / 0.3}, {"front", v / 0.35}});
  EXPECT_EQ(moving.states.size(), 10u);
  const std::vector<std::complex<double>> at5 = lively(moving);
  ASSERT_EQ(at5.size(), 3u);
  EXPECT_NEAR(std::abs(at5[0] - std::complex<double>(-14.07838969279822)), 0, 1e-9);
  EXPECT_NEAR(std::abs(at5[1] - std::complex<double>(-0.775341882195845, 4.464867713788230)), 0, 1e-9);
  EXPECT_NEAR(std::abs(at5[2] - std::complex<double>(-0.322866429004087)), 0, 1e-9);
  const std::vector<std::complex<double>> at_rest = lively(system_at(c, {}, {}));
  ASSERT_EQ(at_rest.size(), 4u);
  for (const std::size_t i : {0u, 1u}) EXPECT_NEAR(std::abs(at_rest[i].real()), 5.530943717653, 1e-9);
  for (const std::size_t i : {2u, 3u}) EXPECT_NEAR(std::abs(at_rest[i].real()), 3.131643247907, 1e-9);
}

}  // namespace
}  // namespace mbgen
