// The pieces of the formulation at double, each against its definition by finite differences or direct summation.

#include "compiler/formulation/formulation.hpp"

#include "compiler/reader/read_model.hpp"
#include "tests/support/mechanism_support.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;

using V = Vector<double>;

V vector(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  return {unit(random), unit(random), unit(random)};
}

double distance_between(const V& a, const V& b) { return norm(a - b); }

TEST(Vector, RotationAboutASkewAxisKeepsTheAxisAndLengths) {
  const double s = 1 / std::sqrt(3.0);
  const Matrix<double> r = rotation<double>({s, s, s}, 2 * M_PI / 3);  // permutes the coordinate axes
  EXPECT_LT(distance_between(r * V{1, 0, 0}, {0, 1, 0}), 1e-14);
  EXPECT_LT(distance_between(r * V{0, 1, 0}, {0, 0, 1}), 1e-15);
  EXPECT_LT(distance_between(transposed_times(r, r * V{1, 2, 3}), {1, 2, 3}), 1e-14);
}

TEST(Vector, CoordinateAxesGiveExactZerosAndOnes) {
  const Matrix<double> r = rotation<double>({0, -1, 0}, 0.3);
  EXPECT_EQ(r.y.y, 1.0);
  EXPECT_EQ(r.x.y, 0.0);
  EXPECT_DOUBLE_EQ(r.x.z, std::sin(0.3));
}

/// Ten parameters of a cloud of point masses, by summation.
Inertia<double> cloud(const std::vector<std::pair<double, V>>& masses) {
  Inertia<double> sum;
  for (const auto& [m, r] : masses) sum = sum + Inertia<double>{m, m * r, point_inertia(m, r)};
  return sum;
}

void expect_near(const Inertia<double>& a, const Inertia<double>& b) {
  EXPECT_NEAR(a.mass, b.mass, 1e-14);
  EXPECT_LT(distance_between(a.moment, b.moment), 1e-14);
  for (const V& v : {V{1, 0, 0}, V{0, 1, 0}, V{0, 0, 1}})
    EXPECT_LT(distance_between(a.inertia * v, b.inertia * v), 1e-13);
}

TEST(Inertia, MovedEqualsTheSumOverMovedPoints) {
  std::mt19937_64 random(1);
  const double third = 1 / std::sqrt(3.0);
  const Matrix<double> r = rotation<double>({third, -third, third}, 0.7);
  const V place = vector(random);
  std::vector<std::pair<double, V>> here, there;
  for (double m : {0.3, 1.2, 2.0, 0.7}) {
    const V at = vector(random);
    here.emplace_back(m, at);
    there.emplace_back(m, place + r * at);
  }
  expect_near(moved(r, place, cloud(here)), cloud(there));
}

TEST(Inertia, MomentumIsThatOfItsPoints) {
  std::mt19937_64 random(2);
  std::vector<std::pair<double, V>> points;
  for (double m : {0.3, 1.2, 2.0}) points.emplace_back(m, vector(random));
  const Spatial<double> motion{vector(random), vector(random)};
  Spatial<double> expected;
  for (const auto& [m, r] : points) expected = expected + force_at(m * velocity_at(motion, r), r);
  const Spatial<double> actual = cloud(points) * motion;
  EXPECT_LT(distance_between(actual.linear, expected.linear), 1e-14);
  EXPECT_LT(distance_between(actual.angular, expected.angular), 1e-14);
}

// A uniform rod: two end masses and the coupling give its momentum exactly (theory.md section 5).
TEST(Inertia, RodPairGivesTheInertiaOfAUniformRod) {
  std::mt19937_64 random(3);
  const V a = vector(random), b = vector(random);
  const double mass = 1.7;
  std::vector<std::pair<double, V>> slices;
  const int count = 2000;  // midpoint rule: error of order 1 / count^2
  for (int i = 0; i < count; ++i) slices.emplace_back(mass / count, a + ((i + 0.5) / count) * (b - a));
  const Inertia<double> ends = cloud({{mass / 3, a}, {mass / 3, b}});
  const Inertia<double> whole = ends + pair_inertia(mass / 6, a, b), expected = cloud(slices);
  EXPECT_NEAR(whole.mass, expected.mass, 1e-12);
  EXPECT_LT(distance_between(whole.moment, expected.moment), 1e-12);
  for (const V& v : {V{1, 0, 0}, V{0, 1, 0}, V{0, 0, 1}})
    EXPECT_LT(distance_between(whole.inertia * v, expected.inertia * v), 1e-6);
}

