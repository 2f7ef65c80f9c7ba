// All outputs and the energy balance from the poses, velocities and accelerations of the bodies in global axes, and
// from the multipliers of the Cartesian equations.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "compiler/model/element_access.hpp"
#include "runtime/judges/elements/every_kind.hpp"
#include "runtime/judges/mechanism.hpp"
#include "runtime/judges/system.hpp"

namespace mbgen {
namespace {

using namespace cartesian;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

/// A vector and its first and second derivative in global axes.
struct Path {
  Vector3d position = Vector3d::Zero(), velocity = Vector3d::Zero(), acceleration = Vector3d::Zero();
};

Path operator-(const Path& a, const Path& b) {
  return {a.position - b.position, a.velocity - b.velocity, a.acceleration - b.acceleration};
}

/// The same vector in the frame of a body with `spin` and `spin_rate`; axes unchanged.
Path seen_from(const Path& path, const Vector3d& spin, const Vector3d& spin_rate) {
  const Vector3d velocity = path.velocity - spin.cross(path.position);
  // Its rate, minus the effect of the rotating axes.
  const Vector3d rate = path.acceleration - spin_rate.cross(path.position) - spin.cross(path.velocity);
  return {path.position, velocity, rate - spin.cross(velocity)};
}

double wrapped(double angle) { return std::remainder(angle, 2 * kPi); }

/// Angles of the sequence, the second within a quarter turn of zero, or not negative if the first axis is repeated.
Vector3d angles_of(const Matrix3d& r, const std::array<int, 3>& sequence) {
  Vector3d a = r.eulerAngles(sequence[0], sequence[1], sequence[2]);
  const bool returns = sequence[2] == sequence[0];
  if (returns ? a[1] < 0 : std::abs(a[1]) > kPi / 2) a << a[0] + kPi, (returns ? 0 : kPi) - a[1], a[2] + kPi;
  return a.unaryExpr(&wrapped);
}

/// Accelerations, multipliers and their direct results.
struct Solution {
  const Eigen::VectorXd& qdd;
  std::vector<double> zdd, drives, multipliers;
  std::vector<CartesianWrench> joints;
  std::vector<Vector3d> rods_to, rods_from;
};

/// A mechanism at one instant, with the accelerations of its bodies.
class Instant {
 public:
  Instant(const CartesianMechanism& c, const std::vector<Moving>& bodies, const std::vector<double>& x,
          const Values& values, const Forces& forces, const Solution& solution)
      : c_(c), x_(x), bodies_(bodies), values_(values), forces_(forces), solution_(solution), qdd_(solution.qdd) {}

  double value(const ExpressionOutput& output) const { return values_(output.value); }

  double value(const CoordinateOutput& output) const {
    const int i = c_.table[output.coordinate.joint][output.coordinate.component];
    if (i < 0) return 0;
    const std::vector<double>* derivatives[] = {values_.z, values_.zd, &solution_.zdd};
    return (*derivatives[static_cast<int>(output.what)])[i];
  }

  double value(const ElementOutput& output) const {
    double result = 0;
    const AtWork at{c_, bodies_, x_, values_};
    with_kind(output.kind, [&](auto kind) {
      const auto& element = kind.list(c_.model)[static_cast<std::size_t>(output.element)];
      if constexpr (requires { energy_of(at, element); })
        if (is_stored_energy(output)) return void(result = energy_of(at, element));
      if constexpr (requires { shown(at, forces_, element, 0, 0); })
        result = shown(at, forces_, element, output.quantity, output.axis);
    });
    return result;
  }

  /// Work of all elastic forces, J.
  double value(const StoredEnergyOutput&) const {
    double sum = 0;
    const AtWork at{c_, bodies_, x_, values_};
    each_element(c_.model, [&](const auto& element) {
      if constexpr (requires { energy_of(at, element); }) sum += energy_of(at, element);
    });
    return sum;
  }

  double value(const DriveOutput& output) const { return solution_.drives[output.motion]; }

