// Derivatives of accelerations by masses, stiffnesses and gravity, as the solver with derivatives has them, against a
// complex step of a judge of its own: Newton-Euler equations of the tree at the global origin with multipliers of every
// closure. A step of 1e-30 i leaves no error of truncation and none of cancellation. Source: W. Squire, G. Trapp, Using
// Complex Variables to Estimate Derivatives of Real Functions, SIAM Review 40, 1998.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <complex>
#include <map>
#include <nlohmann/json.hpp>

#include "compiler/compile.hpp"
#include "compiler/passes/passes.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/system/property/properties.hpp"

namespace mbgen::testing::complex_step {
namespace {

using Number = std::complex<double>;
using Vector = Eigen::Matrix<Number, 3, 1>;
using Turn = Eigen::Matrix<Number, 3, 3>;
using Twist = Eigen::Matrix<Number, 6, 1>;  ///< turning first, then the point of the body at the global origin
using Numbers = Eigen::VectorX<Number>;
using Matrix = Eigen::MatrixX<Number>;

constexpr double kStep = 1e-30;

Vector vector_of(const Point& p) { return Vector(p[0], p[1], p[2]); }
/// Of complex vectors without conjugates, which are not analytic.
Vector cross(const Vector& a, const Vector& b) {
  return Vector(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
}
Number dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Turn crossing(const Vector& a) {
  Turn result;
  result << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return result;
}
Turn turn_about(const Vector& axis, Number angle) {
  const Turn k = crossing(axis);
  return Turn::Identity() + std::sin(angle) * k + (1.0 - std::cos(angle)) * (k * k);
}

/// Numbers of a mechanism that derivatives are taken by.
struct Varied {
  Number gravity, mass, stiffness;  ///< of all; of body 0; of link 0
};

/// The body that a tree body is a part of, seen at the global origin.
struct Seen {
  Turn turn = Turn::Identity();  ///< a point r of the reference is at turn r + shift
  Vector shift = Vector::Zero();
  Twist velocity = Twist::Zero(), bias = Twist::Zero();  ///< bias: of the acceleration without zdd
  std::vector<int> path;                                 ///< tree bodies from the root to it
};

/// One way to say the equations of motion; nothing of it is mbgen's but the tree.
class ComplexJudge {
 public:
  ComplexJudge(const RandomMechanism& random, const Topology& topology, const Varied& varied)
      : random_(random), topology_(topology), varied_(varied) {}

  Numbers accelerations(const std::vector<double>& z, const std::vector<double>& zd, const std::vector<double>& tau) {
    see(z, zd);
    const Eigen::Index n = static_cast<Eigen::Index>(z.size());
    mass_ = Matrix::Zero(n, n);
    force_ = Numbers::Zero(n);
    for (Eigen::Index i = 0; i < n; ++i) force_[i] = tau[static_cast<std::size_t>(i)];
    for (std::size_t b = 0; b < random_.bodies.size(); ++b) add_body(static_cast<int>(b));
    for (std::size_t k = 0; k < random_.links.size(); ++k) add_link(k);
    for (std::size_t j = 0; j < random_.joints.size(); ++j)
      if (!is_in_tree(static_cast<int>(j))) close(random_.joints[j]);
    const Eigen::Index rows = static_cast<Eigen::Index>(rows_.size());
    Matrix all = Matrix::Zero(n + rows, n + rows);
    Numbers right(n + rows);
    all.topLeftCorner(n, n) = mass_;
    right.head(n) = force_;
    for (Eigen::Index r = 0; r < rows; ++r) {
      all.block(n + r, 0, 1, n) = rows_[static_cast<std::size_t>(r)].transpose();
      all.block(0, n + r, n, 1) = rows_[static_cast<std::size_t>(r)];
      right[n + r] = sides_[static_cast<std::size_t>(r)];
    }
    return solution(all, right).head(n);
  }

 private:
  bool is_in_tree(int joint) const {
    return std::ranges::any_of(topology_.bodies, [&](const TreeBody& body) { return body.joint == joint; });
  }
  const Seen& body(int index) const { return index == kOnGround ? ground_ : seen_[place_.at(index)]; }
  static Vector at(const Seen& seen, const Vector& point) { return seen.turn * point + seen.shift; }
  static Vector velocity_at(const Seen& seen, const Vector& place) {
    return seen.velocity.tail<3>() + cross(seen.velocity.head<3>(), place);
  }

  /// Poses, velocities and accelerations at zdd = 0, from the root outwards.
  void see(const std::vector<double>& z, const std::vector<double>& zd) {
    for (std::size_t i = 0; i < topology_.bodies.size(); ++i) {
      const TreeBody& tree = topology_.bodies[i];
      Seen seen = tree.parent == kGround ? ground_ : seen_[static_cast<std::size_t>(tree.parent)];
      const Vector axis(tree.axis[0], tree.axis[1], tree.axis[2]);
      const Vector pin = vector_of(random_.joints[static_cast<std::size_t>(tree.joint)].at);
      const Vector now = seen.turn * axis, here = at(seen, pin);
      Twist along;
      if (tree.kind == FreedomKind::revolute) {
        along << now, cross(here, now);
        const Turn turn = turn_about(now, z[i]);
        seen.shift = turn * (seen.shift - here) + here;
        seen.turn = turn * seen.turn;
      } else {
        along << Vector::Zero(), now;
        seen.shift += now * z[i];
      }
      const Twist v = seen.velocity;
      Twist turned;
      turned << cross(v.head<3>(), along.head<3>()),
          cross(v.head<3>(), along.tail<3>()) + cross(v.tail<3>(), along.head<3>());
      seen.bias += turned * zd[i];
      seen.velocity += along * zd[i];
      seen.path.push_back(static_cast<int>(i));
      along_.push_back(along);
      if (tree.model_body >= 0) place_[tree.model_body - first_body()] = i;
      seen_.push_back(seen);
    }
  }
  /// Ground is the first body of the model.
  static int first_body() { return 1; }

  /// A wrench of moment and force at the origin acts on a body.
  void push(const Seen& seen, const Twist& wrench) {
    for (const int i : seen.path) force_[i] += (along_[static_cast<std::size_t>(i)].transpose() * wrench)(0);
  }

  void add_body(int index) {
    const RandomBody& data = random_.bodies[static_cast<std::size_t>(index)];
    if (data.mass == 0) return;
    const Number mass = index == 0 ? varied_.mass : Number(data.mass);
    const Seen& seen = body(index);
    const auto& I = data.inertia;
    Turn about;
    about << I[0], I[3], I[4], I[3], I[1], I[5], I[4], I[5], I[2];
    const Vector c = at(seen, vector_of(data.com));
    const Turn moved = crossing(c);
    Eigen::Matrix<Number, 6, 6> inertia;
    inertia.topLeftCorner<3, 3>() = seen.turn * about * seen.turn.transpose() - mass * (moved * moved);
    inertia.topRightCorner<3, 3>() = mass * moved;
    inertia.bottomLeftCorner<3, 3>() = -mass * moved;
    inertia.bottomRightCorner<3, 3>() = mass * Turn::Identity();
    for (const int i : seen.path)
      for (const int j : seen.path)
        mass_(i, j) +=
            (along_[static_cast<std::size_t>(i)].transpose() * inertia * along_[static_cast<std::size_t>(j)])(0);
    const Twist momentum = inertia * seen.velocity, rest = inertia * seen.bias;
    const Vector w = seen.velocity.head<3>(), v = seen.velocity.tail<3>();
    Twist wrench;
    wrench << cross(w, momentum.head<3>()) + cross(v, momentum.tail<3>()), cross(w, momentum.tail<3>());
    const Vector weight = mass * varied_.gravity * vector_of(random_.gravity);
    Twist pull;
    pull << cross(c, weight), weight;
    push(seen, pull - wrench - rest);
  }

  void add_link(std::size_t k) {
    const RandomLink& link = random_.links[k];
    const Seen &a = body(link.from), &b = body(link.to);
    const Vector from = at(a, vector_of(link.start)), to = at(b, vector_of(link.end)), way = to - from;
    if (link.stiffness == 0) {
      const Vector rate = velocity_at(b, to) - velocity_at(a, from);
      add_row(a, from, b, to, way, -dot(rate, rate));
      return;
    }
    const Number length = std::sqrt(dot(way, way)), stiffness = k == 0 ? varied_.stiffness : Number(link.stiffness);
    const Vector pull = way * (stiffness * (length - kFreeLength) / length);
    Twist on_a, on_b;
    on_a << cross(from, pull), pull;
    on_b << -cross(to, pull), -pull;
    push(a, on_a);
    push(b, on_b);
  }

  /// The row: direction times the difference of the accelerations of two points is `side`.
  void add_row(const Seen& a, const Vector& from, const Seen& b, const Vector& to, const Vector& direction,
               Number side) {
    const auto bias_at = [](const Seen& seen, const Vector& place) {
      return Vector(seen.bias.tail<3>() + cross(seen.bias.head<3>(), place) +
                    cross(seen.velocity.head<3>(), velocity_at(seen, place)));
    };
    Numbers row = Numbers::Zero(force_.size());
    const auto add = [&](const Seen& seen, const Vector& place, double sign) {
      for (const int i : seen.path) {
        const Twist& along = along_[static_cast<std::size_t>(i)];
        row[i] += sign * dot(direction, Vector(along.tail<3>() + cross(along.head<3>(), place)));
      }
    };
    add(b, to, 1);
    add(a, from, -1);
    rows_.push_back(row);
    sides_.push_back(side - dot(direction, Vector(bias_at(b, to) - bias_at(a, from))));
  }

  /// Point by point: a spherical joint holds one, a revolute one two on its axis.
  void close(const RandomJoint& joint) {
    const Seen &a = body(joint.from), &b = body(joint.to);
    const Vector pin = vector_of(joint.at);
    for (int point = 0; point < (joint.type == "revolute" ? 2 : 1); ++point) {
      const Vector place = pin + Number(point) * vector_of(joint.axis);
      for (int i = 0; i < 3; ++i) add_row(a, at(a, place), b, at(b, place), Vector::Unit(i), 0.0);
    }
  }

  /// Gauss, pivots by their absolute values; equations that repeat others leave.
  static Numbers solution(Matrix a, Numbers right) {
    const Eigen::Index n = a.rows();
    std::vector<Eigen::Index> column(static_cast<std::size_t>(n));
    for (Eigen::Index i = 0; i < n; ++i) column[static_cast<std::size_t>(i)] = i;
    Eigen::Index rank = 0;
    double first = 0;
    for (; rank < n; ++rank) {
      Eigen::Index r = 0, c = 0;
      const double largest = a.bottomRightCorner(n - rank, n - rank).cwiseAbs().maxCoeff(&r, &c);
      first = std::max(first, largest);
      if (largest < 1e-9 * first) break;
      a.row(rank).swap(a.row(rank + r));
      std::swap(right[rank], right[rank + r]);
      a.col(rank).swap(a.col(rank + c));
      std::swap(column[static_cast<std::size_t>(rank)], column[static_cast<std::size_t>(rank + c)]);
      for (Eigen::Index i = rank + 1; i < n; ++i) {
        const Number factor = a(i, rank) / a(rank, rank);
        a.row(i) -= factor * a.row(rank);
        right[i] -= factor * right[rank];
      }
    }
    Numbers found = Numbers::Zero(n), result(n);
    for (Eigen::Index i = rank; i-- > 0;) {
      found[i] = right[i];
      for (Eigen::Index j = i + 1; j < rank; ++j) found[i] -= a(i, j) * found[j];
      found[i] /= a(i, i);
    }
    for (Eigen::Index i = 0; i < n; ++i) result[column[static_cast<std::size_t>(i)]] = found[i];
    return result;
  }

  const RandomMechanism& random_;
  const Topology& topology_;
  Varied varied_;
  Seen ground_;
  std::vector<Seen> seen_;
  std::vector<Twist> along_;
  std::map<int, std::size_t> place_;  ///< tree body of each body
  Matrix mass_;
  Numbers force_;
  std::vector<Numbers> rows_;
  std::vector<Number> sides_;
};

/// Whether the judge knows all that the mechanism has.
bool is_plain(const RandomMechanism& random) {
  const auto is_known = [](const RandomJoint& joint) {
    return (joint.type == "revolute" || joint.type == "spherical" || (joint.type == "prismatic" && !joint.cut)) &&
           joint.swing == 0;
  };
  const auto is_massless = [](const RandomLink& link) { return link.mass == 0; };
  return !is_driven(random) && random.bushings.empty() && random.relations.empty() && !random.bodies.empty() &&
         random.bodies[0].mass > 0 && std::ranges::all_of(random.joints, is_known) &&
         std::ranges::all_of(random.links, is_massless);
}

/// The model with tunable gravity, mass of body 0 and stiffness of link 0, where this is a spring.
std::string varied_text(const RandomMechanism& random) {
  nlohmann::ordered_json model = nlohmann::ordered_json::parse(model_text(random));
  const auto tunable = [&](const char* name, double value) {
    model["parameters"][name] = {{"value", value}, {"tunable", true}};
  };
  tunable("gravity", 1);
  tunable("mass", random.bodies[0].mass);
  for (int i = 0; i < 3; ++i) model["gravity"][i] = nlohmann::json(random.gravity[i]).dump() + "*gravity";
  model["bodies"][random.bodies[0].name]["mass"] = "mass";
  if (!random.links.empty() && random.links[0].stiffness > 0) {
    tunable("stiffness", random.links[0].stiffness);
    model["springs"][random.links[0].name]["stiffness"] = "stiffness";
  }
  model.erase("outputs");
  return model.dump();
}

using Values = std::map<Slot, double>;

/// Outputs of a program and their derivatives; inputs and their derivatives are in `given`.
Values apart_at(const Program& program, Values given) {
  const auto all = [](const Slot&) { return true; };
  const DerivativesApart apart = take_derivatives_apart(program, all, all);
  const auto outputs = [&](const Program& one) {
    std::vector<double> inputs;
    for (const Slot& slot : one.inputs) inputs.push_back(given[slot]);
    const std::vector<double> values = interpret(one, inputs);
    for (std::size_t i = 0; i < values.size(); ++i) given[one.outputs[i].slot] = values[i];
  };
  outputs(apart.values);
  outputs(apart.along);
  return given;
}

void expect_derivatives_of_a_complex_step(const RandomMechanism& random, int& compared) {
  Result<Model> model = read_model(varied_text(random), "varied.json");
  ASSERT_TRUE(model) << to_text(model.problems());
  Result<Compilation> c = compile(std::move(*model));
  if (!c) return;
  const Mechanism m{c->model, c->topology, c->analysis};
  const Program& accelerations = c->emitted.in_pairs ? c->emitted.in_pairs->program : c->emitted.programs.accelerations;
  for (const GenericState& state : good_states(m, 1)) {
    const std::vector<double> tau = random_tau(m, 3);
    for (std::size_t p = 0; p < c->model.parameters.size(); ++p) {
      Values given;
      for (std::size_t i = 0; i < state.z.size(); ++i) {
        const int index = static_cast<int>(i);
        given[{Array::z, index}] = state.z[i];
        given[{Array::zd, index}] = state.zd[i];
        given[{Array::tau, index}] = tau[i];
      }
      for (std::size_t q = 0; q < c->model.parameters.size(); ++q)
        given[{Array::par, static_cast<int>(q)}] = c->model.parameters[q].value;
      given[{derivative_of(Array::par), static_cast<int>(p)}] = 1;
      given = apart_at(accelerations, apart_at(c->emitted.programs.derived_constants, given));
      const std::string& name = c->model.parameters[p].name;
      Varied varied{1.0, random.bodies[0].mass, random.links.empty() ? 0 : random.links[0].stiffness};
      (name == "gravity" ? varied.gravity : name == "mass" ? varied.mass : varied.stiffness) += Number(0, kStep);
      const Numbers zdd = ComplexJudge(random, c->topology, varied).accelerations(state.z, state.zd, tau);
      double largest = 0, largest_value = 0;
      for (const Number& one : zdd) {
        largest = std::max(largest, std::abs(one.imag()) / kStep);
        largest_value = std::max(largest_value, std::abs(one.real()));
      }
      for (std::size_t i = 0; i < state.z.size(); ++i) {
        const Number expected = zdd[static_cast<Eigen::Index>(i)];
        const int index = static_cast<int>(i);
        EXPECT_NEAR((given[{Array::zdd, index}]), expected.real(), 1e-8 * largest_value) << random.seed << " " << name;
        EXPECT_NEAR((given[{derivative_of(Array::zdd), index}]), expected.imag() / kStep, 1e-8 * largest)
            << random.seed << " " << name << " " << c->topology.bodies[i].coordinate;
      }
      compared += largest > 0 ? 1 : 0;
    }
  }
}

/// MBGEN_PROPERTY_CASES: seeds of each family, 4 by default.
TEST(ComplexStep, EqualsDerivativesOfRandomMechanisms) {
  const int cases = from_environment("MBGEN_PROPERTY_CASES", 4);
  int mechanisms = 0, compared = 0;
  for (const Family family : {Family::tree, Family::closed_chain, Family::planar_loops, Family::rods,
                              Family::massless_links, Family::mirror_halves, Family::equal_legs, Family::equal_cells})
    for (int seed = 1; seed <= 3 * cases; ++seed) {
      const RandomMechanism random = random_mechanism(family, seed);
      if (!is_plain(random) || !understood(random)) continue;
      ++mechanisms;
      expect_derivatives_of_a_complex_step(random, compared);
    }
  std::printf("%d mechanisms, %d derivatives compared\n", mechanisms, compared);
  EXPECT_GE(mechanisms, 7 * cases);
  EXPECT_GE(compared, mechanisms);
}

}  // namespace
}  // namespace mbgen::testing::complex_step
