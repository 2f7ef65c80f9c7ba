// Multipliers, driving forces and reactions of the Cartesian system: hand calculations, Newton's law on every body, and
// the recursive formulation where they are unique.

#include "runtime/judges/system.hpp"
#include "tests/judges/cartesian_support.hpp"
#include "tests/support/mechanism_support.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Index of a model body among those of the Cartesian state, -1 for ground.
int moving_index(const Model& model, int body) {
  return body == model.ground ? -1 : body - (body > model.ground ? 1 : 0);
}

Vector3d vector_of(const Vector3Quantity& q) { return {q[0].value, q[1].value, q[2].value}; }

/// Where a point of a body is, from the body's pose alone.
Vector3d point_of(const Model& model, const CartesianState& state, const Attachment& at) {
  const Body& body = model.bodies[at.body];
  const Vector3d place = vector_of(body.points[at.point].position);
  if (at.body == model.ground) return place;
  const CartesianBody& moving = state.bodies[moving_index(model, at.body)];
  return moving.position + moving.attitude * (place - vector_of(body.com));
}

class EveryModelsReactions : public ::testing::TestWithParam<std::string> {};

/// Wrenches on all bodies about their centres of mass, from the reactions of the joints alone.
VectorXd joint_wrenches(const Model& model, const CartesianState& state,
                        const std::vector<CartesianWrench>& reactions) {
  VectorXd sum = VectorXd::Zero(6 * state.bodies.size());
  for (std::size_t j = 0; j < reactions.size(); ++j) {
    const Joint& joint = model.joints[j];
    const Vector3d at = point_of(model, state, joint.to);
    const auto add = [&](int body, double sign) {
      const int i = moving_index(model, body);
      if (i < 0) return;
      const Vector3d arm = at - state.bodies[i].position;
      sum.segment<3>(6 * i) += sign * reactions[j].force;
      sum.segment<3>(6 * i + 3) += sign * (reactions[j].moment + arm.cross(reactions[j].force));
    };
    add(joint.to.body, 1);
    add(joint.from.body, -1);
  }
  return sum;
}

int rod_rows(const Model& model) {
  int rows = 0;
  for (const Rod& rod : model.rods) rows += rod.mass.expression < 0 && rod.mass.value == 0 ? 1 : 7;
  return rows;
}

TEST_P(EveryModelsReactions, ReactionsMoveEveryBody) {
  const Mechanism m = analysed(with_plain_ropes(load(GetParam()).model));
  const CartesianSystem system(m.model, m.topology);
  Model without_joint_forces = m.model;
  without_joint_forces.joint_springs.clear();
  without_joint_forces.frictions.clear();
  without_joint_forces.joint_forces.clear();
  std::erase_if(without_joint_forces.bump_stops, [](const BumpStop& stop) { return stop.is_on_joint(); });
  const CartesianSystem bare(without_joint_forces, m.topology);
  const auto bristles = std::ranges::count_if(m.model.frictions, &JointFriction::has_bristle);
  const std::vector<double> tau = random_tau(m, 4), no_tau(tau.size());
  for (const GenericState& z : random_states(m, 2)) {
    const CartesianState state = system.place(z);
    const CartesianTerms terms = system.terms(state, z, tau);
    const Solution s = solve(terms);
    const int count = rod_rows(m.model);
    const int first = system.equations() - static_cast<int>(m.model.motions.size()) - count;
    const VectorXd of_rods = terms.jacobian.middleRows(first, count).transpose() * s.lambda.segment(first, count);
    const VectorXd of_joints = joint_wrenches(m.model, state, system.joint_reactions(state, z, tau, s.lambda));
    CartesianState bare_state = state;  // without the bristles of joints
    const auto first_one = bare_state.x.begin() + first_bristle(m.model);
    bare_state.x.erase(first_one, first_one + bristles);
    const VectorXd balance = bare.terms(bare_state, z, no_tau).force - of_rods + of_joints - terms.mass * s.qdd;
    EXPECT_LT(largest(balance), 1e-9 * std::max(1.0, largest(s.lambda)));
  }
}

