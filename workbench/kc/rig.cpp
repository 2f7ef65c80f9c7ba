#include "workbench/kc/rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/element_access.hpp"
#include "compiler/model/vectors.hpp"
#include "compiler/text/user_error.hpp"

namespace mbgen::kc {
namespace {

/// A unit vector across an axis that is not vertical: the direction to the top of the wheel.
Vector3 upwards_across(const Vector3& axis) {
  const double level = std::hypot(axis[0], axis[1]);
  return {-axis[0] * axis[2] / level, -axis[1] * axis[2] / level, level};
}

/// Wheel on the rig.
struct MountedWheel {
  std::string name;
  Attachment centre;
  Vector3 axis;
};

/// Converts the user's model to the model of the rig.
class RigBuilder {
 public:
  RigBuilder(const Compilation& user, const Axle& axle, const OperatingPoint& at, const Pads& pads)
      : user_(user), at_(at), axle_(axle), pads_(pads), model_(user.model) {
    GenericSolver solver(user.model, user.topology, user.analysis);
    solver.set_inputs(at.inputs);
    poses_ = solver.poses({at.z, at.zd, at.x, at.t});
    rig_.axle = axle;
    rig_.inputs.fill(-1);
    inputs_ = at.inputs;
  }

  Result<Rig> build(const RigDecisions* known) {
    check_heading();
    if (model_.ground < 0) throw UserError(fmt::format("{}: a rig needs the body \"ground\"\n", model_.file));
    take_away(axle_, model_);
    keep_tree();
    freeze_motions();
    hold_body();
    add_wheel(0, axle_.left);
    add_wheel(1, axle_.right);
    for (int i = 0; const Tyre& tyre : user_.model.tyres) {
      if (!pads_.hanging.contains(i++) && !is_of_axle(tyre.centre))
        mount({"rig " + tyre.name, tyre.centre, tyre.axis}, -1);
    }
    add_steer();
    add_elements();
    rig_.start_inputs = inputs_;
    Result<Compilation> decided =
        known != nullptr ? Compilation{std::move(model_), known->topology, known->analysis} : decide(std::move(model_));
    if (!decided) {
      const Diagnostic& first = decided.problems().front();
      return problem_of(user_.model, axle_, "its rig is no model to solve: " + first.message, first.hint);
    }
    rig_.compilation = std::move(*decided);
    take_start();
    return std::move(rig_);
  }

 private:
  /// The axes of the rig are the axes of the reference: the body must still point along x.
  void check_heading() const {
    constexpr double kStraight = 0.01;  // rad
    const Matrix3& now = poses_[static_cast<std::size_t>(axle_.body)].rotation;
    const Pose& home = model_.bodies[static_cast<std::size_t>(axle_.body)].pose;
    const Vector3 forward = rotated(now, to_body_axes(home, {1, 0, 0}));
    const double yaw = std::atan2(forward[1], forward[0]);
    if (std::abs(yaw) < kStraight) return;
    throw UserError(
        fmt::format("{}: axle {}: at the start {} is turned by {:.3g} rad about z; a rig needs it along x\n",
                    model_.file, axle_.name, model_.bodies[static_cast<std::size_t>(axle_.body)].name, yaw));
  }

  /// Cuts the joints that the user's model cuts, so that both have the same coordinates.
  void keep_tree() {
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
      Joint& joint = model_.joints[j];
      if (joint.freedoms.empty()) continue;
      const auto& bodies = user_.topology.bodies;
      const bool is_tree = std::any_of(bodies.begin(), bodies.end(),
                                       [&](const TreeBody& body) { return body.joint == static_cast<int>(j); });
      joint.cut = is_tree ? CutMark::tree : CutMark::cut;
    }
  }

  /// Position of a coordinate at the start.
  double start_of(const CoordinateReference& coordinate) const {
    for (std::size_t i = 0; i < user_.topology.bodies.size(); ++i) {
      const TreeBody& body = user_.topology.bodies[i];
      if (body.joint == coordinate.joint && body.component == coordinate.component) return at_.z[i];
    }
    throw UserError(
        fmt::format("{}: the rig cannot drive {}: its joint is cut; mark another joint of its loop with "
                    "\"cut\": true\n",
                    model_.file, model_.joints[static_cast<std::size_t>(coordinate.joint)].name));
  }