PseudoInertia<double> pseudo_cloud(const std::vector<std::pair<double, V>>& masses) {
  PseudoInertia<double> sum;
  for (const auto& [m, r] : masses) sum = sum + pseudo_inertia(m, m * r, square(m, r));
  return sum;
}

// A body that is symmetric about its joint's axis, about another axis, about all and about none, turned in space and in
// a plane: its points are turned one by one.
TEST(Inertia, AxesOfSymmetryTurnAsTheirBodies) {
  const double s = 1 / std::sqrt(3.0);
  const auto ring = [](double along, double across) {  // about z, its centre off the origin
    const V centre{0.3, -0.2, 0.4};
    std::vector<std::pair<double, V>> masses;
    for (const V& r :
         {V{across, 0, 0}, V{-across, 0, 0}, V{0, across, 0}, V{0, -across, 0}, V{0, 0, along}, V{0, 0, -along}})
      masses.emplace_back(0.7, centre + r);
    return masses;
  };
  auto crooked = ring(0.3, 0.2);
  crooked.emplace_back(0.4, V{0.1, 0.6, -0.3});
  int of_ring = 0;
  for (const auto& masses : {ring(0.3, 0.2), ring(0.2, 0.2), crooked})
    for (const Vector3& axis : {Vector3{0, 0, 1}, Vector3{0, 1, 0}, Vector3{s, -s, s}})
      for (const Matrix<double>& below : {identity<double>(), rotation<double>({s, s, s}, 0.4)}) {
        const Matrix<double> r = below * rotation<double>(axis, 0.7);
        std::vector<std::pair<double, V>> there;
        for (const auto& [m, at] : masses) there.emplace_back(m, r * at);
        const PseudoInertia<double> expected = pseudo_cloud(there), body = pseudo_cloud(masses),
                                    actual = turned(r, axis, below * constant<double>(axis), body);
        EXPECT_LT(distance_between(actual.moment, expected.moment), 1e-15);
        EXPECT_NEAR(actual.trace, expected.trace, 1e-14);
        for (const V& v : {V{1, 0, 0}, V{0, 1, 0}, V{0, 0, 1}})
          EXPECT_LT(distance_between(actual.second * v, expected.second * v), 1e-14);
        of_ring += axial_moments(centred(body), V{0, 0, 1}).has_value();
      }
  EXPECT_EQ(of_ring, 12);  // not the crooked one
}

// Force and moment of a field of accelerations, of one in a plane too, by summation over the points.
TEST(Inertia, FieldForceIsThatOfItsPoints) {
  std::mt19937_64 random(4);
  std::vector<std::pair<double, V>> points;
  for (double m : {0.3, 1.2, 2.0}) points.emplace_back(m, vector(random));
  const V w = vector(random), alpha = vector(random);
  for (const Matrix<double>& g :
       {acceleration_gradient(w, alpha), acceleration_gradient(V{w.x, 0, 0}, V{alpha.x, 0, 0}),
        acceleration_gradient(V{0, w.y, 0}, V{0, alpha.y, 0}), acceleration_gradient(V{0, 0, w.z}, V{0, 0, alpha.z})}) {
    const V a = vector(random);
    Spatial<double> expected;
    for (const auto& [m, r] : points) expected = expected + force_at(m * (a + g * r), r);
    const Spatial<double> actual = field_force(pseudo_cloud(points), a, g);
    EXPECT_LT(distance_between(actual.linear, expected.linear), 1e-14);
    EXPECT_LT(distance_between(actual.angular, expected.angular), 1e-14);
  }
}

