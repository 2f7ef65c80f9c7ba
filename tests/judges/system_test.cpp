// The Cartesian terms: consistent where the mechanism is closed, derivatives that belong together, and accelerations
// equal to the recursive formulation's.

#include "runtime/judges/system.hpp"

#include "compiler/model/inputs.hpp"
#include "tests/judges/cartesian_support.hpp"
#include "tests/support/reference_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
using Eigen::VectorXd;

VectorXd random_vector(Eigen::Index size, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  VectorXd result(size);
  for (double& value : result) value = unit(random);
  return result;
}

class EveryModel : public ::testing::TestWithParam<std::string> {
 protected:
  const Mechanism m = load(GetParam());
  CartesianSystem system{m.model, m.topology};
  const std::vector<double> no_tau = std::vector<double>(m.topology.bodies.size());

  CartesianTerms terms_at(const CartesianState& state, const GenericState& near) const {
    return system.terms(state, system.joint_state(state, near), no_tau);
  }
};

TEST_P(EveryModel, PlacedBodiesSatisfyEveryConstraint) {
  const std::vector<GenericState> states = random_states(m, 3);
  ASSERT_FALSE(states.empty());
  for (const GenericState& z : states) {
    const CartesianTerms terms = system.terms(system.place(z), z, no_tau);
    ASSERT_EQ(terms.jacobian.rows(), system.equations());
    ASSERT_EQ(terms.jacobian.cols(), system.coordinates());
    EXPECT_LT(largest(terms.residual), 1e-10);
    EXPECT_LT(largest(terms.velocity), 1e-10);
  }
}

// Bodies placed along a tree whose loops are open.
TEST_P(EveryModel, OnlyEquationsOfLoopsCanBeOpen) {
  GenericState z{std::vector<double>(m.topology.bodies.size()), no_tau, {}, 0};
  const VectorXd away = random_vector(m.topology.size(), 8);
  for (int i = 0; i < m.topology.size(); ++i) z.z[i] = 0.1 * away[i];
  z.x = initial_auxiliary_states(m.model);
  const VectorXd residual = system.terms(system.place(z), z, no_tau).residual;
  const int first_motion = system.equations() - static_cast<int>(m.model.motions.size());
  std::vector<double> opening(m.topology.loops.size());
  for (int e = 0; e < first_motion; ++e) {
    const int loop = system.loop_of(e);
    if (loop < 0)
      EXPECT_LT(std::abs(residual[e]), 1e-13);
    else
      opening[loop] = std::max(opening[loop], std::abs(residual[e]));
  }
  for (std::size_t l = 0; l < opening.size(); ++l)
    if (!is_rolling(m.topology.loops[l].kind)) {
      EXPECT_GT(opening[l], 1e-5);
    }
  for (int e = first_motion; e < system.equations(); ++e) EXPECT_EQ(system.loop_of(e), -1);
}

// Only turns of a massive rod about its own axis and rolling are held by a rate without a residual: they are left out.
TEST_P(EveryModel, JacobianIsTheDerivativeOfTheResiduals) {
  constexpr double kStep = 1e-5;  // its square is the truncation error
  const GenericState z = random_states(m, 1).at(0);
  const CartesianState state = system.place(z);
  const CartesianTerms terms = system.terms(state, z, no_tau);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    VectorXd direction = random_vector(system.coordinates(), seed);
    const std::size_t first_rod = m.model.bodies.size() - 1;
    for (std::size_t b = first_rod; b < state.bodies.size(); ++b) {
      const Eigen::Vector3d axis = state.bodies[b].attitude * Eigen::Vector3d::UnitX();
      direction.segment<3>(6 * b + 3) -= axis * axis.dot(direction.segment<3>(6 * b + 3));
    }
    const auto residual_after = [&](double step) {
      CartesianState moved = state;
      system.displace(moved, step * direction);
      return terms_at(moved, z).residual;
    };
    const VectorXd slope = (residual_after(kStep) - residual_after(-kStep)) / (2 * kStep);
    VectorXd error = slope - terms.jacobian * direction;
    for (int e = 0, row = 0; e < error.size(); ++e) {
      const int l = system.loop_of(e);
      row = e > 0 && l == system.loop_of(e - 1) ? row + 1 : 0;
      if (l >= 0 && holds_velocity_alone(m.model, m.topology.loops[l], row)) error[e] = 0;
    }
    EXPECT_LT(largest(error), 1e-8);
  }
}

// Bodies that go on without acceleration violate the velocities at the rate -c.
TEST_P(EveryModel, BiasIsTheRateOfTheVelocityResiduals) {
  constexpr double kStep = 1e-5;
  const GenericState z = random_states(m, 1).at(0);
  const CartesianState state = system.place(z);
  std::vector<double> inputs;
  for (const Input& input : m.model.inputs) inputs.push_back(input.default_value);
  const auto velocity_after = [&](double step) {
    CartesianState moved = state;
    system.displace(moved, step * system.velocities(state));
    moved.t += step;
    system.set_inputs(advanced_inputs(m.model.inputs, inputs, step));
    return terms_at(moved, z).velocity;
  };
  const VectorXd bias = system.terms(state, z, no_tau).bias;
  const VectorXd slope = (velocity_after(kStep) - velocity_after(-kStep)) / (2 * kStep);
  EXPECT_LT(largest(slope + bias), 1e-7 * std::max(1.0, largest(bias)));
}