  /// Drives a coordinate.
  void drive(const std::string& name, const CoordinateReference& coordinate, const Quantity& position) {
    for (Motion& motion : model_.motions) {
      if (motion.joint == coordinate) {
        motion.position = position;
        return;
      }
    }
    Motion motion;
    motion.name = name;
    motion.joint = coordinate;
    motion.position = position;
    model_.motions.push_back(std::move(motion));
  }

  /// Stops all motions that do not follow the steering input.
  void freeze_motions() {
    for (Motion& motion : model_.motions)
      if (!follows_steering(motion)) motion.position = start_of(motion.joint);
    // The input stands still: so do its rates.
    if (axle_.steering_input < 0) return;
    for (int rate = input_of(axle_.steering_input).derivative; rate >= 0; rate = input_of(rate).derivative)
      inputs_[static_cast<std::size_t>(rate)] = 0;
  }

  const Input& input_of(int index) const { return model_.inputs[static_cast<std::size_t>(index)]; }

  bool follows_steering(const Motion& motion) const {
    if (axle_.steering_input < 0 || motion.position.expression < 0) return false;
    const Expression& expression = model_.expressions[static_cast<std::size_t>(motion.position.expression)];
    return std::any_of(expression.nodes.begin(), expression.nodes.end(), [&](const ExpressionNode& node) {
      return node.kind == ExpressionNode::Kind::input && node.index == axle_.steering_input;
    });
  }

  void hold_body() {
    const int ground = model_.ground;
    if (axle_.body == ground) return;
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
      const Joint& joint = model_.joints[j];
      const bool is_it = (joint.to.body == axle_.body && joint.from.body == ground) ||
                         (joint.from.body == axle_.body && joint.to.body == ground);
      if (!is_it || closes_only(joint.type)) continue;
      for (std::size_t c = 0; c < joint.freedoms.size(); ++c) {
        const CoordinateReference coordinate{static_cast<int>(j), static_cast<int>(c)};
        drive("rig " + joint.freedoms[c].name, coordinate, start_of(coordinate));
      }
      return;
    }
    const std::string& body = model_.bodies[static_cast<std::size_t>(axle_.body)].name;
    throw UserError(fmt::format("{}: axle {}: no joint carries {} on ground, the rig has nothing to hold it by\n",
                                model_.file, axle_.name, body));
  }

  bool is_of_axle(const Attachment& centre) const {
    return centre.body == axle_.left.centre.body || centre.body == axle_.right.centre.body;
  }

  /// Adds an input to the model with its value at the start.
  Quantity add_input(const std::string& name, double start) {
    Input input;
    input.name = name;
    input.default_value = start;
    model_.inputs.push_back(input);
    inputs_.push_back(start);
    ExpressionNode node;
    node.kind = ExpressionNode::Kind::input;
    node.index = static_cast<int>(model_.inputs.size()) - 1;
    model_.expressions.push_back({name, {node}});
    Quantity quantity(start);
    quantity.expression = static_cast<int>(model_.expressions.size()) - 1;
    return quantity;
  }

  Quantity add_imposed(int which, const std::string& name, double start) {
    rig_.inputs[static_cast<std::size_t>(which)] = static_cast<int>(model_.inputs.size());
    return add_input(name, start);
  }

  Attachment add_point(int body, const std::string& name, const Vector3& global) {
    Body& owner = model_.bodies[static_cast<std::size_t>(body)];
    const Vector3 local = to_local(owner.pose, global);
    owner.points.push_back({name, {local[0], local[1], local[2]}});
    return {body, static_cast<int>(owner.points.size()) - 1};
  }

  int add_output(const std::string& name, decltype(Output::source) source) {
    Output output;
    output.name = name;
    output.source = std::move(source);
    model_.outputs.push_back(std::move(output));
    return static_cast<int>(model_.outputs.size()) - 1;
  }

  /// The three components of a point, relative to another one if given.
  int add_vector(const std::string& name, const Attachment& point, const Attachment& relative_to = {}) {
    const int first = static_cast<int>(model_.outputs.size());
    for (int axis = 0; axis < 3; ++axis) {
      PointOutput output;
      output.point = point;
      output.axis = axis;
      output.relative_to = relative_to;
      add_output(name + "xyz"[axis], output);
    }
    return first;
  }