/// The formulation at a position and velocity of a model.
struct Numbers {
  const Mechanism& m;
  Layout layout = choose_layout(m.model, m.topology);
  Annotator<double> annotator{};
  System<double> at(const std::vector<double>& z, const std::vector<double>& zd) {
    Environment<double> e;
    e.topology = &m.topology;
    for (const Parameter& p : m.model.parameters) e.parameters.push_back(p.value);
    for (const Input& i : m.model.inputs) e.inputs.push_back(i.default_value);
    e.z = z;
    e.zd = zd;
    System<double> system{m.model, m.topology, layout, e, initial_auxiliary_states(m.model), {}, annotator};
    system.constants = make_constants(m.model, m.topology, system.environment);
    return system;
  }
  std::vector<double> residuals(const std::vector<double>& z) {
    System<double> system = at(z, std::vector<double>(z.size(), 0.0));
    const Kinematics<double> k = kinematics(system);
    std::vector<double> all;
    for (const LoopBlock& block : m.topology.blocks)
      for (double r : closure(system, k, block, at_rest<double>(m.topology)).residual) all.push_back(r);
    return all;
  }
};

/// Whether each row of a block holds velocities alone, and has no residual to be differentiated.
std::vector<bool> of_velocities(const Mechanism& m, const LoopBlock& block) {
  std::vector<bool> result;
  for (const int l : block.loops)
    for (int row = 0; row < m.topology.loops[l].equations; ++row)
      result.push_back(holds_velocity_alone(m.model, m.topology.loops[l], row));
  return result;
}

class EveryModel : public ::testing::TestWithParam<std::string> {};
class EveryModelWithLoops : public ::testing::TestWithParam<std::string> {};

std::vector<double> along(std::vector<double> z, const std::vector<double>& direction, double step) {
  for (std::size_t i = 0; i < z.size(); ++i) z[i] += step * direction[i];
  return z;
}

TEST_P(EveryModelWithLoops, ClosureJacobianIsTheDerivativeOfTheResidual) {
  const Mechanism m = load(GetParam());
  Numbers numbers{m};
  for (const GenericState& state : random_states(m, 2)) {
    System<double> system = numbers.at(state.z, state.zd);
    const Kinematics<double> k = kinematics(system);
    for (std::size_t b = 0, first = 0; b < m.topology.blocks.size(); first += m.topology.blocks[b].equations, ++b) {
      const BlockClosure<double> closed = closure(system, k, m.topology.blocks[b], at_rest<double>(m.topology));
      for (std::size_t c = 0; c < m.topology.blocks[b].joints.size(); ++c) {
        std::vector<double> unit(state.z.size(), 0.0);
        unit[m.topology.blocks[b].joints[c]] = 1;
        const std::vector<double> ahead = numbers.residuals(along(state.z, unit, 1e-5)),
                                  behind = numbers.residuals(along(state.z, unit, -1e-5));
        for (int e = 0; e < m.topology.blocks[b].equations; ++e) {
          if (of_velocities(m, m.topology.blocks[b])[e]) continue;
          EXPECT_NEAR(closed.jacobian[e][c], (ahead[first + e] - behind[first + e]) / 2e-5, 1e-8)
              << equation_names(m.topology, m.topology.blocks[b])[e] << " by "
              << m.topology.bodies[m.topology.blocks[b].joints[c]].coordinate;
        }
      }
    }
  }
}

// At constant joint velocities the second time derivative of the residual is -c.
TEST_P(EveryModelWithLoops, ClosureAccelerationIsTheSecondDerivativeOfTheResidual) {
  const Mechanism m = load(GetParam());
  Numbers numbers{m};
  for (const GenericState& state : random_states(m, 2)) {
    System<double> system = numbers.at(state.z, state.zd);
    const Kinematics<double> k = kinematics(system);
    const double h = 1e-4;
    const std::vector<double> ahead = numbers.residuals(along(state.z, state.zd, h)), here = numbers.residuals(state.z),
                              behind = numbers.residuals(along(state.z, state.zd, -h));
    for (std::size_t b = 0, first = 0; b < m.topology.blocks.size(); first += m.topology.blocks[b].equations, ++b) {
      const LoopBlock& block = m.topology.blocks[b];
      const BlockClosure<double> closed = closure(system, k, block, relative_motion(system, k, block));
      const double scale = 1 + largest_absolute(closed.acceleration);
      for (int e = 0; e < block.equations; ++e) {
        if (of_velocities(m, block)[e]) continue;
        EXPECT_NEAR(-closed.acceleration[e], (ahead[first + e] - 2 * here[first + e] + behind[first + e]) / (h * h),
                    2e-5 * scale)
            << equation_names(m.topology, block)[e];
      }
    }
  }
}

