#pragma once
// Common parts of the force elements: results, access to the system, characteristics, and loads on bodies.

#include <functional>
#include <optional>
#include <tuple>
#include <type_traits>

#include "compiler/expressions/curve.hpp"
#include "compiler/formulation/elements/wheel_contact.hpp"
#include "compiler/formulation/motion.hpp"

namespace mbgen {

/// Length, its rate and the tension of an element between two points.
template <class T>
struct ElementState {
  T length{0.0}, rate{0.0}, force{0.0};  ///< m, m/s, N (tension positive)
};

/// Struct of T for the quantities of a kind, specialised beside its forces.
template <class Kind>
struct StateOf {
  template <class T>
  struct type {};
};

template <class T, class List>
struct StatesOf;
template <class T, class... Kind>
struct StatesOf<T, Kinds<Kind...>> {
  using type = std::tuple<std::vector<typename StateOf<Kind>::template type<T>>...>;
};

/// One force element's force and moment on one body of the model, in the frame that carries the body.
template <class T>
struct Action {
  int body = -1;            ///< index into Model::bodies
  Vector<T> force, moment;  ///< N, N m
  Vector<T> point;          ///< of the force, m, from the point of AppliedForces::about
  int element = -1;         ///< see element_in_hand
};

/// One force element's generalised force on a coordinate.
template <class T>
struct JointAction {
  int coordinate = -1;
  T force{0.0};      ///< N or N m
  int element = -1;  ///< see element_in_hand
};

template <class T>
struct AppliedForces {
  std::vector<Spatial<T>> wrench;             ///< per body, in the axes of the frame that carries it
  std::vector<T> joint;                       ///< per coordinate, N or N m
  std::vector<Action<T>> actions;             ///< terms of the sum `wrench`, and actions on bodies fixed to ground
  std::vector<JointAction<T>> joint_actions;  ///< terms of the sum `joint`
  std::vector<T> xd;                          ///< rates of the auxiliary states
  std::vector<T> hold;  ///< per place of hold_names: negative, or NaN, where the element does not hold
  typename StatesOf<T, ElementKinds>::type states;  ///< per kind as the model's list, see states_of
  MotionPoint about = MotionPoint::frame_origin;    ///< reference point of wrenches on a body
};

/// Quantities of the elements of a kind; none for a kind without quantities.
template <class Kind, class Forces>
auto& states_of(Forces& forces) {
  return std::get<kKindIndex<Kind>>(forces.states);
}

template <class T, class Kind>
const auto& state_of(const System<T>& system, const AppliedForces<T>& forces, const Kind& element) {
  return states_of<Kind>(forces)[index_in(KindOf<Kind>::list(system.model), element)];
}

/// Place for the quantities of an element.
template <class T, class Kind>
auto& state_for(const System<T>& system, AppliedForces<T>& forces, const Kind& element) {
  const auto& list = KindOf<Kind>::list(system.model);
  states_of<Kind>(forces).resize(list.size());
  return states_of<Kind>(forces)[index_in(list, element)];
}

/// Value of a spring's quantity by its index.
template <class T>
T shown(const ElementState<T>& state, int quantity, int /*axis*/) {
  const T* values[] = {&state.force, &state.length, &state.rate};
  return *values[quantity];
}

/// During its lifetime, new values belong to an element of the model.
template <class T, class Kind>
[[nodiscard]] auto within(const System<T>& system, const Kind& element) {
  return system.annotator.within(owner_of_kind(kKindIndex<Kind>), index_in(KindOf<Kind>::list(system.model), element));
}

namespace detail {

/// Forces of a tyre (index into Model::tyres) from a law shared by several tyres, none without a shared law.
template <class T>
using SharedTyreLaw =
    std::function<std::optional<WheelForces<T>>(std::size_t tyre, const TyreProperties<T>&, const WheelMotion<T>&)>;

/// State for the force elements, and the sums of their loads.
template <class T>
struct ForceWork {
  System<T>& system;
  const Kinematics<T>& k;
  const Velocities<T>& v;
  AppliedForces<T>& forces;
  SharedTyreLaw<T> shared_law = {};  ///< where tyres share one
  /// Variable of differentiation in expressions of laws over Slopes; null for none.
  const ExpressionNode* moved = nullptr;
  std::string in_hand = {};  ///< name of the element whose forces are computed, in programs for reading
  T value(const Quantity& q) const { return value_of(system.model, q, system.environment); }
  /// The value of an element's field, named <meaning>_<element>.
  T value(const Quantity& q, const char* meaning, const std::string& element) const {
    T result = value(q);
    system.annotator.constant(result, meaning, "_", element);
    return result;
  }
  Place<T> place(const Attachment& at) const { return place_of(system, at); }
};

/// Environment of T for an expression over A: everything is constant except the locals and one variable.
template <class T, class A>
struct MovedEnvironment {
  const Environment<T>& environment;
  std::vector<A> locals = {};
  const ExpressionNode* moved = nullptr;  ///< variable of differentiation, null for none