  /// Global position at the start of a body point given at the reference.
  Vector3 at_start(int body, const Vector3& reference) const {
    const Pose& home = model_.bodies[static_cast<std::size_t>(body)].pose;
    return to_global(poses_[static_cast<std::size_t>(body)], to_local(home, reference));
  }

  /// Puts a wheel on a pad and locks its rotation on its carrier. travel: the input that lifts it, -1 for none. Result:
  /// index of the pad's motion.
  int mount(const MountedWheel& wheel, int travel) {
    const Vector3 reference = reference_position(model_, wheel.centre);
    const double height = at_start(wheel.centre.body, reference)[2] - reference[2];
    Body pad;
    pad.name = wheel.name;
    model_.bodies.push_back(pad);
    const int body = static_cast<int>(model_.bodies.size()) - 1;
    const Attachment top = add_point(body, "top", reference);
    Joint lift;
    lift.name = wheel.name;
    lift.type = JointType::prismatic;
    lift.from = add_point(model_.ground, wheel.name, reference);
    lift.to = top;
    lift.cut = CutMark::tree;
    lift.freedoms = {{wheel.name, FreedomKind::prismatic, {0, 0, 1}}};
    model_.joints.push_back(lift);
    const int joint = static_cast<int>(model_.joints.size()) - 1;
    Joint contact;
    contact.name = wheel.name + " contact";
    contact.type = JointType::point_on_plane;
    contact.from = top;
    contact.to = wheel.centre;
    contact.cut = CutMark::cut;
    model_.joints.push_back(contact);
    const bool is_other = travel < 0;
    if (is_other || pads_.are_driven)
      drive(wheel.name, {joint, 0}, is_other ? Quantity(height) : add_imposed(travel, wheel.name, height));
    const int motion = static_cast<int>(model_.motions.size()) - 1;
    lock(wheel);
    return motion;
  }

