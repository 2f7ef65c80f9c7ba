#include "workbench/manoeuvre/mode_names.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "compiler/model/vectors.hpp"
#include "runtime/generic/generic.hpp"
#include "workbench/manoeuvre/vehicle_motion.hpp"

namespace mbgen {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3cd;
using Eigen::Vector3d;

constexpr double kDeviation = 1e-5;  // rad or m, of the difference quotients of poses
constexpr double kNamedShare = 0.1, kTold = 0.7;
constexpr std::size_t kMostNamed = 3;

Matrix3d matrix_of(const Matrix3& m) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(m.data());
}
Vector3d vector_of(const Vector3& v) { return {v[0], v[1], v[2]}; }

/// Small motion of a body: displacement of its centre of mass and rotation, global axes.
template <class Scalar>
struct Swing {
  Eigen::Matrix<Scalar, 3, 1> shift = Eigen::Matrix<Scalar, 3, 1>::Zero(), turn = Eigen::Matrix<Scalar, 3, 1>::Zero();
};

/// A rigid unit of the vehicle.
struct Unit {
  int body = -1;
  std::string prefix = {};  ///< of its motions: "" or "trailer "
  double mass = 0;          ///< kg, of all its bodies
  Vector3d centre = {};     ///< m, of mass
  Matrix3d inertia = {};    ///< kg m^2 about it, global axes
};

class ModeParts {
 public:
  ModeParts(const Compilation& compilation, const OperatingPoint& point) : c_(compilation) {
    find_units();
    if (units_.empty()) return;
    find_poses(point);
    find_axles();
    for (Unit& unit : units_) weigh(unit);
  }

  std::vector<Participation> of(const Mode& mode) const {
    if (units_.empty() || mode.auxiliary >= 0) return {};
    std::map<std::string, double> energies;
    for (const Unit& unit : units_) add_unit(unit, mode, energies);
    double sum = 0;
    for (const auto& [name, energy] : energies) sum += energy;
    std::vector<Participation> parts;
    for (const auto& [name, energy] : energies)
      if (energy > 0) parts.push_back({name, energy / sum});
    std::ranges::stable_sort(parts, std::greater{}, &Participation::share);
    return parts;
  }

 private:
  const Body& body(int b) const { return c_.model.bodies[static_cast<std::size_t>(b)]; }
  int tree_of(int b) const { return c_.topology.tree_body[static_cast<std::size_t>(b)]; }
  int parent_of(int tree) const { return c_.topology.bodies[static_cast<std::size_t>(tree)].parent; }

  void find_units() {
    const Model& model = c_.model;
    if (model.tyres.empty()) return;
    const auto heaviest = std::ranges::max_element(model.bodies, {}, [](const Body& b) { return b.mass.value; });
    const int main = model.vehicle ? model.vehicle->reference.body : static_cast<int>(heaviest - model.bodies.begin());
    if (model.vehicle && model.vehicle->towed.body >= 0)
      units_.push_back({.body = model.vehicle->towed.body, .prefix = body(model.vehicle->towed.body).name + " "});
    units_.push_back({.body = main});
  }

  /// The unit of a body: the towed one from its body on outwards in the tree.
  const Unit& unit_of(int b) const {
    for (int tree = tree_of(b); tree != kGround; tree = parent_of(tree))
      if (tree == tree_of(units_.front().body)) return units_.front();
    return units_.back();
  }

  /// Poses and their derivatives by each coordinate.
  void find_poses(const OperatingPoint& point) {
    GenericSolver solver(c_.model, c_.topology, c_.analysis);
    solver.set_inputs(point.inputs);
    GenericState state{point.z, std::vector<double>(point.z.size(), 0.0), point.x, point.t};
    poses_ = solver.poses(state);
    slopes_.assign(c_.model.bodies.size(), std::vector<Swing<double>>(point.z.size()));
    for (std::size_t j = 0; j < point.z.size(); ++j) {
      state.z[j] = point.z[j] + kDeviation;
      const std::vector<Pose> ahead = solver.poses(state);
      state.z[j] = point.z[j] - kDeviation;
      const std::vector<Pose> behind = solver.poses(state);
      state.z[j] = point.z[j];
      for (std::size_t b = 0; b < poses_.size(); ++b) slopes_[b][j] = slope(static_cast<int>(b), ahead[b], behind[b]);
    }
  }

  Vector3d centre_in(const Pose& pose, int b) const {
    const Vector3Quantity& com = body(b).com;
    return vector_of(to_global(pose, {com[0].value, com[1].value, com[2].value}));
  }