// Rows of velocities have no residual: at constant joint velocities, which need not hold them, their rate is -c.
TEST_P(EveryModelWithLoops, ClosureAccelerationIsTheRateOfRowsOfVelocities) {
  const Mechanism m = load(GetParam());
  Numbers numbers{m};
  for (const GenericState& state : random_states(m, 1)) {
    const std::vector<double> zd = along(state.zd, state.z, 3);
    const auto rates = [&](double step) {
      System<double> system = numbers.at(along(state.z, zd, step), zd);
      const Kinematics<double> k = kinematics(system);
      std::vector<double> all;
      for (const LoopBlock& block : m.topology.blocks)
        for (const std::vector<double>& row : closure(system, k, block, at_rest<double>(m.topology)).jacobian) {
          all.push_back(0);
          for (std::size_t c = 0; c < row.size(); ++c) all.back() += row[c] * zd[block.joints[c]];
        }
      return all;
    };
    const std::vector<double> ahead = rates(1e-5), behind = rates(-1e-5);
    System<double> system = numbers.at(state.z, zd);
    const Kinematics<double> k = kinematics(system);
    std::size_t e = 0;
    for (const LoopBlock& block : m.topology.blocks) {
      const std::vector<double> c = closure(system, k, block, relative_motion(system, k, block)).acceleration;
      const std::vector<bool> wanted = of_velocities(m, block);
      for (std::size_t row = 0; row < c.size(); ++row, ++e) {
        if (!wanted[row]) continue;
        EXPECT_NEAR(-c[row], (ahead[e] - behind[e]) / 2e-5, 1e-6 * (1 + largest_absolute(c))) << e;
      }
    }
  }
}

// Body points differentiated in the global frame: the sweeps, with all their frames, against plain positions.
TEST_P(EveryModel, SweepsGiveTheDerivativesOfGlobalPositions) {
  const Mechanism m = load(GetParam());
  Numbers numbers{m};
  for (const GenericState& state : random_states(m, 2)) {
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::vector<double> zdd;
    for (std::size_t i = 0; i < state.z.size(); ++i) zdd.push_back(unit(random));
    System<double> system = numbers.at(state.z, state.zd);
    const Kinematics<double> k = kinematics(system);
    const Velocities<double> v = velocities(system, k);
    const Accelerations<double> a = accelerations(system, k, v, zdd);
    const auto global = [&](const Place<double>& place, double t) {
      std::vector<double> z = along(state.z, state.zd, t);
      for (std::size_t i = 0; i < z.size(); ++i) z[i] += 0.5 * t * t * zdd[i];
      System<double> moved = numbers.at(z, state.zd);
      return position_in(moved, kinematics(moved), place, kGround);
    };
    const double h = 1e-4;
    for (int i = 0; i < m.topology.size(); ++i) {
      const Place<double> place{i, {0.3, -0.2, 0.5}};
      const V ahead = global(place, h), here = global(place, 0), behind = global(place, -h);
      const V velocity = (1 / (2 * h)) * (ahead - behind),
              acceleration = (1 / (h * h)) * (ahead - here + (behind - here));
      const double scale = 1 + norm(acceleration);
      EXPECT_LT(distance_between(velocity_in(system, k, v, place, kGround), velocity), 1e-6 * scale)
          << m.topology.bodies[i].name;
      const int carrier = system.layout.frame_of(i);
      const V less_gravity =
          direction_in(system, k, carrier, acceleration_of(system, a, i).at(local_position(system, k, place)), kGround);
      EXPECT_LT(distance_between(less_gravity + system.constants.gravity, acceleration), 1e-4 * scale)
          << m.topology.bodies[i].name;
    }
  }
}

