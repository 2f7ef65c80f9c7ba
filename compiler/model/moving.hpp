#pragma once
// Motions and relations of a model with their time derivatives.

#include <algorithm>
#include <vector>

#include "compiler/expressions/curve.hpp"
#include "compiler/expressions/jet.hpp"
#include "compiler/model/model.hpp"

namespace mbgen {

/// Environment of T for a motion: time advances, parameters are constant, and inputs change by the derivatives named in
/// the model.
template <class T, class Environment>
struct MotionEnvironment {
  const std::vector<Input>& inputs;  ///< of the model
  const Environment& environment;

  Jet<T> parameter(int index) const { return Jet<T>(environment.parameter(index)); }
  Jet<T> input(int index) const {
    const int rate = derivative_of(index);
    const int acceleration = rate < 0 ? -1 : derivative_of(rate);
    return {environment.input(index), value_or_zero(rate), value_or_zero(acceleration)};
  }
  Jet<T> time() const { return {environment.time(), T(1.0), T(0.0)}; }
  // Never called: read_model refuses coordinates and locals in a motion.
  Jet<T> position(const CoordinateReference&) const { return {}; }
  Jet<T> velocity(const CoordinateReference&) const { return {}; }
  Jet<T> local(int) const { return {}; }

 private:
  int derivative_of(int index) const { return inputs[static_cast<std::size_t>(index)].derivative; }
  T value_or_zero(int index) const { return index < 0 ? T(0.0) : environment.input(index); }
};

/// Environment of a coupling's relation: coordinates move as given, parameters are constant.
template <class T, class Environment>
struct RelationEnvironment {
  const std::vector<CoordinateReference>& coordinates;
  const std::vector<Jet<T>>& positions;  ///< of the coordinates, in their order
  const Environment& environment;        ///< of T: parameter(i)

  Jet<T> parameter(int index) const { return Jet<T>(environment.parameter(index)); }
  Jet<T> position(const CoordinateReference& c) const {
    return positions[static_cast<std::size_t>(std::ranges::find(coordinates, c) - coordinates.begin())];
  }
  // Never called: read_model refuses inputs, time, velocities and locals in a relation.
  Jet<T> input(int) const { return {}; }
  Jet<T> time() const { return {}; }
  Jet<T> velocity(const CoordinateReference&) const { return {}; }
  Jet<T> local(int) const { return {}; }
};

/// Relation of a coupling and its time derivatives. positions: of its coordinates, in their order.
template <class T, class Environment>
Jet<T> evaluate_relation(const Model& model, const Coupling& coupling, const std::vector<Jet<T>>& positions,
                         const Environment& environment) {
  if (coupling.curve) {
    const CurvePoint<T> at = curve_at(*coupling.curve, positions[1].value);
    return positions[0] - chain(positions[1], at.value, at.slope, at.curvature);
  }
  return evaluate<Jet<T>>(coupling.relation, model.expressions,
                          RelationEnvironment<T, Environment>{coupling.coordinates, positions, environment});
}

/// Derivative of the relation by each of its coordinates, in their order.
template <class T, class Environment>
std::vector<T> relation_slopes(const Model& model, const Coupling& coupling, const std::vector<T>& positions,
                               const Environment& environment) {
  std::vector<Jet<T>> moving(positions.begin(), positions.end());
  std::vector<T> slopes;
  for (Jet<T>& position : moving) {
    position.first = T(1.0);
    slopes.push_back(evaluate_relation(model, coupling, moving, environment).first);
    position.first = T(0.0);
  }
  return slopes;
}

/// Prescribed position, velocity and acceleration of a motion. environment: of T, as for evaluate.
template <class T, class Environment>
Jet<T> evaluate_motion(const Model& model, const Motion& motion, const Environment& environment) {
  return evaluate<Jet<T>>(motion.position, model.expressions,
                          MotionEnvironment<T, Environment>{model.inputs, environment});
}

}  // namespace mbgen