  double value(const ReactionOutput& output) const {
    const bool at_to = output.end == ReactionOutput::End::to;
    const bool is_force = output.what == ReactionOutput::What::force;
    Vector3d acts = Vector3d::Zero();
    int body;
    if (output.joint >= 0) {
      const CartesianWrench& on_to = solution_.joints[output.joint];
      acts = (at_to ? 1 : -1) * (is_force ? on_to.force : on_to.moment);
      body = end_body(c_.model.joints[output.joint], at_to);
    } else {
      if (is_force) acts = (at_to ? solution_.rods_to : solution_.rods_from)[output.rod];
      body = end_body(c_.model.rods[output.rod], at_to);
    }
    return output.in_body_axes ? axes_of(body).col(output.axis).dot(acts) : acts[output.axis];
  }

  double value(const MultiplierOutput& output) const {
    int first = 0;
    for (const Loop& loop : c_.topology.loops) {
      const bool is_asked = loop.joint == output.joint && loop.rod == output.rod && loop.coupling == output.coupling;
      if (is_asked) return solution_.multipliers[first + output.equation];
      first += loop.equations;
    }
    return 0;
  }

  /// Power of all applied forces, tau and drives, without gravity, W.
  double power(const std::vector<double>& tau) const {
    double power = 0;
    for (const Load& load : forces_.loads) power += power_of(load.body, load.wrench);
    for (std::size_t j = 0; j < c_.parts.joints.size(); ++j)
      for (const JointCoordinate& coordinate : c_.coordinates_of(static_cast<int>(j), bodies_, *values_.z))
        power += (tau[coordinate.index] + forces_.joints[coordinate.index]) * coordinate.zd;
    const std::vector<Row> rows = c_.equations_at(bodies_, values_);
    for (std::size_t k = 0; k < solution_.drives.size(); ++k) {
      const Row& row = rows[c_.first.motions + k];
      power += solution_.drives[k] * (power_of(row.from, row.on_from) + power_of(row.to, row.on_to));
    }
    return power;
  }

  double value(const PointOutput& output) const {
    Path path = path_of(output.point);
    if (output.relative_to.body >= 0) {
      path = seen_from(path - path_of(output.relative_to), spin(output.observer), spin_rate(output.observer));
    }
    const Vector3d derivatives[] = {path.position, path.velocity, path.acceleration};
    const int axes = output.in_body_axes ? output.point.body : output.axes;
    return (axes_of(axes).transpose() * derivatives[static_cast<int>(output.what)])[output.axis];
  }

  double value(const PointsOutput& output) const {
    const auto place = [&](int i) { return path_of(output.points[i]).position; };
    const Vector3d first = place(0) - place(1);
    if (output.points[2].body < 0) return first.norm();
    const Vector3d last = place(2) - place(1);
    const Vector3d a = first.normalized(), b = last.normalized();
    return 2 * std::atan2((a - b).norm(), (a + b).norm());
  }

  double value(const RotationOutput& output) const {
    using What = RotationOutput::What;
    const Matrix3d turned = axes_of(output.relative_to).transpose() * axes_of(output.body);
    Eigen::Quaterniond q(turned);
    if (q.w() < 0) q.coeffs() *= -1;
    if (output.what == What::angle) return angles_of(turned, output.sequence)[output.turn];
    if (output.what == What::quaternion) return q.coeffs()[output.axis];
    if (output.what == What::rotation_vector) {
      const Eigen::AngleAxisd turn(q);
      return turn.angle() * turn.axis()[output.axis];
    }
    Vector3d motion = spin(output.body) - spin(output.relative_to);
    if (output.what == What::angular_acceleration)
      motion = spin_rate(output.body) - spin_rate(output.relative_to) - spin(output.observer).cross(motion);
    return (axes_of(output.axes).transpose() * motion)[output.axis];
  }