  /// Locks the rotation of the wheel about its axis. A joint beside this axis is a pivot of the arm that carries the
  /// wheel.
  void lock(const MountedWheel& wheel) {
    constexpr double kSameAxis = 1e-3, kOnAxis = 1e-3;  // 1, m
    const Vector3 centre = reference_position(model_, wheel.centre);
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
      const Joint& joint = model_.joints[j];
      const bool is_at_wheel = joint.from.body == wheel.centre.body || joint.to.body == wheel.centre.body;
      if (!is_at_wheel || joint.type != JointType::revolute) continue;
      if (std::abs(dot(joint.axis, wheel.axis)) < 1 - kSameAxis) continue;
      const Vector3 place = reference_position(model_, joint.from);
      const Vector3 way = {place[0] - centre[0], place[1] - centre[1], place[2] - centre[2]};
      if (norm(cross(wheel.axis, way)) > kOnAxis) continue;
      const CoordinateReference coordinate{static_cast<int>(j), 0};
      drive("rig spin " + wheel.name, coordinate, start_of(coordinate));
    }
  }

  void add_wheel(int which, const AxleWheel& wheel) {
    if (!wheel.is_there()) return;
    RigWheel& result = rig_.wheels[static_cast<std::size_t>(which)];
    const std::string name = which == 0 ? "rig left" : "rig right";
    Vector3 axis = wheel.axis;
    if (axis[1] < 0) axis = {-axis[0], -axis[1], -axis[2]};
    const Vector3 centre = reference_position(model_, wheel.centre);
    const int motion = mount({name, wheel.centre, axis}, which == 0 ? kTravelLeft : kTravelRight);
    const int body = wheel.centre.body;
    result.side = which == 0 ? 1 : -1;
    result.radius = wheel.radius;
    if (pads_.are_driven) result.load = add_output(name + " load", DriveOutput{motion});
    result.centre = add_vector(name + " centre ", wheel.centre);
    result.axis = add_vector(name + " axis ", add_point(body, name + " axis", sum(centre, axis)), wheel.centre);
    result.rim =
        add_vector(name + " rim ", add_point(body, name + " rim", sum(centre, upwards_across(axis))), wheel.centre);
    if (wheel.lower.body >= 0) {
      result.lower = add_vector(name + " lower ", wheel.lower);
      result.upper = add_vector(name + " upper ", wheel.upper);
    }
    AppliedForce force;
    force.name = name;
    force.at = wheel.centre;
    const int first = which == 0 ? kLoadsLeft : kLoadsRight;
    for (int i = 0; i < 2; ++i)
      force.force[static_cast<std::size_t>(i)] = add_imposed(first + i, fmt::format("{} force {}", name, i), 0);
    for (int i = 0; i < 3; ++i)
      force.torque[static_cast<std::size_t>(i)] = add_imposed(first + 2 + i, fmt::format("{} torque {}", name, i), 0);
    force.force[2] = 0.0;
    model_.forces.push_back(force);
  }

  void add_steer() {
    if (axle_.steering_input >= 0) {
      rig_.inputs[kSteer] = axle_.steering_input;
      rig_.steer_unit = input_of(axle_.steering_input).unit;
    }
    if (!axle_.steer) return;
    drive("rig steer", *axle_.steer, add_imposed(kSteer, "rig steer", start_of(*axle_.steer)));
    rig_.steer_unit = unit_of(freedom_of(model_, *axle_.steer).kind);
  }

  bool is_away(const std::string& name) const {
    return std::find(axle_.without.begin(), axle_.without.end(), name) != axle_.without.end();
  }

  void add_elements() {
    const auto add = [&](const std::string& name, const std::string& unit, double sense,
                         decltype(Output::source) source) {
      if (!is_away(name))
        rig_.elements.push_back({name, unit, add_output("rig " + name, std::move(source)), -1, sense});
    };
    each_kind([&]<class Kind>(KindOf<Kind> kind) {
      constexpr bool has_length = quantity_index(KindOf<Kind>{}, "length") >= 0;
      constexpr int travel = quantity_index(KindOf<Kind>{}, has_length ? "length" : "deflection");
      if constexpr (kind.is_elastic && travel >= 0)
        if constexpr (kind.quantities[travel].components == 1)
          for (std::size_t i = 0; i < kind.list(model_).size(); ++i) {
            const ElementOutput output = output_of<Kind>(kind.quantities[travel].name, i);
            add(kind.list(model_)[i].name, unit_of(model_, output), has_length ? -1 : 1, output);
          }
    });
    add_coordinates(add);
  }

  /// Travels of elastic elements on coordinates that show none themselves.
  template <class Add>
  void add_coordinates(const Add& add) {
    each_kind([&]<class Kind>(KindOf<Kind> kind) {
      if (!kind.is_elastic || quantity_index(kind, "deflection") >= 0) return;
      for (const Kind& element : kind.list(model_)) {
        const Connection connection = connection_of(element);
        const OnCoordinate* on = std::get_if<OnCoordinate>(&connection);
        if (!on || is_away(element.name)) continue;
        const auto position = [](const CoordinateReference& joint) {
          return CoordinateOutput{CoordinateOutput::What::position, joint};
        };
        add(element.name, unit_of(freedom_of(model_, on->joint).kind), 1, position(on->joint));
        if (on->relative_to)
          rig_.elements.back().less = add_output("rig less " + element.name, position(*on->relative_to));
      }
    });
  }

  /// Sets the coordinates of the user's model to its state, and the pads to theirs.
  void take_start() {
    const Topology& topology = rig_.compilation.topology;
    GenericState& start = rig_.start;
    start = {
        std::vector<double>(topology.bodies.size(), 0.0), std::vector<double>(topology.bodies.size(), 0.0), {}, at_.t};
    for (std::size_t i = 0; i < topology.bodies.size(); ++i) {
      for (std::size_t k = 0; k < user_.topology.bodies.size(); ++k) {
        if (user_.topology.bodies[k].coordinate == topology.bodies[i].coordinate) start.z[i] = at_.z[k];
      }
    }
    start.x.assign(at_.x.begin() + slip_state_count(user_.model), at_.x.end());
  }

  const Compilation& user_;
  const OperatingPoint& at_;
  const Axle& axle_;
  const Pads& pads_;
  Model model_;
  Rig rig_;
  std::vector<Pose> poses_;
  std::vector<double> inputs_;
};

}  // namespace

Diagnostic problem_of(const Model& model, const Axle& axle, const std::string& message, const std::string& hint) {
  return {Where{model.file, 0, 0, ""}, fmt::format("axle {}: {}", axle.name, message), hint, ""};
}

Result<Rig> make_rig(const Compilation& user, const Axle& axle, const OperatingPoint& at, const Pads& pads,
                     const RigDecisions* known) {
  return RigBuilder(user, axle, at, pads).build(known);
}

}  // namespace mbgen::kc
