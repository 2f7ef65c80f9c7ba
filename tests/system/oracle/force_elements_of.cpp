#include "tests/system/oracle/force_elements_of.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "compiler/expressions/curve.hpp"
#include "compiler/expressions/evaluate.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen::foreign {
namespace {

using Eigen::Vector3d;

/// A model with its tree, kept by every law.
struct Source {
  Model model;
  Topology topology;
};
using SharedSource = std::shared_ptr<const Source>;

/// Value of an input that starts at its default, after `elapsed` seconds under its chain of derivatives.
template <class T>
T input_after(const Model& model, int input, T elapsed) {
  T value = model.inputs[input].default_value, factor = 1;
  int order = 0;
  for (int rate = model.inputs[input].derivative; rate >= 0; rate = model.inputs[rate].derivative) {
    factor *= elapsed / ++order;
    value += factor * model.inputs[rate].default_value;
  }
  return value;
}

/// Quantities that expressions read.
template <class T>
struct Environment {
  const Source& source;
  T t;
  const ForeignState* state = nullptr;  ///< without it motions, which see no coordinates
  std::array<double, 2> locals{};

  T parameter(int i) const { return source.model.parameters[i].value; }
  T input(int i) const { return input_after<T>(source.model, i, t); }
  T time() const { return t; }
  T position(const CoordinateReference& c) const { return state->z[tree_coordinate(source.topology, c)]; }
  T velocity(const CoordinateReference& c) const { return state->zd[tree_coordinate(source.topology, c)]; }
  T local(int i) const { return locals[i]; }
};

double value_of(const Source& source, const ForeignState& state, const Quantity& quantity) {
  return evaluate<double>(quantity, source.model.expressions, Environment<double>{source, state.t, &state});
}

double value_of(const Source& source, const ForeignState& state, const std::optional<int>& expression, double first,
                double second) {
  if (!expression) return 0;
  const Environment<double> environment{source, state.t, &state, {first, second}};
  return evaluate<double>(source.model.expressions[*expression], environment);
}

double value_of(const Source& source, const ForeignState& state, const std::optional<Law>& law, double argument) {
  if (!law) return 0;
  if (const Quantity* factor = std::get_if<Quantity>(&*law)) return value_of(source, state, *factor) * argument;
  return value_along(std::get<Table>(*law), argument);
}

double tension(const Source& source, const PointSpring& s, double reference, double length, double rate,
               const ForeignState& state) {
  const double free = s.free_length ? value_of(source, state, *s.free_length) : reference;
  return value_of(source, state, s.preload) + value_of(source, state, s.stiffness, length - free) +
         value_of(source, state, s.damping, rate) + value_of(source, state, s.force, length, rate);
}

/// (p - ambient) area with p V^n constant, pushing.
double tension(const Source& source, const AirSpring& s, double reference, double length, double,
               const ForeignState& state) {
  const auto value = [&](const Quantity& quantity) { return value_of(source, state, quantity); };
  const double length0 = s.length ? value(*s.length) : reference;
  const auto area = [&](double at) {
    const Quantity* constant = std::get_if<Quantity>(&s.area);
    return constant ? value(*constant) : value_along(std::get<Table>(s.area), at);
  };
  const auto volume = [&](double at) {
    return s.volume ? value_along(*s.volume, at) : value(s.volume0) + area(length0) * (at - length0);
  };
  const double pressure = value(s.pressure) * std::pow(volume(length0) / volume(length), value(s.exponent));
  return -(pressure - value(s.ambient)) * area(length);
}

template <class Spring>
LineElement line_of(const SharedSource& source, const Spring& spring) {
  const ReferencePoint from = reference_point(source->model, source->topology, spring.from.body, spring.from.point);
  const ReferencePoint to = reference_point(source->model, source->topology, spring.to.body, spring.to.point);
  const double reference = (to.place - from.place).norm();
  return {spring.name,
          from.body,
          to.body,
          from.place,
          to.place,
          [source, &spring, reference](double length, double rate, const ForeignState& state) {
            return tension(*source, spring, reference, length, rate, state);
          }};
}

/// A bushing without Maxwell branches, whose states no foreign solver has.
FrameElement frames_of(const SharedSource& source, const Bushing& bushing) {
  const ReferencePoint from = reference_point(source->model, source->topology, bushing.from.body, bushing.from.point);
  const ReferencePoint to = reference_point(source->model, source->topology, bushing.to.body, bushing.to.point);
  using Values = std::array<double, kBushingFreedoms>;
  const auto forces = [source, &bushing](Values q, Values rate, const ForeignState& state) {
    Values force{};
    for (int i = 0; i < kBushingFreedoms; ++i) q[i] *= bushing_sense(bushing, i), rate[i] *= bushing_sense(bushing, i);
    for (int i = 0; i < kBushingFreedoms; ++i) {
      for (int j = 0; j < kBushingFreedoms; ++j) {
        const int entry = kBushingFreedoms * i + j;
        if (bushing.stiffness) force[i] += value_of(*source, state, (*bushing.stiffness)[entry]) * q[j];
        if (bushing.damping) force[i] += value_of(*source, state, (*bushing.damping)[entry]) * rate[j];
      }
      const std::optional<BushingFreedom>& own = bushing.freedoms[i];
      if (own)
        force[i] += value_of(*source, state, own->preload) + value_of(*source, state, own->stiffness, q[i]) +
                    value_of(*source, state, own->damping, rate[i]) +
                    value_of(*source, state, own->force, q[i], rate[i]);
    }
    for (int i = 0; i < kBushingFreedoms; ++i) force[i] *= bushing_sense(bushing, i);
    return force;
  };
  const Eigen::Matrix3d axes = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(bushing.axes.data());
  return {bushing.name, from.body, to.body, from.place, to.place, axes, forces};
}

/// Force of a bump stop against its travel.
double stop_force(const Source& source, const BumpStop& stop, double travel, double rate, const ForeignState& state) {
  const double p = travel - value_of(source, state, stop.clearance);
  if (p <= 0) return 0;
  const bool is_table = stop.stiffness && std::holds_alternative<Table>(*stop.stiffness);
  const double elastic = value_of(source, state, stop.stiffness, is_table ? p : std::pow(p, stop.exponent)) +
                         value_of(source, state, stop.force, p, rate);
  return std::max(0.0, elastic * (1 + value_of(source, state, stop.damping) * rate));
}

void add_stop(const SharedSource& source, const BumpStop& stop, ForceElements& elements) {
  const double sign = stop.side == BumpStop::Side::compression || stop.side == BumpStop::Side::below ? -1 : 1;
  if (stop.is_on_joint()) {
    const int joint = tree_coordinate(source->topology, stop.joint);
    elements.coordinates.push_back({stop.name, joint, [source, &stop, sign, joint](const ForeignState& state) {
                                      return -sign * stop_force(*source, stop, sign * state.z[joint],
                                                                sign * state.zd[joint], state);
                                    }});
    return;
  }
  const ReferencePoint from = reference_point(source->model, source->topology, stop.from.body, stop.from.point);
  const ReferencePoint to = reference_point(source->model, source->topology, stop.to.body, stop.to.point);
  if (!stop.axis) {
    const double reference = (to.place - from.place).norm();
    elements.lines.push_back({stop.name, from.body, to.body, from.place, to.place,
                              [source, &stop, sign, reference](double length, double rate, const ForeignState& state) {
                                return sign *
                                       stop_force(*source, stop, sign * (length - reference), sign * rate, state);
                              }});
    return;
  }
  const Vector3d axis((*stop.axis)[0], (*stop.axis)[1], (*stop.axis)[2]);
  const Perpendiculars across = perpendiculars(axis);
  Eigen::Matrix3d axes;
  axes << across.first, across.second, axis;
  const double reference = axis.dot(to.place - from.place);
  using Values = std::array<double, 6>;
  elements.frames.push_back(
      {stop.name, from.body, to.body, from.place, to.place, axes,
       [source, &stop, sign, reference](const Values& q, const Values& rate, const ForeignState& state) -> Values {
         const double way = sign * (q[2] - reference);
         return {0, 0, sign * stop_force(*source, stop, way, sign * rate[2], state), 0, 0, 0};
       }});
}

BodyLoad load_of(const SharedSource& source, const AppliedForce& applied) {
  const ReferencePoint at = reference_point(source->model, source->topology, applied.at.body, applied.at.point);
  const auto vector = [source, &applied, axes = at.axes](const Vector3Quantity& q) {
    return [source, &applied, axes, &q](const ForeignState& state) {
      const Vector3d components(value_of(*source, state, q[0]), value_of(*source, state, q[1]),
                                value_of(*source, state, q[2]));
      return applied.in_body_axes ? Vector3d(axes * components) : components;
    };
  };
  return {applied.name, at.body, at.place, applied.in_body_axes, vector(applied.force), vector(applied.torque)};
}

void add_joint_spring(const SharedSource& source, const JointSpring& spring, ForceElements& elements) {
  const int joint = tree_coordinate(source->topology, spring.joint);
  const int other = spring.relative_to ? tree_coordinate(source->topology, *spring.relative_to) : -1;
  const auto force = [source, &spring, joint, other](const ForeignState& state) {
    const double x = state.z[joint] - (other < 0 ? 0 : state.z[other]);
    const double rate = state.zd[joint] - (other < 0 ? 0 : state.zd[other]);
    return value_of(*source, state, spring.preload) +
           value_of(*source, state, spring.stiffness, x - value_of(*source, state, spring.free)) +
           value_of(*source, state, spring.damping, rate) + value_of(*source, state, spring.force, x, rate);
  };
  elements.coordinates.push_back({spring.name, joint, [force](const ForeignState& state) { return -force(state); }});
  if (other >= 0) elements.coordinates.push_back({spring.name, other, force});
}

CoordinateLoad friction_of(const SharedSource& source, const JointFriction& f) {
  const int joint = tree_coordinate(source->topology, f.joint);
  return {f.name, joint, [source, &f, joint](const ForeignState& state) {
            const auto value = [&](const Quantity& quantity) { return value_of(*source, state, quantity); };
            const double v = state.zd[joint], ratio = v / value(f.stribeck_velocity);
            const double level = value(f.coulomb) + (value(f.stiction) - value(f.coulomb)) * std::exp(-ratio * ratio);
            return -level * std::tanh(v / value(f.velocity)) - value(f.viscous) * v;
          }};
}

/// Central differences of order eight.
std::array<double, 3> position_and_rates(const Source& source, const Motion& motion, double t) {
  constexpr long double kStep = 1.0L / 256;
  constexpr long double kFirst[] = {4.0L / 5, -1.0L / 5, 4.0L / 105, -1.0L / 280};
  constexpr long double kSecond[] = {8.0L / 5, -1.0L / 5, 8.0L / 315, -1.0L / 560};
  const auto position = [&](long double at) {
    return evaluate<long double>(motion.position, source.model.expressions, Environment<long double>{source, at});
  };
  const long double here = position(t);
  long double first = 0, second = -205.0L / 72 * here;
  for (int k = 0; k < 4; ++k) {
    const long double ahead = position(t + (k + 1) * kStep), behind = position(t - (k + 1) * kStep);
    first += kFirst[k] * (ahead - behind);
    second += kSecond[k] * (ahead + behind);
  }
  return {static_cast<double>(here), static_cast<double>(first / kStep), static_cast<double>(second / kStep / kStep)};
}

}  // namespace