  A parameter(int i) const { return A(environment.parameter(i)); }
  A input(int i) const { return A(environment.input(i)); }
  A time() const { return A(environment.time()); }
  A position(const CoordinateReference& c) const {
    return seen(environment.position(c), moves(ExpressionNode::Kind::position) && moved->coordinate == c);
  }
  A velocity(const CoordinateReference& c) const {
    return seen(environment.velocity(c), moves(ExpressionNode::Kind::velocity) && moved->coordinate == c);
  }
  A local(int i) const { return locals[i]; }
  A state(int i) const { return seen(environment.state(i), moves(ExpressionNode::Kind::state) && moved->index == i); }
  A length(int i) const {
    return seen(environment.length(i), moves(ExpressionNode::Kind::length) && moved->index == i);
  }
  A rate(int i) const { return seen(environment.rate(i), moves(ExpressionNode::Kind::rate) && moved->index == i); }
  A output(int i) const { return A(environment.output(i)); }

 private:
  bool moves(ExpressionNode::Kind kind) const { return moved != nullptr && moved->kind == kind; }
  A seen(const T& value, bool is_moved) const { return is_moved ? A(value, T(1.0)) : A(value); }
};

/// Value of an element's field over A: T, or Slope<T> for differentiation.
template <class A, class T>
A number(const ForceWork<T>& work, const Quantity& q, const char* meaning, const std::string& element) {
  if constexpr (!std::is_same_v<T, A>)
    if (work.moved != nullptr && q.expression >= 0)
      return evaluate<A>(work.system.model.expressions[q.expression],
                         MovedEnvironment<T, A>{work.system.environment, {}, work.moved});
  return A(work.value(q, meaning, element));
}

/// Names the distances of an argument from the points of a table in programs for reading.
template <class T>
void detail_table(const ForceWork<T>& work, const Table& table, const T& argument, const char* meaning,
                  const std::string& element) {
  if (!work.system.annotator.has_details() || table.data || table.periodic) return;
  for (std::size_t i = 0; i < table.x.size(); ++i)
    work.system.annotator.detail(argument - T(table.x[i]), "beyond_", meaning, "_", element, "_",
                                 std::to_string(i + 1));
}

/// Value of a characteristic: factor times argument, or a table. The factor is named <meaning>_<element>. A: T, or
/// Slope<T> for differentiation, also in the functions that follow.
template <class T, class A>
A law(const ForceWork<T>& work, const Law& law, const A& argument, const char* meaning, const std::string& element) {
  if (const Quantity* factor = std::get_if<Quantity>(&law))
    return number<A>(work, *factor, meaning, element) * argument;
  if constexpr (std::is_same_v<T, A>) detail_table(work, std::get<Table>(law), argument, meaning, element);
  return value_along(std::get<Table>(law), argument);
}

template <class T, class A>
A law(const ForceWork<T>& work, const std::optional<Law>& optional, const A& argument, const char* meaning,
      const std::string& element) {
  return optional ? law(work, *optional, argument, meaning, element) : A(0.0);
}

/// An expression with two local variables.
template <class T, class A>
A with_locals(const ForceWork<T>& work, int expression, const A& first, const A& second) {
  const Expression& of_model = work.system.model.expressions[expression];
  if constexpr (std::is_same_v<T, A>) {
    Environment<T> environment = work.system.environment;
    environment.locals = {first, second};
    return evaluate<T>(of_model, environment);
  } else {
    return evaluate<A>(of_model, MovedEnvironment<T, A>{work.system.environment, {first, second}, work.moved});
  }
}

/// A number common to all actions of one element, in numerical evaluation; 0 for symbols, whose powers are not
/// separated.
template <class T>
int element_in_hand(const ForceWork<T>& work) {
  if constexpr (requires { work.system.annotator.parts; }) {
    return static_cast<int>(work.system.annotator.parts);
  } else {
    return 0;
  }
}

/// Names an action of the element in hand, and the sum that it adds to, in programs for reading.
template <class T>
void detail_action(const ForceWork<T>& work, const Action<T>& action, const Spatial<T>& sum) {
  Annotator<T>& annotator = work.system.annotator;
  if (!annotator.has_details() || work.in_hand.empty()) return;
  const std::string& body = work.system.model.bodies[action.body].name;
  const auto names = [&](const Vector<T>& v, const char* kind) {
    detail_name(annotator, v, kind, work.in_hand, "_on_", body);
  };
  names(action.force, "force_");
  names(action.point, "arm_");
  names(cross(action.point, action.force), "moment_");
  names(action.moment, "torque_");
  detail_name(annotator, sum, "fa", "na", body, "_before_", work.in_hand);
}

/// Adds a force and a moment on a body of the model.
template <class T>
void act(ForceWork<T>& work, const Action<T>& action) {
  work.forces.actions.push_back(action);
  work.forces.actions.back().element = element_in_hand(work);
  const int body = work.system.topology.tree_body[action.body];
  if (body == kGround) return;
  Spatial<T>& wrench = work.forces.wrench[body];
  detail_action(work, action, wrench);
  wrench = wrench + force_at(action.force, action.point);
  wrench.angular = wrench.angular + action.moment;
}

/// Adds a generalised force on a coordinate.
template <class T>
void add_joint_force(ForceWork<T>& work, const CoordinateReference& reference, const T& force) {
  const int i = tree_coordinate(work.system.topology, reference);
  if (i < 0) return;
  if (work.system.annotator.has_details() && !work.in_hand.empty()) {
    const std::string& coordinate = work.system.topology.bodies[i].coordinate;
    work.system.annotator.detail(force, "force_", work.in_hand, "_on_", coordinate);
    work.system.annotator.detail(work.forces.joint[i], "Qa_", coordinate, "_before_", work.in_hand);
  }
  work.forces.joint[i] = work.forces.joint[i] + force;
  work.forces.joint_actions.push_back({i, force, element_in_hand(work)});
}

/// Adds a force at a point of a body, given in the axes of a frame at the body or below it.
template <class T>
void apply_force(ForceWork<T>& work, int model_body, const Place<T>& place, const Vector<T>& force, int frame) {
  const int carrier = work.system.layout.frame_of(place.body);
  act(work, {model_body,
             direction_up(work.system, work.k, frame, force, carrier),
             {},
             arm_of(work.system, work.k, place, work.forces.about)});
}

/// Line between two points, in the axes of a frame.
template <class T>
struct Line {
  Place<T> from, to;
  int frame = kGround;
  Vector<T> gap;         ///< m
  T length, reciprocal;  ///< m, 1/m
  T rate;                ///< of the length, m/s
};

template <class T>
Line<T> line_between(const System<T>& system, const Kinematics<T>& k, const Velocities<T>& v, const Attachment& from,
                     const Attachment& to) {
  const Place<T> a = place_of(system, from), b = place_of(system, to);
  const int frame = common_frame(system, a.body, b.body);
  const Vector<T> gap = position_in(system, k, b, frame) - position_in(system, k, a, frame);
  const Vector<T> gap_rate = velocity_in(system, k, v, b, frame) - velocity_in(system, k, v, a, frame);
  const T length = norm(gap);
  const T reciprocal = T(1.0) / length;
  return {a, b, frame, gap, length, reciprocal, dot(gap, gap_rate) * reciprocal};
}

/// Length at zero deflection: given by the element, or its length at the reference configuration.
template <class T>
T natural_length(const ForceWork<T>& work, const std::optional<Quantity>& own, const T& reference,
                 const std::string& element) {
  T length = own ? work.value(*own) : reference;
  work.system.annotator.constant(length, "l0_", element);
  return length;
}

}  // namespace detail
}  // namespace mbgen
