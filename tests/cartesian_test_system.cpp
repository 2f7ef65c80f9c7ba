// The Cartesian terms: consistent where the mechanism is closed, derivatives that belong together, and accelerations
// equal to the recursive formulation's.

#include <fstream>
#include <nlohmann/json.hpp>

#include "runtime/cartesian/system.hpp"
#include "tests/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Accelerations and multipliers of (5): one orthogonal decomposition, minimum norm where multipliers are not unique.
struct Solution {
  VectorXd qdd, lambda;
};

Solution solve(const CartesianTerms& terms) {
  const int n = static_cast<int>(terms.force.size()), m = static_cast<int>(terms.bias.size());
  const double scale = terms.mass.diagonal().maxCoeff();
  MatrixXd matrix = MatrixXd::Zero(n + m, n + m);
  matrix.topLeftCorner(n, n) = terms.mass / scale;
  matrix.topRightCorner(n, m) = terms.jacobian.transpose();
  matrix.bottomLeftCorner(m, n) = terms.jacobian;
  VectorXd right(n + m);
  right << terms.force / scale, terms.bias;
  const VectorXd x = matrix.completeOrthogonalDecomposition().solve(right);
  return {x.head(n), scale * x.tail(m)};
}

class EveryModel : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryModel, PlacedBodiesSatisfyEveryConstraint) {
  const Mechanism m = load(GetParam());
  const CartesianSystem system(m.model, m.topology);
  const std::vector<GenericState> states = random_states(m, 3);
  ASSERT_FALSE(states.empty());
  for (const GenericState& z : states) {
    const CartesianTerms terms = system.terms(system.place(z), z, random_tau(m, 1));
    ASSERT_EQ(terms.jacobian.rows(), system.equations());
    ASSERT_EQ(terms.jacobian.cols(), system.coordinates());
    EXPECT_LT(terms.residual.lpNorm<Eigen::Infinity>(), 1e-10);
    EXPECT_LT(terms.velocity.lpNorm<Eigen::Infinity>(), 1e-10);
  }
}

TEST_P(EveryModel, AccelerationsAreTheRecursiveOnes) {
  const Mechanism m = load(GetParam());
  const CartesianSystem system(m.model, m.topology);
  const GenericSolver solver(m.model, m.topology, m.analysis);
  for (const GenericState& z : random_states(m, 2)) {
    const std::vector<double> tau = random_tau(m, 3);
    const CartesianState state = system.place(z);
    const CartesianTerms terms = system.terms(state, z, tau);
    GenericDerivative expected;
    ASSERT_TRUE(solver.accelerations(z, tau, expected).ok());
    const double error = relative_error(system.joint_accelerations(state, z, solve(terms).qdd), expected.zdd);
    EXPECT_LT(error, 1e-8);
    EXPECT_LT(terms.xd.empty() ? 0 : relative_error(terms.xd, expected.xd), 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModel, ::testing::ValuesIn(all_models()), test_name);

}  // namespace
}  // namespace mbgen
