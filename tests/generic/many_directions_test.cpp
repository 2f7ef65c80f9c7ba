// Models of many free directions: by the recursive form, without a matrix of the directions. A planar chain is judged
// by the same chain in other coordinates, the absolute angles of its links, with more digits than the engine has.

#include <fmt/format.h>

#include <cmath>
#include <complex>

#include "runtime/generic/by_recursion.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
using Real = long double;
using Complex = std::complex<Real>;

constexpr int kManyLinks = 256;
constexpr double kLink = 0.25, kMass = 2, kInertia = 0.03;  // m, kg, kg m^2
const Complex kCom{0.15L, 0.1L};                            // from the joint, along the link and across

/// A planar chain of pendulums about z. last: mass and inertia of the last link.
std::string chain_text(int links, const std::string& last = R"("mass": 2, "inertia": [0.02, 0.02, 0.03])") {
  std::string bodies = R"("ground": { "points": { "j1": [0, 0, 0] } })", joints;
  for (int k = 1; k <= links; ++k) {
    bodies += fmt::format(
        R"(, "b{0}": {{ {5}, "com": [{1}, 0.1, 0], "points": {{ "j{0}": [{2}, 0, 0], "j{3}": [{4}, 0, 0] }} }})", k,
        kLink * (k - 1) + 0.15, kLink * (k - 1), k + 1, kLink * k,
        k == links ? last : R"("mass": 2, "inertia": [0.02, 0.02, 0.03])");
    joints += fmt::format(R"({0}"j{1}": {{ "type": "revolute", "from": "{2}.j{1}", "to": "b{1}.j{1}", "axis": "z" }})",
                          k > 1 ? ", " : "", k, k > 1 ? fmt::format("b{}", k - 1) : "ground");
  }
  return fmt::format(
      R"({{ "mbgen": 1, "name": "chain", "gravity": [0, 0, 0], "bodies": {{ {} }}, "joints": {{ {} }} }})", bodies,
      joints);
}

/// Solves a symmetric positive definite system by elimination.
std::vector<Real> solution(std::vector<std::vector<Real>> a, std::vector<Real> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real factor = a[k][i] / a[k][k];
      for (std::size_t j = i; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

/// Joint accelerations of the chain by Lagrange's equations in the absolute angles phi of the links: places are
/// sums of kLink exp(i phi), so M_ij = Re w_ij exp(i (phi_j - phi_i)), and squares of rates meet its imaginary part.
std::vector<Real> by_absolute_angles(const GenericState& state, Real tau) {
  const std::size_t n = state.z.size();
  std::vector<Real> phi(n), rate(n);
  for (std::size_t i = 0; i < n; ++i) {
    phi[i] = state.z[i] + (i > 0 ? phi[i - 1] : 0);
    rate[i] = state.zd[i] + (i > 0 ? rate[i - 1] : 0);
  }
  std::vector<std::vector<Real>> mass(n, std::vector<Real>(n, 0));
  std::vector<Real> force(n, 0);
  force[n - 1] = tau;  // of its joint; the torques of two neighbours cancel on the links between
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t outer = std::max(i, j);
      // links beyond the outer one move with both by kLink; the outer one itself by its centre of mass
      const Complex own = i == j ? Complex{std::norm(kCom)} : Complex{kLink} * (i < j ? kCom : std::conj(kCom));
      const Complex weight = Real{kMass} * (own + Complex{Real{kLink} * kLink * static_cast<Real>(n - 1 - outer)});
      const Complex turned = weight * std::polar<Real>(1, phi[j] - phi[i]);
      mass[i][j] = turned.real() + (i == j ? Real{kInertia} : 0);
      force[i] += turned.imag() * rate[j] * rate[j];
    }
  std::vector<Real> zdd = solution(std::move(mass), std::move(force));
  for (std::size_t i = n; i-- > 1;) zdd[i] -= zdd[i - 1];
  return zdd;
}

GenericState bent_state(const Mechanism& m) {
  GenericState state;
  state.x.assign(static_cast<std::size_t>(auxiliary_state_count(m.model)), 0.0);
  for (int i = 0; i < m.topology.size(); ++i) {
    state.z.push_back(0.3 * std::sin(2.0 * i));
    state.zd.push_back(0.4 * std::cos(3.0 * i));
  }
  return state;
}

double largest_error(const std::vector<double>& values, const std::vector<Real>& reference) {
  Real error = 0, size = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    error = std::max(error, std::abs(values[i] - reference[i]));
    size = std::max(size, std::abs(reference[i]));
  }
  return static_cast<double>(error / size);
}

