// Force elements of the model as wrenches on bodies and generalised forces on coordinates. The laws are the runtime's.

#include "mbgen/forces.hpp"

#include "compiler/model/auxiliary_states.hpp"
#include "mbgen/bristle.hpp"
#include "mbgen/table.hpp"
#include "runtime/cartesian/mechanism.hpp"
#include "runtime/cartesian/tyre_contact.hpp"

namespace mbgen {
namespace {

using namespace cartesian;
using Eigen::Vector3d;

double along(const Table& table, double argument) {
  const int count = static_cast<int>(table.x.size());
  if (table.interpolation == Table::Interpolation::linear)
    return interpolate_linear(table.x.data(), table.y.data(), count, argument);
  std::vector<double> slopes(table.x.size());
  monotone_slopes(table.x.data(), table.y.data(), count, slopes.data());
  return interpolate_monotone_cubic(table.x.data(), table.y.data(), slopes.data(), count, argument);
}

double law(const std::optional<Law>& law, const Values& value, double argument) {
  if (!law) return 0;
  if (const Quantity* factor = std::get_if<Quantity>(&*law)) return value(*factor) * argument;
  return along(std::get<Table>(*law), argument);
}

double with_locals(const std::optional<int>& expression, Values value, double first, double second) {
  if (!expression) return 0;
  value.locals = {first, second};
  return evaluate<double>(value.model.expressions[*expression], value);
}

double tension(const PointSpring& spring, const Values& value, double length, double rate, double reference) {
  const double free = spring.free_length ? value(*spring.free_length) : reference;
  return value(spring.preload) + law(spring.stiffness, value, length - free) + law(spring.damping, value, rate) +
         with_locals(spring.force, value, length, rate);
}

double tension(const AirSpring& spring, const Values& value, double length, double, double reference) {
  const double length0 = spring.length ? value(*spring.length) : reference;
  const auto area = [&](double at) {
    const Quantity* constant = std::get_if<Quantity>(&spring.area);
    return constant ? value(*constant) : along(std::get<Table>(spring.area), at);
  };
  const auto volume = [&](double at) {
    return spring.volume ? along(*spring.volume, at) : value(spring.volume0) + area(length0) * (at - length0);
  };
  return -air_spring_force(value(spring.pressure), value(spring.ambient), value(spring.exponent), volume(length0),
                           volume(length), area(length));
}

Load force_at(const End& end, const Vector3d& force) {
  return {end.body, (Vector6d() << force, end.arm.cross(force)).finished()};
}

/// An element between two points as it is now.
struct Line {
  End from, to;
  Vector3d direction;
  double length, rate;
};

Line line_of(const PartLine& line, const std::vector<Moving>& bodies) {
  const End from = end_of(bodies, line.from), to = end_of(bodies, line.to);
  const Vector3d gap = to.position - from.position;
  const double length = gap.norm();
  const Vector3d direction = gap / length;
  return {from, to, direction, length, direction.dot(to.velocity - from.velocity)};
}

void add_tension(const Line& line, double tension, Forces& forces) {
  forces.loads.push_back(force_at(line.from, tension * line.direction));
  forces.loads.push_back(force_at(line.to, -tension * line.direction));
}

/// Result: the tension, N.
template <class Spring>
double add_line(const Spring& spring, const PartLine& part, const std::vector<Moving>& bodies, const Values& value,
                Forces& forces) {
  const Line line = line_of(part, bodies);
  const double pull = tension(spring, value, line.length, line.rate, part.reference);
  add_tension(line, pull, forces);
  return pull;
}

/// Frictions of a model: their forces, and the rates of those that have bristles.
struct Frictions {
  const Values& value;
  const std::vector<double>& x;
  const std::vector<double>& tensions;  ///< of the springs, without friction, N
  std::vector<double> rates = {};       ///< of bristles