// Only blocks without redundant equations have unique multipliers.
TEST_P(EveryModelsReactions, UniqueMultipliersAndDrivesAreTheRecursiveOnes) {
  Mechanism m = load(GetParam());
  m.model.outputs.clear();
  for (std::size_t k = 0; k < m.model.motions.size(); ++k) {
    Output output;
    output.source = DriveOutput{static_cast<int>(k)};
    m.model.outputs.push_back(output);
  }
  const CartesianSystem system(m.model, m.topology);
  const GenericSolver solver(m.model, m.topology, m.analysis);
  std::vector<bool> is_unique(m.topology.loops.size());
  for (std::size_t b = 0; b < m.topology.blocks.size(); ++b)
    for (int loop : m.topology.blocks[b].loops)
      is_unique[loop] = m.analysis.blocks[b].rank == m.topology.blocks[b].equations;
  const std::vector<double> tau = random_tau(m, 6);
  for (const GenericState& z : random_states(m, 2)) {
    GenericDerivative derivative;
    ASSERT_TRUE(solver.accelerations(z, tau, derivative).ok());
    const CartesianState state = system.place(z);
    const VectorXd lambda = solve(system.terms(state, z, tau)).lambda;
    const std::vector<double> expected = solver.multipliers(z, tau, derivative);
    std::vector<double> actual = system.loop_multipliers(state, lambda);
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t l = 0, e = 0; l < m.topology.loops.size(); ++l)
      for (int k = 0; k < m.topology.loops[l].equations; ++k, ++e)
        if (!is_unique[l]) actual[e] = expected[e];
    EXPECT_LT(relative_error(actual, expected), 1e-9);
    EXPECT_LT(relative_error(system.driving_forces(lambda), solver.outputs(z, tau, derivative).y), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModelsReactions, ::testing::ValuesIn(all_models()), test_name);

struct Solved {
  CartesianState state;
  std::vector<CartesianWrench> reactions;
  std::vector<double> loops, drives;
};

Solved solved(const std::string& text, GenericState z, std::vector<double> tau) {
  const Model model = read(text);
  const Topology topology = *build_topology(model);
  const CartesianSystem system(model, topology);
  const CartesianState state = system.place(z);
  const VectorXd lambda = solve(system.terms(state, z, tau)).lambda;
  return {state, system.joint_reactions(state, z, tau, lambda), system.loop_multipliers(state, lambda),
          system.driving_forces(lambda)};
}

void expect_near(const Vector3d& actual, const Vector3d& expected) {
  EXPECT_LT((actual - expected).norm(), 1e-12 * std::max(1.0, expected.norm())) << actual.transpose();
}

/// A bob of 2 kg half a metre out on an arm about y, and where its pin ends: "from": ..., "to": ...
std::string bob(const std::string& ends, const std::string& sections = "") {
  return R"({ "mbgen": 1, "gravity": [0, 0, -10], "bodies": { "ground": { "points": { "A": [0, 0, 0] } },
    "arm": { "mass": 2, "com": [0.5, 0, 0], "inertia": [0, 0.3, 0.3], "points": { "A": [0, 0, 0] } } },
    "joints": { "pin": { "type": "revolute", )" +
         ends + R"(, "axis": "y" } })" + sections + " }";
}

// z'' = (m g a + tau) / (J + m a^2) = 25 rad/s^2; the bob goes down with 12.5 m/s^2 and inwards with 0.5 * 3^2 m/s^2.
TEST(Reactions, OfASwingingArm) {
  const Solved s = solved(bob(R"("from": "ground.A", "to": "arm.A")"), {{0}, {3}, {}, 0}, {10});
  expect_near(s.reactions[0].force, {-9, 0, -5});
  expect_near(s.reactions[0].moment, {0, 10, 0});
}

// The same arm, held by its other end: what it gives to ground is opposite.
TEST(Reactions, OfAJointWhoseToBodyIsGround) {
  const Solved s = solved(bob(R"("from": "arm.A", "to": "ground.A")"), {{0}, {-3}, {}, 0}, {-10});
  expect_near(s.reactions[0].force, {9, 0, 5});
  expect_near(s.reactions[0].moment, {0, -10, 0});
}

// Held at 3 rad/s: the drive lifts the arm against m g a = 10 N m.
TEST(Reactions, OfADrive) {
  const std::string drive = R"(, "motions": { "m": { "joint": "pin", "angle": "3*t" } })";
  const Solved s = solved(bob(R"("from": "ground.A", "to": "arm.A")", drive), {{0}, {3}, {}, 0}, {0});
  EXPECT_NEAR(s.drives[0], -10, 1e-13);
  expect_near(s.reactions[0].force, {-9, 0, 20});
  expect_near(s.reactions[0].moment, {0, -10, 0});
}

/// A ball of 2 kg that only a rod of 1 m holds to the ground 1 m above, turning about the vertical.
std::string hanging(const std::string& mass) {
  return R"({ "mbgen": 1, "gravity": [0, 0, -10], "bodies": { "ground": { "points": { "A": [0, 0, 0], "B": [0, 0, -1] } },
    "ball": { "mass": 2, "inertia": [0.1, 0.1, 0.1], "points": { "C": [0, 0, -1] } } },
    "joints": { "way": { "type": "free", "from": "ground.B", "to": "ball.C" } },
    "rods": { "rod": { "from": "ground.A", "to": "ball.C", "mass": )" +
         mass + " } } }";
}

// The ball swings through its lowest point with 3 m/s: tension m (g + v^2 / l). A rod's own mass adds, with half of it
// split among its ends (theory.md section 5), (m_jk + m_kk) g + m_kk v^2 / l: what the lower end is held up with.
TEST(LoopMultipliers, OfARodUnderTension) {
  const GenericState z{{0, 0, 0, 0, 0, 0}, {3, 0, 0, 0, 0, 0}, {}, 0};
  const std::vector<double> tau(6);
  EXPECT_NEAR(solved(hanging("0"), z, tau).loops[0], 2 * (10 + 9), 1e-12);
  EXPECT_NEAR(solved(hanging("0.6"), z, tau).loops[0], 2 * (10 + 9) + 0.3 * 10 + 0.2 * 9, 1e-12);
}

}  // namespace
}  // namespace mbgen