  double value(const MomentumOutput& output) const {
    using What = MomentumOutput::What;
    const int first = output.body == kNoBody ? 0 : c_.parts.index_of[output.body];
    const int end = output.body == kNoBody ? c_.parts.ground() : first + 1;
    double mass = 0, kinetic = 0;
    Vector3d moment = Vector3d::Zero(), momentum = Vector3d::Zero(), turning = Vector3d::Zero();
    for (int b = first; b < end; ++b) {
      const Part& part = c_.parts.bodies[b];
      const Moving& body = bodies_[b];
      const Vector3d spin = body.axes * part.inertia * body.axes.transpose() * body.spin;
      mass += part.mass;
      moment += part.mass * body.position;
      momentum += part.mass * body.velocity;
      turning += part.mass * body.position.cross(body.velocity) + spin;
      kinetic += 0.5 * part.mass * body.velocity.squaredNorm() + 0.5 * body.spin.dot(spin);
    }
    if (output.what == What::kinetic_energy) return kinetic;
    if (output.what == What::potential_energy) return -c_.parts.gravity.dot(moment);
    if (output.what == What::momentum) return (axes_of(output.axes).transpose() * momentum)[output.axis];
    Vector3d about = Vector3d::Zero();
    if (output.about.body >= 0) about = path_of(output.about).position;
    if (output.about.body < 0 && mass > 0) about = moment / mass;
    return (axes_of(output.axes).transpose() * (turning - about.cross(momentum)))[output.axis];
  }

  double value(const WheelOutput& output) const {
    using What = WheelOutput::What;
    const Matrix3d vehicle = axes_of(output.vehicle);
    if (output.what >= What::caster) {
      const Vector3d up = vehicle.transpose() * (path_of(output.upper).position - path_of(output.lower).position);
      return output.what == What::caster ? std::atan2(-up.x(), up.z()) : std::atan2(-output.side * up.y(), up.z());
    }
    const Vector3d axis = vehicle.transpose() * spin_axis_of(output);
    const Vector3d forward = axis.cross(Vector3d::UnitZ()).normalized();
    if (output.what == What::camber) return -output.side * std::asin(axis.z());
    return (output.what == What::toe ? -output.side : 1) * std::atan2(forward.y(), forward.x());
  }

 private:
  template <class Connection>
  static int end_body(const Connection& connection, bool at_to) {
    return at_to ? connection.to.body : connection.from.body;
  }
  double power_of(int body, const Vector6d& wrench) const {
    return wrench.head<3>().dot(bodies_[body].velocity) + wrench.tail<3>().dot(bodies_[body].spin);
  }
  int index(int body) const { return body == kNoBody ? c_.parts.ground() : c_.parts.index_of[body]; }
  bool moves(int body) const { return index(body) != c_.parts.ground(); }

  /// Axes of a body's frame.
  Matrix3d axes_of(int body) const {
    if (body == kNoBody) return Matrix3d::Identity();
    if (moves(body)) return bodies_[index(body)].axes;
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(c_.model.bodies[body].pose.rotation.data());
  }
  /// Axis that an output's wheel turns about, global.
  Vector3d spin_axis_of(const WheelOutput& output) const {
    if (output.tyre >= 0) {
      const PartTyre& tyre = c_.parts.tyres[output.tyre];
      return bodies_[tyre.centre.body].axes * tyre.axis;
    }
    const int wheel = c_.model.joints[output.joint].to.body;
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> home(
        c_.model.bodies[wheel].pose.rotation.data());
    return axes_of(wheel) * home.transpose() * Eigen::Map<const Vector3d>(output.axis.data());
  }
  Vector3d spin(int body) const { return bodies_[index(body)].spin; }
  Vector3d spin_rate(int body) const {
    return moves(body) ? Vector3d(qdd_.segment<3>(6 * index(body) + 3)) : Vector3d::Zero();
  }
  Path path_of(const Attachment& at) const {
    const End end = end_of(bodies_, place_of(c_.parts, at, values_));
    Path path{end.position, end.velocity, end.centripetal};
    if (moves(at.body)) path.acceleration += qdd_.segment<3>(6 * index(at.body)) + spin_rate(at.body).cross(end.arm);
    return path;
  }

