// Tyres and the joints of their wheels: default axis of a tyre, and notes on likely mistakes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr double kAngleSlack = 1e-6;  ///< rad
constexpr double kOffset = 1e-6;      ///< m: rounding of a hardpoint table in micrometres
constexpr double kUnbalanced = 1e-6;  ///< of the moment of inertia about the axis
constexpr double kWobble = 0.5;       ///< rad: a larger angle is no static toe or camber
constexpr double kAcross = 0.8;       ///< rad: a wheel at a larger angle rolls sideways
constexpr const char* kWheels = "docs/use/writing_models.md, \"Wheels\"";

double degrees(double angle) { return angle * 180 / std::numbers::pi; }

/// Angle between two lines, 0 to pi/2.
double angle_of_lines(const Vector3& a, const Vector3& b) {
  const double angle = angle_between(a, b);
  return std::min(angle, std::numbers::pi - angle);
}

/// The joints of the rigid group of a tyre's wheel.
struct Holding {
  std::vector<int> hinges;  ///< its revolute and cylindrical joints
  std::vector<int> others;  ///< its other joints, except fixed ones
  int rods = 0;
  int size() const { return static_cast<int>(hinges.size() + others.size()) + rods; }
};

Holding holding_of(const Model& model, const std::vector<int>& groups, int group) {
  Holding holding;
  const auto ends_here = [&](const Attachment& from, const Attachment& to) {
    return from.body >= 0 && to.body >= 0 && (groups[from.body] == group) != (groups[to.body] == group);
  };
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    if (!ends_here(joint.from, joint.to)) continue;
    const bool turns = joint.type == JointType::revolute || joint.type == JointType::cylindrical;
    (turns ? holding.hinges : holding.others).push_back(static_cast<int>(i));
  }
  for (const Rod& rod : model.rods) holding.rods += ends_here(rod.from, rod.to) ? 1 : 0;
  return holding;
}

/// The group at the other end of a joint.
int far_group(const Model& model, const std::vector<int>& groups, int joint, int group) {
  const int from = groups[model.joints[joint].from.body], to = groups[model.joints[joint].to.body];
  return from == group ? to : from;
}

/// Body and joint of a tyre's rotation.
struct Wheel {
  int joint = -1;    ///< that it turns in
  int carried = -1;  ///< a body that rotates on the tyre's fixed one: probably the wheel
};

Wheel wheel_of(const Reader& reader, const std::vector<int>& groups, const Holding& holding, int group,
               const Vector3& left) {
  const Model& model = reader.model;
  const int ground = model.ground < 0 ? -1 : groups[model.ground];
  Wheel wheel;
  double smallest = 0;
  for (const int hinge : holding.hinges) {
    const int far = far_group(model, groups, hinge, group);
    if (holding.size() > 1 && far != ground && holding_of(model, groups, far).size() == 1) {
      wheel.carried = far;
      continue;
    }
    const double angle = angle_of_lines(model.joints[hinge].axis, left);
    if (wheel.joint >= 0 && angle >= smallest) continue;
    wheel.joint = hinge;
    smallest = angle;
  }
  return wheel;
}

/// Whether a joint other than a hinge lets the wheel rotate.
bool may_turn(const Model& model, const Holding& holding, const Vector3& axis) {
  if (holding.size() != 1 || holding.others.empty()) return false;
  const Joint& joint = model.joints[holding.others.front()];
  if (joint.type == JointType::prismatic) return false;
  return joint.type != JointType::planar || angle_of_lines(joint.axis, axis) < kAngleSlack;
}

void note_standing(Reader& reader, Place place, const TyreFields& tyre, const Wheel& wheel, const Holding& holding) {
  const std::string body = in_quotes(reader.model.bodies[tyre.centre.body].name);
  if (wheel.carried >= 0) {
    const std::string carried = in_quotes(reader.model.bodies[wheel.carried].name);
    note(reader, place,
         fmt::format("tyre is on body {}, on which body {} turns: it slides and does not roll", body, carried),
         fmt::format("put its centre on {}, if that is the wheel", carried));
  } else if (!may_turn(reader.model, holding, tyre.axis)) {
    note(reader, place,
         fmt::format("no joint lets body {} turn about the tyre's axis: it slides and does not roll", body),
         "put the tyre on a wheel, a body in a revolute joint");
  }
}

