// The four formulations on terms made by hand: pendulums in Cartesian coordinates, whose equations anybody can check.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "runtime/judges/methods.hpp"
#include "runtime/judges/runge_kutta.hpp"
#include "tests/judges/cartesian_support.hpp"

namespace mbgen {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kGravity = 9.81;
Eigen::Matrix3d cross(const Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// Equations under construction: bodies of given mass and inertia, pins about y between points.
struct Terms {
  MatrixXd mass, jacobian;
  VectorXd force, bias;

  explicit Terms(int bodies)
      : mass(MatrixXd::Zero(6 * bodies, 6 * bodies)),
        jacobian(0, 6 * bodies),
        force(VectorXd::Zero(6 * bodies)),
        bias(0) {}

  void weigh(int body, double m, double inertia) {
    mass.block<3, 3>(6 * body, 6 * body) = m * Eigen::Matrix3d::Identity();
    mass.block<3, 3>(6 * body + 3, 6 * body + 3) = inertia * Eigen::Matrix3d::Identity();
    force[6 * body + 2] = -m * kGravity;
  }
  void add(const VectorXd& row, double c) {
    jacobian.conservativeResize(jacobian.rows() + 1, Eigen::NoChange);
    jacobian.row(jacobian.rows() - 1) = row;
    bias.conservativeResize(bias.size() + 1);
    bias[bias.size() - 1] = c;
  }
  /// Point at `arm` of body `to` on a point of body `from` (-1 is ground); both turn about y only.
  void pin(int from, const Vector3d& arm_from, int to, const Vector3d& arm_to, double spin_from, double spin_to) {
    const Vector3d y = Vector3d::UnitY();
    const auto centripetal = [&y](double spin, const Vector3d& arm) {
      return Vector3d(spin * y.cross(spin * y.cross(arm)));
    };
    const Vector3d c = centripetal(spin_from, arm_from) - centripetal(spin_to, arm_to);
    MatrixXd rows = MatrixXd::Zero(5, jacobian.cols());
    rows.block<3, 3>(0, 6 * to) = Eigen::Matrix3d::Identity();
    rows.block<3, 3>(0, 6 * to + 3) = -cross(arm_to);
    rows(3, 6 * to + 3) = rows(4, 6 * to + 5) = 1;
    if (from >= 0) {
      rows.block<3, 3>(0, 6 * from) = -Eigen::Matrix3d::Identity();
      rows.block<3, 3>(0, 6 * from + 3) = cross(arm_from);
      rows(3, 6 * from + 3) = rows(4, 6 * from + 5) = -1;
    }
    for (int k = 0; k < 5; ++k) add(rows.row(k).transpose(), k < 3 ? c[k] : 0.0);
  }

  ConstraintFactors factors() const { return {jacobian, {}}; }
  CartesianSolution solution(CartesianMethod method) const {
    const ConstraintFactors f = factors();
    return solve(method, {mass, force, f, f.reduce(bias)});
  }
  double balance_error(const CartesianSolution& s) const {
    return (mass * s.qdd + jacobian.transpose() * s.lambda - force).cwiseAbs().maxCoeff();
  }
};

/// A body whose centre is 0.7 m from a pin in ground, at `angle` from the vertical.
Terms pendulum(double inertia, double angle, double spin) {
  Terms terms(1);
  terms.weigh(0, 3, inertia);
  terms.pin(-1, Vector3d::Zero(), 0, 0.7 * Vector3d(std::sin(angle), 0, std::cos(angle)), 0, spin);
  return terms;
}

class Methods : public ::testing::TestWithParam<CartesianMethod> {};

TEST_P(Methods, PendulumFallsAsItShould) {
  for (double inertia : {0.4, 0.0}) {  // a point mass makes M singular
    const Terms terms = pendulum(inertia, 0.6, 2.5);
    const CartesianSolution s = terms.solution(GetParam());
    // the arm points from the centre up to the pin: the body hangs at -0.7 (sin, cos)
    const double expected = -3 * kGravity * 0.7 * std::sin(0.6) / (inertia + 3 * 0.49);
    EXPECT_NEAR(s.qdd[4], expected, 1e-13);
    EXPECT_LT(terms.balance_error(s), 1e-12);
    const Vector3d pull(s.lambda[0], s.lambda[1], s.lambda[2]);  // M qdd = F - lambda at the centre
    EXPECT_NEAR(pull.dot(Vector3d(std::sin(0.6), 0, std::cos(0.6))), -3 * (0.7 * 2.5 * 2.5 + kGravity * std::cos(0.6)),
                1e-12);
  }
}

TEST_P(Methods, RedundantEquationsChangeNothing) {
  const Terms plain = pendulum(0.4, 0.6, 2.5);
  Terms redundant = plain;
  const MatrixXd rows = plain.jacobian;
  redundant.add(rows.row(0).transpose() * 2 - rows.row(4).transpose(), 2 * plain.bias[0] - plain.bias[4]);
  redundant.pin(-1, Vector3d::Zero(), 0, 0.7 * Vector3d(std::sin(0.6), 0, std::cos(0.6)), 0, 2.5);
  EXPECT_EQ(redundant.factors().rank(), 5);
  const CartesianSolution s = redundant.solution(GetParam());
  EXPECT_LT((s.qdd - plain.solution(GetParam()).qdd).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT(redundant.balance_error(s), 1e-12);
  EXPECT_EQ((s.lambda.array() == 0).count() >= 6, true) << "redundant equations carry nothing";
  EXPECT_LT(redundant.factors().reduce(redundant.bias).dropped.cwiseAbs().maxCoeff(), 1e-14);
}

/// A massless body between ground and a pendulum: two pins, the second 0.2 m right of the first.
Terms hung_from_a_massless_link(double angle, double spin) {
  Terms terms(2);
  terms.weigh(1, 3, 0.4);
  terms.pin(-1, Vector3d::Zero(), 0, Vector3d(-0.1, 0, 0), 0, 1.5);
  terms.pin(0, Vector3d(0.1, 0, 0), 1, 0.7 * Vector3d(std::sin(angle), 0, std::cos(angle)), 1.5, spin);
  return terms;
}

// The link is a rod that pulls along x only. Equations of the second body along its pin's z and about its pin:
// z of the pin is constrained by nothing but inertia, so the force along z is zero.
TEST_P(Methods, MasslessLinkTransmitsForceAlongItselfOnly) {
  const Terms terms = hung_from_a_massless_link(0.6, 2.5);
  EXPECT_EQ(motion_without_inertia(terms.mass, terms.factors()), std::nullopt);
  const CartesianSolution s = terms.solution(GetParam());
  EXPECT_LT(terms.balance_error(s), 1e-11);
  EXPECT_NEAR(s.lambda[2], 0, 1e-11);
  EXPECT_NEAR(s.qdd[6 + 2], -kGravity, 1e-12);
  // about the centre: only the horizontal force of the pin turns the body, and only it accelerates the centre along x
  const double force = 3 * s.qdd[6];
  EXPECT_NEAR(0.4 * s.qdd[6 + 4], 0.7 * std::cos(0.6) * force, 1e-12);
  EXPECT_LT((terms.jacobian * s.qdd - terms.bias).cwiseAbs().maxCoeff(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(All, Methods, ::testing::ValuesIn(mbgen::testing::kMethods),
                         ::testing::PrintToStringParamName());

TEST(Existence, MotionThatNoMassResistsIsFound) {
  // a point mass whose pin is at its centre: it turns freely without inertia
  Terms point(1);
  point.weigh(0, 3, 0);
  point.pin(-1, Vector3d::Zero(), 0, Vector3d::Zero(), 0, 0);
  const std::optional<VectorXd> motion = motion_without_inertia(point.mass, point.factors());
  ASSERT_TRUE(motion);
  EXPECT_LT((*motion / (*motion)[4] - VectorXd::Unit(6, 4)).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(ConstraintFactors, BasisAndRightInverseFulfilTheirEquations) {
  std::srand(4);
  MatrixXd jacobian = MatrixXd::Random(9, 12);
  jacobian.row(5) = 2 * jacobian.row(1) - jacobian.row(7);
  const ConstraintFactors factors(jacobian, {});
  ASSERT_EQ(factors.rank(), 8);
  EXPECT_LT((jacobian * factors.null_basis()).cwiseAbs().maxCoeff(), 1e-14);
  const VectorXd qdd = VectorXd::Random(12), c = jacobian * qdd;
  const ReducedBias bias = factors.reduce(c);
  EXPECT_LT(bias.dropped.cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_LT((jacobian * factors.particular(bias.kept) - c).cwiseAbs().maxCoeff(), 1e-13);
  const VectorXd reduced = VectorXd::Random(8);
  EXPECT_LT((jacobian.transpose() * factors.multipliers(reduced) - factors.reduced().transpose() * reduced)
                .cwiseAbs()
                .maxCoeff(),
            1e-13);
  int redundant = 0;
  while (factors.multipliers(VectorXd::Ones(8))[redundant] != 0) ++redundant;
  const VectorXd weights = factors.dependency(redundant);
  EXPECT_EQ(weights[redundant], 1);
  EXPECT_LT((jacobian.transpose() * weights).cwiseAbs().maxCoeff(), 1e-14);
  const std::vector<int> chosen = ConstraintFactors(jacobian, {1e-10, {5, 7, 2}}).kept();
  EXPECT_EQ(std::set<int>(chosen.begin(), chosen.end()), (std::set<int>{2, 5, 7}));
}

TEST(ConstraintFactors, ContradictionShowsInTheDroppedEquations) {
  MatrixXd jacobian(2, 3);
  jacobian << 1, 2, 0, 2, 4, 0;
  const ConstraintFactors factors(jacobian, {});
  EXPECT_EQ(factors.rank(), 1);
  EXPECT_NEAR(factors.reduce(Eigen::Vector2d(1, 2)).dropped.norm(), 0, 1e-15);
  EXPECT_NEAR(factors.reduce(Eigen::Vector2d(1, 2.5)).dropped.norm(), 0.25, 1e-15);
}

/// A gyroscope without torque: angular momentum stays, so the attitude of a symmetric body is known in closed form.
TEST(RungeKutta, SymmetricTopTurnsWithOrderFour) {
  const Eigen::Vector3d inertia(0.2, 0.2, 0.5), spin(1.5, 0, 4);  // body axes
  const auto derivative = [&inertia](const CartesianState& state, CartesianRates& rates) {
    const CartesianBody& body = state.bodies[0];
    const Eigen::Matrix3d axes = body.attitude.toRotationMatrix();
    const Eigen::Matrix3d global = axes * inertia.asDiagonal() * axes.transpose();
    rates.qdd = VectorXd::Zero(6);
    rates.qdd.tail<3>() = global.inverse() * -body.spin.cross(global * body.spin);
    return Status{};
  };
  const auto error = [&](int steps) {
    CartesianState state;
    state.bodies.push_back({Vector3d::Zero(), Eigen::Quaterniond::Identity(), Vector3d(1, 0, 0), spin});
    for (int k = 0; k < steps; ++k) EXPECT_TRUE(runge_kutta_step(derivative, state, 1.0 / steps).ok());
    // precession about the momentum at |L| / J1, own rotation at w3 (1 - J3 / J1)
    const Vector3d momentum = inertia.cwiseProduct(spin);
    const double own = spin.z() * (1 - inertia.z() / inertia.x());
    const Eigen::Quaterniond exact =
        Eigen::Quaterniond(Eigen::AngleAxisd(momentum.norm() / inertia.x(), momentum.normalized())) *
        Eigen::Quaterniond(Eigen::AngleAxisd(own, Vector3d::UnitZ()));
    EXPECT_NEAR(state.bodies[0].position.x(), 1, 1e-13);
    EXPECT_NEAR(state.t, 1, 1e-13);
    return state.bodies[0].attitude.angularDistance(exact);
  };
  const double coarse = error(100), fine = error(200);
  EXPECT_LT(coarse, 1e-5);
  EXPECT_NEAR(std::log2(coarse / fine), 4, 0.2);
}

}  // namespace
}  // namespace mbgen
