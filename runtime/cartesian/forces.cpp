// Force elements of the model as wrenches on bodies and generalised forces on coordinates. The laws are the runtime's.

#include "mbgen/forces.hpp"

#include "runtime/cartesian/bump_stops.hpp"
#include "compiler/model/curve.hpp"
#include "runtime/cartesian/bushings.hpp"
#include "runtime/cartesian/laws.hpp"
#include "runtime/cartesian/mechanism.hpp"
#include "runtime/cartesian/tyre_contact.hpp"

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
    return constant ? value(*constant) : value_along(std::get<Table>(spring.area), at);
  };
  const auto volume = [&](double at) {
    return spring.volume ? value_along(*spring.volume, at) : value(spring.volume0) + area(length0) * (at - length0);
  };
  return -air_spring_force(value(spring.pressure), value(spring.ambient), value(spring.exponent), volume(length0),
                           volume(length), area(length));
}

Load force_at(const End& end, const Vector3d& force) {
  return {end.body, (Vector6d() << force, end.arm.cross(force)).finished()};
}

template <class Spring>
void add_line(const Spring& spring, const PartLine& line, const std::vector<Moving>& bodies, const Values& value,
              Forces& forces) {
  const End from = end_of(bodies, line.from), to = end_of(bodies, line.to);
  const Vector3d gap = to.position - from.position;
  const double length = gap.norm();
  const Vector3d direction = gap / length;
  const double rate = direction.dot(to.velocity - from.velocity);
  const Vector3d pull = tension(spring, value, length, rate, line.reference) * direction;
  forces.loads.push_back(force_at(from, pull));
  forces.loads.push_back(force_at(to, -pull));
}

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
  for (const JointFriction& f : model.frictions)
    add(f.joint, friction_force(value(f.coulomb), value(f.stiction), value(f.viscous), value(f.velocity),
                                value(f.stribeck_velocity), value.velocity(f.joint)));
  for (const JointForce& force : model.joint_forces) add(force.joint, value(force.force));
}

}  // namespace

Forces CartesianMechanism::forces(const std::vector<Moving>& bodies, const std::vector<double>& x,
                                  const Values& values) const {
  Forces forces;
  forces.joints.resize(topology.bodies.size());
  for (std::size_t s = 0; s < model.springs.size(); ++s)
    add_line(model.springs[s], parts.springs[s], bodies, values, forces);
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
  add_bushings(model, parts, bodies, x, values, forces);
  add_bump_stops(model, parts, bodies, values, forces);
  add_joint_elements(model, values, forces.joints);
  return forces;
}

}  // namespace mbgen