// Accelerations of the recursive formulation, by other coordinates and other equations; seen: below 5e-12.
TEST_P(EveryModel, AccelerationsAreTheRecursiveOnes) {
  const GenericSolver solver(m.model, m.topology, m.analysis);
  const std::vector<double> tau = random_tau(m, 3);
  for (const double reach : {0.15, 0.8}) {
    for (const GenericState& z : random_states(m, 2, reach)) {
      const CartesianState state = system.place(z);
      const CartesianTerms terms = system.terms(state, z, tau);
      GenericDerivative expected;
      if (!solver.accelerations(z, tau, expected).ok()) continue;
      EXPECT_LT(relative_error(system.joint_accelerations(state, z, solve(terms).qdd), expected.zdd), 1e-10);
      EXPECT_EQ(terms.xd.size(), expected.xd.size());
      EXPECT_LT(relative_error(terms.xd, expected.xd), 1e-12);
    }
  }
}

TEST_P(EveryModel, CoordinatesComeBackFromTheBodies) {
  for (const GenericState& z : random_states(m, 2, 0.3)) {
    GenericState guess = z, turned = z;
    const VectorXd away = random_vector(m.topology.size(), 5);
    for (int i = 0; i < m.topology.size(); ++i) {
      const double turn = m.topology.bodies[i].kind == FreedomKind::revolute ? 2 * M_PI * (i % 3 - 1) : 0;
      turned.z[i] += turn;
      guess.z[i] += turn + 0.2 * away[i];
      guess.zd[i] = 0;
    }
    const GenericState back = system.joint_state(system.place(z), guess);
    EXPECT_LT(relative_error(back.z, turned.z), 1e-13);
    EXPECT_LT(relative_error(back.zd, z.zd), 1e-12);
    EXPECT_EQ(back.x, z.x);
    EXPECT_EQ(back.t, z.t);
  }
}

TEST_P(EveryModel, VelocitiesGoThereAndBack) {
  CartesianState state = system.place(random_states(m, 1).at(0));
  const VectorXd qd = random_vector(system.coordinates(), 2);
  system.set_velocities(state, qd);
  EXPECT_EQ(system.velocities(state), qd);
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModel, ::testing::ValuesIn(all_models()), test_name);

// Mass, gravity, geometry, a rod's mass, motions and forces all change.
TEST(CartesianSystem, TunableParametersAndInputsReachEveryTerm) {
  const Mechanism m = load("tests/data/models/all_elements.json");
  CartesianSystem system(m.model, m.topology);
  GenericSolver solver(m.model, m.topology, m.analysis);
  std::vector<double> parameters, no_tau(m.topology.bodies.size());
  for (const Parameter& parameter : m.model.parameters) parameters.push_back(0.7 * parameter.value);
  system.set_parameters(parameters);
  solver.set_parameters(parameters);
  system.set_inputs({-150});
  solver.set_inputs({-150});
  GenericState z = random_states(m, 1).at(0);
  ASSERT_TRUE(solver.project(z).ok());
  GenericDerivative expected;
  ASSERT_TRUE(solver.accelerations(z, no_tau, expected).ok());
  const CartesianState state = system.place(z);
  const CartesianTerms terms = system.terms(state, z, no_tau);
  EXPECT_LT(largest(terms.residual), 1e-10);
  EXPECT_LT(relative_error(system.joint_accelerations(state, z, solve(terms).qdd), expected.zdd), 1e-10);
}

class Vehicle : public ::testing::TestWithParam<std::string> {};

double worst_error(const Mechanism& m, const std::string& vehicle, std::vector<double> ReferenceState::*expected) {
  CartesianSystem system(m.model, m.topology);
  double worst = 0;
  for (const ReferenceState& reference :
       reference_states(m.topology, "tests/data/reference/" + vehicle + "_states.json")) {
    const CartesianState state = system.place(reference.state);
    const Solution solution = solve(system.terms(state, reference.state, reference.tau));
    const std::vector<double> zdd = system.joint_accelerations(state, reference.state, solution.qdd);
    worst = std::max(worst, relative_error(zdd, reference.*expected));
  }
  return worst;
}

// The reference is good to 1e-11 (tests/data/reference/README.md).
TEST_P(Vehicle, AccelerationsAreThoseOfTheReference) {
  Mechanism m = load("models/" + GetParam() + "_mechanism.json");
  EXPECT_LT(worst_error(m, GetParam(), &ReferenceState::zdd), 1e-11);
  without_rod_masses(m.model);
  EXPECT_LT(worst_error(m, GetParam(), &ReferenceState::zdd_massless_rods), 1e-11);
}

INSTANTIATE_TEST_SUITE_P(Vehicles, Vehicle, ::testing::Values("coach", "truck"),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace mbgen
