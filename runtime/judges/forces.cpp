// Force elements of the model as wrenches on bodies and generalised forces on coordinates. The laws are the runtime's.

#include "mbgen/solver/forces.hpp"

#include <algorithm>
#include <functional>

#include "compiler/model/auxiliary_states.hpp"
#include "mbgen/sampling.hpp"
#include "mbgen/solver/bristle.hpp"
#include "runtime/judges/bump_stops.hpp"
#include "runtime/judges/bushings.hpp"
#include "runtime/judges/laws.hpp"
#include "runtime/judges/mechanism.hpp"

namespace mbgen {
namespace {

using namespace cartesian;
using Eigen::Vector3d;

double tension(const PointSpring& spring, const Values& value, double length, double rate, double reference) {
  const double free = spring.free_length ? value(*spring.free_length) : reference;
  return value(spring.preload) + law(spring.stiffness, value, length - free) + law(spring.damping, value, rate) +
         with_locals(spring.force, value, length, rate);
}

double tension(const AirSpring& spring, const Values& value, double length, double, double reference) {
  const double length0 = spring.length ? value(*spring.length) : reference;
  const auto area = [&](double at) {
    const Quantity* constant = std::get_if<Quantity>(&spring.area);
    return constant ? value(*constant) : value_of(std::get<Table>(spring.area), at);
  };
  const auto volume = [&](double at) {
    return spring.volume ? value_of(*spring.volume, at) : value(spring.volume0) + area(length0) * (at - length0);
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

template <class Spring>
LineAtWork add_line(const Spring& spring, const PartLine& part, const std::vector<Moving>& bodies, const Values& value,
                    Forces& forces) {
  const Line line = line_of(part, bodies);
  const double pull = tension(spring, value, line.length, line.rate, part.reference);
  add_tension(line, pull, forces);
  return {line.length, line.rate, pull};
}

/// Frictions of a model: their forces, and the rates of those that have bristles.
struct Frictions {
  const Values& value;
  const std::vector<double>& x;
  const std::vector<LineAtWork> springs;  ///< without friction
  std::vector<double> rates = {};         ///< of bristles

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
    if (f.normal >= 0) force *= std::abs(springs[static_cast<std::size_t>(f.normal)].force);
    if (f.load >= 0) force *= std::abs(value.states[value.model.states.size() + static_cast<std::size_t>(f.load)]);
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

/// Moment against the turn of a body relative to the rod in whose end it sits, across the rod's line. The rod
/// is turned by forces at its ends, beside those that its own equations carry. moment: N m, over the size of the turn,
/// rad/s, against it.
void add_rod_friction(const PartRod& rod, bool at_from, const std::vector<Moving>& bodies,
                      const std::function<double(double)>& moment, Forces& forces) {
  const Line line = line_of({rod.from, rod.to, 0}, bodies);
  const End& end = at_from ? line.from : line.to;
  const Vector3d& axis = line.direction;
  const Vector3d rod_spin = rod.body >= 0 ? bodies[static_cast<std::size_t>(rod.body)].spin
                                          : Vector3d(axis.cross(line.to.velocity - line.from.velocity) / line.length);
  const Vector3d relative = end.spin - rod_spin, turn = relative - axis.dot(relative) * axis;
  const double rate = turn.norm();
  if (rate == 0) return;
  const Vector3d on_body = moment(rate) / rate * turn;
  forces.loads.push_back({end.body, (Vector6d() << Vector3d::Zero(), on_body).finished()});
  // The rod turns with the pair: (to - from) x pair = -on_body.
  const Vector3d pair = on_body.cross(-axis) / line.length;
  forces.loads.push_back(force_at(line.to, pair));
  forces.loads.push_back(force_at(line.from, -pair));
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

Values CartesianMechanism::complete(Values values, const std::vector<Moving>& bodies,
                                    const std::vector<double>& x) const {
  values.states.assign(x.begin() + first_user_state(model), x.end());
  const auto add = [&](const Place& from, const Place& to) {
    const Line at = line_of({from, to, 0}, bodies);
    values.lengths.push_back(at.length);
    values.rates.push_back(at.rate);
  };
  for (const std::vector<PartLine>* lines : {&parts.springs, &parts.air_springs})
    for (const PartLine& line : *lines) add(line.from, line.to);
  for (const PartRod& rod : parts.rods) add(rod.from, rod.to);
  return values;
}

Forces CartesianMechanism::forces(const std::vector<Moving>& bodies, const std::vector<double>& x,
                                  const Values& given) const {
  const Values values = complete(given, bodies, x);
  Forces forces;
  forces.joints.resize(topology.bodies.size());
  for (std::size_t s = 0; s < model.springs.size(); ++s)
    forces.springs.push_back(add_line(model.springs[s], parts.springs[s], bodies, values, forces));
  for (std::size_t s = 0; s < model.air_springs.size(); ++s)
    forces.air_springs.push_back(add_line(model.air_springs[s], parts.air_springs[s], bodies, values, forces));
  for (std::size_t f = 0; f < model.forces.size(); ++f)
    add_applied(model.forces[f], parts.forces[f], bodies, values, forces);
  std::vector<double> turn_rates;
  for (std::size_t w = 0; w < model.tyres.size(); ++w) {
    const double turn = model.tyres[w].parking ? x[static_cast<std::size_t>(turn_state(model, w))] : 0;
    const RoadWheel wheel = road_wheel(model.tyres[w], parts.tyres[w], bodies[parts.tyres[w].centre.body],
                                       {x[2 * w], x[2 * w + 1], turn}, values);
    if (model.tyres[w].parking) turn_rates.push_back(wheel.result.dturn);
    forces.loads.push_back({parts.tyres[w].centre.body, wheel.wrench});
    forces.xd.push_back(wheel.result.du);
    forces.xd.push_back(wheel.result.dv);
    forces.tyres.push_back(wheel.result);
  }
  forces.xd.insert(forces.xd.end(), turn_rates.begin(), turn_rates.end());
  Frictions frictions{values, x, forces.springs};
  for (const JointFriction& friction : model.frictions) {
    const int i = values.table[friction.joint.joint][friction.joint.component];
    const double force = frictions.force(friction, values.velocity(friction.joint));
    if (i >= 0) forces.joints[i] += force;
  }
  for (const SpringFriction& friction : model.spring_frictions) {
    const Line line = line_of(parts.springs[friction.spring], bodies);
    const double pull = -frictions.force(friction, line.rate);
    add_tension(line, pull, forces);
    forces.springs[static_cast<std::size_t>(friction.spring)].force += pull;
  }
  for (const RodFriction& friction : model.rod_frictions) {
    const PartRod& rod = parts.rods[static_cast<std::size_t>(friction.rod)];
    const auto moment = [&](double rate) { return frictions.force(friction, rate); };
    add_rod_friction(rod, friction.at_from, bodies, moment, forces);
  }
  forces.xd.insert(forces.xd.end(), frictions.rates.begin(), frictions.rates.end());
  add_bushings(model, parts, bodies, x, values, forces);
  add_bump_stops(model, parts, bodies, values, forces);
  add_joint_elements(model, values, forces.joints);
  for (const UserState& state : model.states) forces.xd.push_back(values(state.derivative));
  forces.xd.resize(x.size());  // sampled values hold
  return forces;
}

Status CartesianMechanism::sample(const std::vector<Moving>& bodies, const Values& given,
                                  const std::vector<double>& loads, double h, bool& any, std::vector<double>& x) const {
  any = false;
  Values values = complete(given, bodies, x);
  const int first = first_user_state(model) + static_cast<int>(model.states.size());
  std::size_t place = model.states.size(), queue = place + model.sampled.size();
  for (const SampledValue& sampled : model.sampled) {
    double due = 0;
    bool is_due = false;
    const int index = first + static_cast<int>(place - model.states.size());
    const Status status = find_due(&sampled.period, 1, index, given.t, h, &due, is_due);
    if (!status.ok()) return status;
    any = any || is_due;
    const auto waiting = values.states.begin() + static_cast<std::ptrdiff_t>(queue);
    if (is_due) {
      // A queue: the newest goes in front, the oldest comes out as the value.
      std::vector<double> line(waiting, waiting + sampled.delay);
      line.insert(line.begin(), sampled.load ? loads[place - model.states.size()] : values(sampled.value));
      values.states[place] = line.back();
      std::copy(line.begin(), line.end() - 1, waiting);
    }
    queue += static_cast<std::size_t>(sampled.delay);
    ++place;
  }
  const std::size_t states = model.states.size();
  return take_held(values.states.data() + states, held_state_count(model), first, x.data());
}

}  // namespace mbgen