  Swing<double> slope(int b, const Pose& ahead, const Pose& behind) const {
    const Matrix3d turn = matrix_of(ahead.rotation) * matrix_of(behind.rotation).transpose();
    const Vector3d axis = Vector3d(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1)) / 2;
    return {(centre_in(ahead, b) - centre_in(behind, b)) / (2 * kDeviation), axis / (2 * kDeviation)};
  }

  /// Which bodies belong to axles: wheels and what carries them, up to their unit.
  void find_axles() {
    const std::vector<int> axles = axles_of_tyres(c_.model);
    const int count = 1 + *std::ranges::max_element(axles);
    for (int a = 0; a < count; ++a)
      axle_names_.push_back(count > 2    ? fmt::format("axle {}", a + 1)
                            : count == 1 ? "axle"
                            : a == 0     ? "front"
                                         : "rear");
    wheels_.assign(static_cast<std::size_t>(count), {-1, -1});
    axle_of_.assign(c_.model.bodies.size(), -1);
    std::map<int, int> axle_of_tree;
    for (std::size_t i = 0; i < axles.size(); ++i) {
      const int wheel = c_.model.tyres[i].centre.body;
      const bool is_left =
          centre_in(poses_[static_cast<std::size_t>(wheel)], wheel).dot(left()) >=
          centre_in(poses_[static_cast<std::size_t>(units_.back().body)], units_.back().body).dot(left());
      wheels_[static_cast<std::size_t>(axles[i])][is_left ? 0 : 1] = wheel;
      const int end = tree_of(unit_of(wheel).body);
      for (int tree = tree_of(wheel); tree != kGround && tree != end; tree = parent_of(tree))
        axle_of_tree[tree] = axles[i];
    }
    for (std::size_t b = 0; b < axle_of_.size(); ++b) {
      const auto found = axle_of_tree.find(tree_of(static_cast<int>(b)));
      if (found != axle_of_tree.end()) axle_of_[b] = found->second;
    }
  }

  Vector3d left() const { return matrix_of(poses_[static_cast<std::size_t>(units_.back().body)].rotation).col(1); }

  Matrix3d inertia_of(int b) const {
    const auto& i = body(b).inertia;
    Matrix3d inertia;
    inertia << i[0].value, i[3].value, i[4].value, i[3].value, i[1].value, i[5].value, i[4].value, i[5].value,
        i[2].value;
    const Matrix3d axes = matrix_of(poses_[static_cast<std::size_t>(b)].rotation);
    return axes * inertia * axes.transpose();
  }

  void weigh(Unit& unit) const {
    unit.centre.setZero();
    unit.inertia.setZero();
    for (const int b : bodies_of(unit)) {
      unit.mass += body(b).mass.value;
      unit.centre += body(b).mass.value * centre_in(poses_[static_cast<std::size_t>(b)], b);
    }
    unit.centre /= unit.mass;
    for (const int b : bodies_of(unit)) {
      const Vector3d arm = centre_in(poses_[static_cast<std::size_t>(b)], b) - unit.centre;
      unit.inertia +=
          inertia_of(b) + body(b).mass.value * (arm.squaredNorm() * Matrix3d::Identity() - arm * arm.transpose());
    }
  }

  std::vector<int> bodies_of(const Unit& unit) const {
    std::vector<int> list;
    for (std::size_t b = 0; b < c_.model.bodies.size(); ++b)
      if (tree_of(static_cast<int>(b)) != kGround && &unit_of(static_cast<int>(b)) == &unit)
        list.push_back(static_cast<int>(b));
    return list;
  }

  Swing<std::complex<double>> swing(int b, const Mode& mode) const {
    Swing<std::complex<double>> sum;
    const std::vector<Swing<double>>& slopes = slopes_[static_cast<std::size_t>(b)];
    for (std::size_t j = 0; j < slopes.size(); ++j) {
      sum.shift += mode.coordinates[j] * slopes[j].shift;
      sum.turn += mode.coordinates[j] * slopes[j].turn;
    }
    return sum;
  }

  /// Adds the rigid motion of the unit, then the motions of its bodies beside it.
  void add_unit(const Unit& unit, const Mode& mode, std::map<std::string, double>& energies) const {
    const Matrix3d axes = matrix_of(poses_[static_cast<std::size_t>(unit.body)].rotation);
    const Swing<std::complex<double>> own = swing(unit.body, mode);
    const Vector3d place = centre_in(poses_[static_cast<std::size_t>(unit.body)], unit.body);
    const auto carried = [&](const Vector3d& at) -> Vector3cd {
      return own.shift + own.turn.cross((at - place).cast<std::complex<double>>());
    };
    static constexpr std::array<const char*, 6> kRigid{"surge", "sway", "heave", "roll", "pitch", "yaw"};
    const Vector3cd shift = axes.transpose() * carried(unit.centre), turn = axes.transpose() * own.turn;
    const Matrix3d inertia = axes.transpose() * unit.inertia * axes;
    for (int k = 0; k < 3; ++k) {
      energies[unit.prefix + kRigid[static_cast<std::size_t>(k)]] += unit.mass * std::norm(shift[k]);
      energies[unit.prefix + kRigid[static_cast<std::size_t>(3 + k)]] += inertia(k, k) * std::norm(turn[k]);
    }
    for (const int b : bodies_of(unit)) {
      if (b == unit.body) continue;
      const Swing<std::complex<double>> all = swing(b, mode);
      const Vector3cd beside =
          axes.transpose() * (all.shift - carried(centre_in(poses_[static_cast<std::size_t>(b)], b)));
      const Vector3cd turned = axes.transpose() * (all.turn - own.turn);
      add_body(b, beside, turned, axes.transpose() * inertia_of(b) * axes, hop_share(b, unit, axes, mode), energies);
    }
  }

  /// Share of hop in the vertical motion of an axle's wheels beside their unit; the rest is tramp.
  double hop_share(int b, const Unit& unit, const Matrix3d& axes, const Mode& mode) const {
    const int axle = axle_of_[static_cast<std::size_t>(b)];
    if (axle < 0) return 0;
    const Swing<std::complex<double>> own = swing(unit.body, mode);
    const Vector3d place = centre_in(poses_[static_cast<std::size_t>(unit.body)], unit.body);
    std::complex<double> heights[2] = {0, 0};
    for (std::size_t side = 0; side < 2; ++side) {
      const int wheel = wheels_[static_cast<std::size_t>(axle)][side];
      if (wheel < 0) continue;
      const Vector3d arm = centre_in(poses_[static_cast<std::size_t>(wheel)], wheel) - place;
      heights[side] =
          axes.col(2).dot(swing(wheel, mode).shift - own.shift - own.turn.cross(arm.cast<std::complex<double>>()));
    }
    const double both = std::norm(heights[0]) + std::norm(heights[1]);
    return both > 0 ? std::norm(heights[0] + heights[1]) / (2 * both) : 1;
  }

  void add_body(int b, const Vector3cd& shift, const Vector3cd& turn, const Matrix3d& inertia, double hop,
                std::map<std::string, double>& energies) const {
    const double mass = body(b).mass.value;
    const int axle = axle_of_[static_cast<std::size_t>(b)];
    if (axle < 0) {
      static constexpr std::array<const char*, 6> kOwn{" surge", " sway", " heave", " roll", " pitch", " yaw"};
      for (int k = 0; k < 3; ++k) {
        energies[body(b).name + kOwn[static_cast<std::size_t>(k)]] += mass * std::norm(shift[k]);
        energies[body(b).name + kOwn[static_cast<std::size_t>(3 + k)]] += inertia(k, k) * std::norm(turn[k]);
      }
      return;
    }
    const std::string& name = axle_names_[static_cast<std::size_t>(axle)];
    const double upward = mass * std::norm(shift[2]) + inertia(0, 0) * std::norm(turn[0]);
    energies[name + " hop"] += hop * upward;
    energies[name + " tramp"] += (1 - hop) * upward;
    energies[name + " fore-aft"] += mass * std::norm(shift[0]);
    energies[name + " lateral"] += mass * std::norm(shift[1]);
    energies[name + " wheel spin"] += inertia(1, 1) * std::norm(turn[1]);
    energies[name + " shimmy"] += inertia(2, 2) * std::norm(turn[2]);
  }

  const Compilation& c_;
  std::vector<Unit> units_;                         ///< the towed one first, the main one last
  std::vector<Pose> poses_;                         ///< of bodies
  std::vector<std::vector<Swing<double>>> slopes_;  ///< body, coordinate
  std::vector<int> axle_of_;                        ///< per body, -1: none
  std::vector<std::string> axle_names_;
  std::vector<std::array<int, 2>> wheels_;  ///< per axle: left and right body; -1: none
};

}  // namespace

std::vector<std::vector<Participation>> participations(const Compilation& compilation, const OperatingPoint& point,
                                                       const std::vector<Mode>& modes) {
  const ModeParts parts(compilation, point);
  std::vector<std::vector<Participation>> all;
  for (const Mode& mode : modes) all.push_back(parts.of(mode));
  return all;
}

std::string participation_text(const std::vector<Participation>& parts) {
  std::string text;
  double told = 0;
  for (std::size_t i = 0; i < std::min(parts.size(), kMostNamed); ++i) {
    if (i > 0 && (told >= kTold || parts[i].share < kNamedShare)) break;
    told += parts[i].share;
    text += fmt::format("{}{} {:.0f} %", i == 0 ? "" : ", ", parts[i].name, 100 * parts[i].share);
  }
  return text;
}

}  // namespace mbgen
