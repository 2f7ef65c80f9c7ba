// The generic runtime against accelerations of an independent solver, and against the laws of mechanics.

#include <limits>

#include "mbgen/blocks.hpp"
#include "mbgen/integrators.hpp"
#include "tests/support/reference_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

struct ReferenceCase {
  std::string model, states;
};

void PrintTo(const ReferenceCase& which, std::ostream* out) { *out << which.model; }

/// Largest relative error over the reference states.
double worst_error(const Mechanism& m, const std::string& states_file, std::vector<double> ReferenceState::*expected) {
  const GenericSolver solver(m.model, m.topology, m.analysis);
  double worst = 0;
  for (const ReferenceState& reference : reference_states(m.topology, states_file)) {
    EXPECT_LT(largest_absolute(solver.position_residuals(reference.state)), 1e-13);
    EXPECT_LT(largest_absolute(solver.velocity_residuals(reference.state)), 1e-11);
    GenericDerivative derivative;
    EXPECT_TRUE(solver.accelerations(reference.state, reference.tau, derivative).ok());
    worst = std::max(worst, relative_error(derivative.zdd, reference.*expected));
  }
  return worst;
}

TEST(LargestAbsolute, IsNaNWhereverOneStands) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(largest_absolute({}), 0);
  EXPECT_EQ(largest_absolute({1, -3, 2}), 3);
  for (const std::vector<double>& values : {std::vector<double>{nan, 1, 2}, {1, nan, 2}, {1, 2, nan}})
    EXPECT_TRUE(std::isnan(largest_absolute(values)));
  EXPECT_TRUE(std::isnan(solver_detail::largest(std::vector<double>{nan, 1, 2}.data(), 3)));
}

class ReferenceStates : public ::testing::TestWithParam<ReferenceCase> {};

// The reference itself is good to 1e-11 (tests/data/reference/README.md); what we see is 2e-13.
TEST_P(ReferenceStates, AccelerationsWithMassiveRods) {
  EXPECT_LT(worst_error(load(GetParam().model), GetParam().states, &ReferenceState::zdd), 1e-11);
}

TEST_P(ReferenceStates, AccelerationsWithMasslessRods) {
  Mechanism m = load(GetParam().model);
  without_rod_masses(m.model);
  m.topology = *build_topology(m.model);
  m.analysis = *analyse(m.model, m.topology);
  EXPECT_LT(worst_error(m, GetParam().states, &ReferenceState::zdd_massless_rods), 1e-11);
}

INSTANTIATE_TEST_SUITE_P(
    Vehicles, ReferenceStates,
    ::testing::Values(ReferenceCase{"models/coach_mechanism.json", "tests/data/reference/coach_states.json"},
                      ReferenceCase{"models/truck_mechanism.json", "tests/data/reference/truck_states.json"}),
    [](const auto& info) { return info.index == 0 ? "coach" : "truck"; });

class EveryModel : public ::testing::TestWithParam<std::string> {};
class EveryModelWithLoops : public ::testing::TestWithParam<std::string> {};

// A step of the exact flow: position, velocity and acceleration must belong together, whatever the formulation does
// inside.
TEST_P(EveryModelWithLoops, AccelerationsKeepTheClosuresClosed) {
  const Mechanism m = load(GetParam());
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const std::vector<GenericState> states = random_states(m, 3);
  ASSERT_FALSE(states.empty());
  for (const GenericState& state : states) {
    GenericDerivative derivative;
    ASSERT_TRUE(solver.accelerations(state, random_tau(m, 3), derivative).ok());
    const double h = 1e-4;  // the residual of a parabola through an exact state is of third order
    const auto residual_after = [&](double step) {
      GenericState moved = state;
      moved.t += step;
      for (std::size_t i = 0; i < moved.z.size(); ++i)
        moved.z[i] += step * state.zd[i] + 0.5 * step * step * derivative.zdd[i];
      return largest_absolute(solver.position_residuals(moved));
    };
    const double scale = std::max(1.0, largest_absolute(derivative.zdd));
    EXPECT_LT(residual_after(h), 50 * scale * std::max(1.0, std::sqrt(scale)) * h * h * h + 1e-12);
  }
}

// d/dt (kinetic + potential) = power of all applied forces: needs every mass, force and constraint right.
TEST_P(EveryModel, EnergyChangesByTheAppliedPower) {
  const Mechanism m = load(GetParam());
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const std::vector<GenericState> states = random_states(m, 3);
  ASSERT_FALSE(states.empty());
  for (const GenericState& state : states) {
    const std::vector<double> tau = random_tau(m, 5);
    GenericDerivative derivative;
    ASSERT_TRUE(solver.accelerations(state, tau, derivative).ok());
    const GenericOutputs here = solver.outputs(state, tau, derivative);
    const auto energy_after = [&](double step) {
      GenericState moved = state;
      moved.t += step;
      for (std::size_t i = 0; i < moved.z.size(); ++i) {
        moved.z[i] += step * state.zd[i] + 0.5 * step * step * derivative.zdd[i];
        moved.zd[i] += step * derivative.zdd[i];
      }
      const GenericOutputs out = solver.outputs(moved, tau, derivative);
      return out.kinetic_energy + out.potential_energy;
    };
    const double h = 1e-5;
    const auto difference = [&](double step) { return (energy_after(step) - energy_after(-step)) / (2 * step); };
    const double rate = (4 * difference(h / 2) - difference(h)) / 3;  // stiff rubber bends the energy over h
    double traffic = std::abs(here.applied_power);                    // sum of the powers that pass through the joints
    for (std::size_t i = 0; i < tau.size(); ++i) traffic += std::abs(tau[i] * state.zd[i]);
    EXPECT_NEAR(rate, here.applied_power, 1e-6 * traffic + 1e-7 * std::abs(here.kinetic_energy) / h * 1e-4 + 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModel, ::testing::ValuesIn(all_models()), test_name);
INSTANTIATE_TEST_SUITE_P(Models, EveryModelWithLoops, ::testing::ValuesIn(models_with_loops()), test_name);

}  // namespace
}  // namespace mbgen