TEST(ManyDirections, AChainIsSolvedWithoutAMatrixAndAsByAbsoluteAngles) {
  const Mechanism m = mechanism_of(chain_text(static_cast<int>(kManyLinks)));
  GenericEquations equations(m.model, m.topology, m.analysis, {});
  ASSERT_TRUE(equations.recursive);
  const GenericState state = bent_state(m);
  const std::vector<double> tau(state.z.size(), 0.5);
  GenericDerivative found;
  ASSERT_TRUE(accelerations_by_recursion(equations, state, tau, found).ok());
  EXPECT_EQ(equations.mass.value.size(), 0U);
  EXPECT_EQ(equations.reduced.mass.size(), 0);
  const std::vector<Real> reference = by_absolute_angles(state, 0.5L);
  const double error = largest_error(found.zdd, reference);
  EXPECT_LT(error, 1e-12);
  // The matrix of relative angles loses digits by its condition.
  GenericDerivative dense;
  const GenericSolver by_matrix(m.model, m.topology, m.analysis, {LinearAlgebra::eigen, Factorisation::lu});
  ASSERT_TRUE(by_matrix.accelerations(state, tau, dense).ok());
  EXPECT_LT(largest_error(dense.zdd, reference), 1e-6);
  EXPECT_LT(error, largest_error(dense.zdd, reference));
}

TEST(ManyDirections, AShortChainIsSolvedByItsMatrix) {
  const Mechanism m = mechanism_of(chain_text(20));
  GenericEquations equations(m.model, m.topology, m.analysis, {});
  EXPECT_FALSE(equations.recursive);
  const GenericState state = bent_state(m);
  GenericDerivative found;
  const GenericSolver solver(m.model, m.topology, m.analysis);
  ASSERT_TRUE(solver.accelerations(state, std::vector<double>(state.z.size(), 0.5), found).ok());
  EXPECT_LT(largest_error(found.zdd, by_absolute_angles(state, 0.5L)), 1e-12);
}

TEST(ManyDirections, NamesTheCoordinateThatMovesNoInertia) {
  const Result<Model> model = read_model(chain_text(static_cast<int>(kManyLinks), R"("mass": 0)"), "chain.json");
  ASSERT_TRUE(static_cast<bool>(model));
  const Diagnostics problems = analysis_problems(*model);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].message,
            fmt::format("coordinate \"j{}\" moves no inertia: its acceleration is not determined", kManyLinks));
}

// Where dense equations of the free directions would take longer.
TEST(ManyDirections, AreSolvedByTheRecursiveForm) {
  const auto is_recursive = [](const char* kind, int size) {
    const Mechanism m = analysed(grown(kind, size));
    return GenericEquations(m.model, m.topology, m.analysis, {}).recursive;
  };
  EXPECT_FALSE(is_recursive("chain", 138));
  EXPECT_TRUE(is_recursive("chain", 139));
  EXPECT_FALSE(is_recursive("ring", 148));
  EXPECT_TRUE(is_recursive("ring", 149));
  EXPECT_FALSE(is_recursive("separate", 235));
  EXPECT_TRUE(is_recursive("separate", 245));
  EXPECT_FALSE(is_recursive("four-bar", 200));
}

class Recursive : public ::testing::TestWithParam<std::string> {};

TEST_P(Recursive, AccelerationsOfLoopsAreThoseOfTheMatrixForm) {
  const Mechanism m = load(GetParam());
  GenericEquations equations(m.model, m.topology, m.analysis, {});
  const GenericSolver by_matrix(m.model, m.topology, m.analysis);
  const std::vector<GenericState> states = random_states(m, 3);
  ASSERT_FALSE(states.empty());
  for (const GenericState& state : states) {
    GenericDerivative expected, actual;
    const std::vector<double> tau = random_tau(m, 2);
    ASSERT_TRUE(by_matrix.accelerations(state, tau, expected).ok());
    ASSERT_TRUE(accelerations_by_recursion(equations, state, tau, actual).ok());
    EXPECT_LT(relative_error(actual.zdd, expected.zdd), 1e-9);
    EXPECT_LT(relative_error(actual.xd, expected.xd), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Recursive, ::testing::ValuesIn(models_with_loops()), test_name);

}  // namespace
}  // namespace mbgen