/// Notes on a tyre's axis that differs from the axis of its wheel's joint. left: direction of a default axis.
void note_axis(Reader& reader, const Value& value, const TyreFields& tyre, const Joint& joint, const Vector3& left) {
  const Value* written = find(value, "axis");
  const std::string name = in_quotes(joint.name);
  const double angle = angle_of_lines(joint.axis, written ? tyre.axis : left);
  if (!written) {
    if (angle < kAcross) return;
    note(reader, value.place,
         fmt::format("the tyre turns about the axis of joint {}, {:.4g} deg from y: it does not roll along x", name,
                     degrees(angle)),
         "turn the joint's axis; where it is meant, write it as the tyre's \"axis\"");
  } else if (angle > kWobble) {
    note(reader, written->place,
         fmt::format("axis is {:.4g} deg from the axis of joint {}, in which the wheel turns: the tyre does not roll",
                     degrees(angle), name),
         "leave out \"axis\": the axis of the joint is the default");
  } else if (angle > kAngleSlack) {
    note(reader, written->place,
         fmt::format("axis is {:.4g} deg from the axis of joint {}: the tyre wobbles as its wheel turns",
                     degrees(angle), name),
         fmt::format("leave out \"axis\": the axis of the joint is the default; static toe and camber: {}", kWheels));
  }
}

/// Component of a vector perpendicular to a unit axis.
Vector3 across(const Vector3& vector, const Vector3& axis) {
  const double along = dot(vector, axis);
  return {vector[0] - along * axis[0], vector[1] - along * axis[1], vector[2] - along * axis[2]};
}

/// Notes on an unbalanced wheel, and on a tyre beside its joint.
void note_balance(Reader& reader, Place place, const TyreFields& tyre, const Joint& joint, const RigidGroup& wheel) {
  const std::string name = in_quotes(joint.name);
  const Vector3 on_axis = reference_position(reader.model, joint.to);
  const auto offset = [&](const Vector3& point) {
    return norm(across({point[0] - on_axis[0], point[1] - on_axis[1], point[2] - on_axis[2]}, joint.axis));
  };
  const double centre = offset(reference_position(reader.model, tyre.centre)), com = offset(wheel.centre);
  const auto [xx, yy, zz, xy, xz, yz] = wheel.inertia;
  const Vector3 turned = rotated({xx, xy, xz, xy, yy, yz, xz, yz, zz}, joint.axis);
  const double product = norm(across(turned, joint.axis));
  if (centre > kOffset) {
    note(reader, place,
         fmt::format("centre of the tyre is {:.4g} m off the axis of joint {}: it runs out of true", centre, name));
  } else if (wheel.mass > 0 && com > kOffset) {
    note(reader, place,
         fmt::format("centre of mass of the wheel is {:.4g} m off the axis of joint {}: it shakes as it turns", com,
                     name));
  } else if (product > kUnbalanced * dot(turned, joint.axis)) {
    note(reader, place,
         fmt::format("inertia of the wheel is not turned along with the axis of joint {}, product of inertia {:.4g} kg "
                     "m^2: it shakes as it turns",
                     name, product),
         fmt::format("give the wheel a \"pose\" with static toe and camber: {}", kWheels));
  }
}

}  // namespace

void place_on_wheel(Reader& reader, const Value& value, const std::vector<int>& groups, TyreFields& tyre) {
  const Vector3 left = placed_axis(reader, tyre.centre.body, tyre.axis, FreedomKind::revolute);
  tyre.axis = left;
  if (tyre.centre.body < 0 || tyre.centre.body == reader.model.ground || std::isnan(left[0])) return;
  const int group = groups[tyre.centre.body];
  const Holding holding = holding_of(reader.model, groups, group);
  const Wheel wheel = wheel_of(reader, groups, holding, group, left);
  const Place place = member_or_object(value, "centre").place;
  if (wheel.joint < 0) return note_standing(reader, place, tyre, wheel, holding);
  const Joint& joint = reader.model.joints[wheel.joint];
  if (std::isnan(joint.axis[0])) return;
  if (!find(value, "axis")) {
    tyre.axis = joint.axis;
    if (dot(joint.axis, left) < 0) {
      for (double& component : tyre.axis) component = component == 0 ? 0 : -component;
    }
  }
  note_axis(reader, value, tyre, joint, left);
  note_balance(reader, place, tyre, joint, rigid_group(reader.model, groups, group));
}

}  // namespace mbgen::reading