  const CartesianMechanism& c_;
  const std::vector<double>& x_;
  const std::vector<Moving>& bodies_;
  const Values& values_;
  const Forces& forces_;
  const Solution& solution_;
  const Eigen::VectorXd& qdd_;
};

/// Sets the observed outputs of a round in the values that an instant looks at.
void observe_round(const Instant& instant, const Model& model, int round, Values& values) {
  for (std::size_t i = 0; i < model.observed.size(); ++i) {
    const ObservedOutput& observed = model.observed[i];
    if (observed.round != round) continue;
    values.observed[i] = std::visit([&](const auto& source) { return instant.value(source); }, observed.output.source);
  }
}

/// An instant with all that it refers to; every observed output is set in its values.
struct SeenInstant {
  SeenInstant(const CartesianMechanism& c, const CartesianState& state, const GenericState& z, const Solution& solution)
      : bodies(c.bodies(state)),
        forces(c.forces(bodies, state.x, c.values(z, state.t))),
        values(c.complete(c.values(z, state.t), bodies, state.x)),
        instant(c, bodies, state.x, values, forces, solution) {
    values.observed = forces.observed;
    observe_round(instant, c.model, kAfterForces, values);
  }
  SeenInstant(const SeenInstant&) = delete;
  SeenInstant& operator=(const SeenInstant&) = delete;

  std::vector<Moving> bodies;
  Forces forces;
  Values values;
  Instant instant;
};

struct SolvedEquations {
  const Eigen::VectorXd &qdd, &lambda;
};

Solution solution_of(const CartesianSystem& system, const CartesianState& state, const GenericState& z,
                     const std::vector<double>& tau, const SolvedEquations& solved) {
  using End = ReactionOutput::End;
  return {solved.qdd,
          system.joint_accelerations(state, z, solved.qdd),
          system.driving_forces(solved.lambda),
          system.loop_multipliers(state, solved.lambda),
          system.joint_reactions(state, z, tau, solved.lambda),
          system.rod_forces(state, solved.lambda, End::to),
          system.rod_forces(state, solved.lambda, End::from)};
}

}  // namespace

void CartesianMechanism::observe(const std::vector<Moving>& bodies, const std::vector<double>& x, const Forces& forces,
                                 int round, Values& values) const {
  if (model.observed.empty()) return;
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(6 * static_cast<Eigen::Index>(parts.bodies.size()));
  const Solution unknown{at_rest, std::vector<double>(topology.bodies.size()), {}, {}, {}, {}, {}};
  const Instant instant(*this, bodies, x, values, forces, unknown);
  observe_round(instant, model, round, values);
}

std::vector<double> CartesianSystem::observed(const CartesianState& state, const GenericState& z,
                                              const Eigen::VectorXd& qdd, const Eigen::VectorXd& lambda) const {
  const CartesianMechanism& c = *mechanism_;
  const Solution solution = solution_of(*this, state, z, std::vector<double>(z.z.size(), 0.0), {qdd, lambda});
  return SeenInstant(c, state, z, solution).values.observed;
}

GenericOutputs CartesianSystem::outputs(const CartesianState& state, const GenericState& z,
                                        const std::vector<double>& tau, const Eigen::VectorXd& qdd,
                                        const Eigen::VectorXd& lambda) const {
  const Solution solution = solution_of(*this, state, z, tau, {qdd, lambda});
  const SeenInstant seen(*mechanism_, state, z, solution);
  const Instant& instant = seen.instant;
  const auto value = [&](const auto& output) { return instant.value(output); };
  GenericOutputs values;
  for (const Output& output : mechanism_->model.outputs) values.y.push_back(std::visit(value, output.source));
  values.kinetic_energy = instant.value(MomentumOutput{.what = MomentumOutput::What::kinetic_energy});
  const auto potential = [&](int body) {
    return instant.value(MomentumOutput{.what = MomentumOutput::What::potential_energy, .body = body});
  };
  values.potential_energy = potential(kNoBody);
  // Bodies fixed to ground do not contribute to the balance.
  for (std::size_t b = 0; b < mechanism_->model.bodies.size(); ++b)
    if (mechanism_->topology.tree_body[b] == kGround && static_cast<int>(b) != mechanism_->model.ground)
      values.potential_energy -= potential(static_cast<int>(b));
  values.applied_power = instant.power(tau);
  return values;
}

}  // namespace mbgen