std::vector<double> inputs_at(const Model& model, double t) {
  std::vector<double> inputs;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) inputs.push_back(input_after(model, static_cast<int>(i), t));
  return inputs;
}

Result<ForceElements> force_elements_of(const Model& model, const Topology& topology) {
  Diagnostics unknown;
  for (const Tyre& tyre : model.tyres)
    unknown.push_back({tyre.where, "tyre " + quoted(tyre.name) + " has no form in a foreign solver", "", ""});
  const auto refuse_friction = [&](const FrictionLaw& law, const auto& friction) {
    if (law.has_bristle() || law.normal >= 0 || law.load >= 0)
      unknown.push_back(
          {friction.where, "friction " + quoted(friction.name) + " has no form in a foreign solver", "", ""});
  };
  for (const JointFriction& friction : model.frictions) refuse_friction(friction, friction);
  for (const SpringFriction& friction : model.spring_frictions)
    unknown.push_back(
        {friction.where, "friction " + quoted(friction.name) + " has no form in a foreign solver", "", ""});
  for (const RodFriction& friction : model.rod_frictions)
    unknown.push_back(
        {friction.where, "friction " + quoted(friction.name) + " has no form in a foreign solver", "", ""});
  for (const Bushing& bushing : model.bushings)
    for (int i = 0; i < kBushingFreedoms; ++i)
      if (has_maxwell_branch(bushing, i))
        unknown.push_back(
            {bushing.where, "states of bushing " + quoted(bushing.name) + " have no form in a foreign solver", "", ""});
  if (!unknown.empty()) return unknown;
  const SharedSource source = std::make_shared<const Source>(Source{model, topology});
  const Model& kept = source->model;
  ForceElements elements;
  for (const PointSpring& spring : kept.springs) elements.lines.push_back(line_of(source, spring));
  for (const AirSpring& spring : kept.air_springs) elements.lines.push_back(line_of(source, spring));
  for (const Bushing& bushing : kept.bushings) elements.frames.push_back(frames_of(source, bushing));
  for (const BumpStop& stop : kept.bump_stops) add_stop(source, stop, elements);
  for (const AppliedForce& applied : kept.forces) elements.loads.push_back(load_of(source, applied));
  for (const JointSpring& spring : kept.joint_springs) add_joint_spring(source, spring, elements);
  for (const JointFriction& friction : kept.frictions) elements.coordinates.push_back(friction_of(source, friction));
  for (const JointForce& force : kept.joint_forces)
    elements.coordinates.push_back(
        {force.name, tree_coordinate(topology, force.joint),
         [source, &force](const ForeignState& state) { return value_of(*source, state, force.force); }});
  for (const Motion& motion : kept.motions)
    elements.motions.push_back({motion.name, tree_coordinate(topology, motion.joint),
                                [source, &motion](double t) { return position_and_rates(*source, motion, t); }});
  return elements;
}

}  // namespace mbgen::foreign