// Angles of parallel axes are added; opposite ones, and a move between them, too.
TEST(Kinematics, TurnsAboutParallelAxesAreOneTurn) {
  for (const char* path : {"models/four_bar.json", "tests/data/models/slider_prismatic_cut.json",
                           "tests/data/models/nested_blocks.json", "tests/data/models/reversed_joints.json"}) {
    const Mechanism mechanism = load(path);
    Numbers numbers{mechanism};
    for (const GenericState& state : random_states(mechanism, 2)) {
      System<double> system = numbers.at(state.z, state.zd);
      const Kinematics<double> k = kinematics(system);
      for (int i = 0; i < mechanism.topology.size(); ++i) {
        if (system.layout.bodies[i].chain_start >= 0 || system.on_base(i) || !system.revolute(i)) continue;
        const TreeBody& body = mechanism.topology.bodies[i];
        const Matrix<double> below = k.orientation[body.parent], turn = rotation(body.axis, state.z[i]);
        for (const V& v : {V{1, 0, 0}, V{0, 1, 0}, V{0, 0, 1}})
          EXPECT_LT(distance_between(k.orientation[i] * v, below * (turn * v)), 1e-14) << path << " " << body.name;
        EXPECT_LT(distance_between(k.base_column[i].angular, below * constant<double>(body.axis)), 1e-14);
      }
    }
  }
}

// Origins lie on the axes of their joints, and the arms of the coach have their centres of mass across from them.
TEST(Origins, AreOnTheAxesAndAtTheFeetOfTheCentresOfMass) {
  int slid = 0;
  for (const char* path : {"models/coach_mechanism.json", "tests/data/models/chain_7.json",
                           "tests/data/models/nested_blocks.json", "tests/data/models/reversed_joints.json"}) {
    Result<Model> model = read_model_file(source_path(path));
    for (Rod& rod : model->rods) rod.mass = 0.0;
    const Result<Topology> topology = build_topology(*model);
    Environment<double> e;
    e.topology = &*topology;
    for (const Parameter& p : model->parameters) e.parameters.push_back(p.value);
    for (const Input& input : model->inputs) e.inputs.push_back(input.default_value);
    const Constants<double> c = make_constants(*model, *topology, e);
    for (int i = 0; i < topology->size(); ++i) {
      const TreeBody& body = topology->bodies[i];
      const V axis = constant<double>(body.axis);
      const V off = c.origin[i] - constant<double>(reference_position(*model, model->joints[body.joint].from));
      EXPECT_LT(norm(cross(axis, off)), 1e-14) << path << " " << body.name;
      if (body.kind == FreedomKind::prismatic || body.massless) {
        EXPECT_EQ(norm(off), 0) << path << " " << body.name;
      }
      if (norm(off) > 0) ++slid;
      if (norm(off) > 0 && body.name.starts_with("arb_")) {
        EXPECT_EQ(dot(axis, c.com[i]), 0) << path << " " << body.name;
      }
    }
  }
  EXPECT_GE(slid, 4);
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModel, ::testing::ValuesIn(all_models()), test_name);
INSTANTIATE_TEST_SUITE_P(Models, EveryModelWithLoops, ::testing::ValuesIn(models_with_loops()), test_name);

TEST(Layout, NeitherVehicleMeetsTheInertialOrigin) {
  const Mechanism m = load("models/truck_mechanism.json");
  const Layout layout = choose_layout(m.model, m.topology);
  for (int i = 0; i < m.topology.size(); ++i)
    EXPECT_NE(layout.bodies[i].joint_frame, kGround) << m.topology.bodies[i].coordinate;
}

TEST(Layout, WheelsAreRotorsAndArmsAreNot) {
  const Mechanism m = load("models/coach_mechanism.json");
  const Layout layout = choose_layout(m.model, m.topology);
  for (int i = 0; i < m.topology.size(); ++i)
    EXPECT_EQ(layout.bodies[i].rotor, m.topology.bodies[i].name.starts_with("wheel")) << m.topology.bodies[i].name;
}

}  // namespace
}  // namespace mbgen