  /// N m or N, on the part that moves at `rate`.
  double force(const FrictionLaw& f, double rate) {
    double force = 0;
    if (f.has_bristle()) {
      const Bristles<double> bristles{value(f.coulomb),   value(f.stiction), value(f.stribeck_velocity),
                                      value(f.stiffness), value(f.damping),  *f.lag};
      const double b = x[static_cast<std::size_t>(first_bristle(value.model)) + rates.size()];
      const BristleResult<double> result = f.kind == FrictionLaw::Kind::lugre
                                               ? lugre_friction(bristles, b, rate)
                                               : elasto_plastic_friction(bristles, value(f.elastic), b, rate);
      rates.push_back(result.rate);
      force = result.force;
    } else {
      force =
          friction_force(value(f.coulomb), value(f.stiction), 0.0, value(f.velocity), value(f.stribeck_velocity), rate);
    }
    if (f.normal >= 0) force *= std::abs(tensions[static_cast<std::size_t>(f.normal)]);
    return force - value(f.viscous) * rate;
  }
};

void add_applied(const AppliedForce& applied, const Place& place, const std::vector<Moving>& bodies,
                 const Values& value, Forces& forces) {
  const auto vector = [&](const Vector3Quantity& q) {
    const Vector3d components(value(q[0]), value(q[1]), value(q[2]));
    return applied.in_body_axes ? Vector3d(bodies[place.body].axes * components) : components;
  };
  Load load = force_at(end_of(bodies, place), vector(applied.force));
  load.wrench.tail<3>() += vector(applied.torque);
  forces.loads.push_back(load);
}

void add_joint_elements(const Model& model, const Values& value, std::vector<double>& joints) {
  const auto add = [&](const CoordinateReference& at, double force) {
    const int i = value.table[at.joint][at.component];
    if (i >= 0) joints[i] += force;
  };
  for (const JointSpring& spring : model.joint_springs) {
    double position = value.position(spring.joint), rate = value.velocity(spring.joint);
    if (spring.relative_to) {
      position -= value.position(*spring.relative_to);
      rate -= value.velocity(*spring.relative_to);
    }
    const double force = value(spring.preload) + law(spring.stiffness, value, position - value(spring.free)) +
                         law(spring.damping, value, rate) + with_locals(spring.force, value, position, rate);
    add(spring.joint, -force);
    if (spring.relative_to) add(*spring.relative_to, force);
  }
  for (const JointForce& force : model.joint_forces) add(force.joint, value(force.force));
}

}  // namespace

Forces CartesianMechanism::forces(const std::vector<Moving>& bodies, const std::vector<double>& x,
                                  const Values& values) const {
  Forces forces;
  forces.joints.resize(topology.bodies.size());
  std::vector<double> tensions;
  for (std::size_t s = 0; s < model.springs.size(); ++s)
    tensions.push_back(add_line(model.springs[s], parts.springs[s], bodies, values, forces));
  for (std::size_t s = 0; s < model.air_springs.size(); ++s)
    add_line(model.air_springs[s], parts.air_springs[s], bodies, values, forces);
  for (std::size_t f = 0; f < model.forces.size(); ++f)
    add_applied(model.forces[f], parts.forces[f], bodies, values, forces);
  for (std::size_t w = 0; w < model.tyres.size(); ++w) {
    const RoadWheel wheel =
        road_wheel(model.tyres[w], parts.tyres[w], bodies[parts.tyres[w].centre.body], x[2 * w], x[2 * w + 1], values);
    forces.loads.push_back({parts.tyres[w].centre.body, wheel.wrench});
    forces.xd.push_back(wheel.du);
    forces.xd.push_back(wheel.dv);
  }
  add_joint_elements(model, values, forces.joints);
  Frictions frictions{values, x, tensions};
  for (const JointFriction& friction : model.frictions) {
    const int i = values.table[friction.joint.joint][friction.joint.component];
    const double force = frictions.force(friction, values.velocity(friction.joint));
    if (i >= 0) forces.joints[i] += force;
  }
  for (const SpringFriction& friction : model.spring_frictions) {
    const Line line = line_of(parts.springs[friction.spring], bodies);
    add_tension(line, -frictions.force(friction, line.rate), forces);
  }
  forces.xd.insert(forces.xd.end(), frictions.rates.begin(), frictions.rates.end());
  return forces;
}

}  // namespace mbgen
