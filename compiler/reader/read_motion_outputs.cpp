// Outputs of the motion of points, bodies and wheels, and of energy and momentum.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/reader/output_sources.hpp"

namespace mbgen::reading {
namespace {

constexpr std::array kBodyQuantities = {Quantities::angle,
                                        Quantities::rotation_vector,
                                        Quantities::quaternion,
                                        Quantities::angular_velocity,
                                        Quantities::angular_acceleration,
                                        Quantities::kinetic_energy,
                                        Quantities::potential_energy,
                                        Quantities::momentum,
                                        Quantities::angular_momentum};
constexpr std::span<const Quantities> kMomentumQuantities = std::span(kBodyQuantities).subspan(5);

/// Name of the quantity in the model; the default if there is none.
std::string_view quantity_name(const Value& value, std::string_view otherwise) {
  const Value* written = find(value, "quantity");
  return written && written->kind == Value::Kind::text ? std::string_view(written->text) : otherwise;
}

/// Whether the source has the quantity; otherwise quantity_of has reported it.
bool is_known(const OutputFields& output, Quantities quantity) {
  return !output.quantity || *output.quantity == quantity;
}

/// Reports the fields that are not in `taken`, a list separated by blanks.
void refuse_others(Reader& reader, const Value& value, std::initializer_list<std::string_view> fields,
                   std::string_view taken, std::string_view of) {
  const std::string list = fmt::format(" {} ", taken);
  for (const std::string_view key : fields)
    if (list.find(fmt::format(" {} ", key)) == std::string::npos) refuse(reader, value, key, of);
}

/// Index of the body named by a field; kNoBody if it is absent, or with a problem.
int body_of(Reader& reader, const Value& value, std::string_view key) {
  const Value* written = find(value, key);
  if (!written) return kNoBody;
  if (written->kind != Value::Kind::text) {
    report(reader, *written, "must be the name of a body, got " + describe(*written));
    return kNoBody;
  }
  const int body = find_body(reader, written->text);
  if (body < 0 && !is_connected(reader, written->text))
    report(reader, *written, "unknown body " + in_quotes(written->text),
           suggestion(reader, written->text, reader.names.bodies));
  return body;
}

/// Body with the axes of a component. own: the body for `frame` "body".
int axes_of(Reader& reader, const Value& value, const OutputFields& output, int own) {
  if (const Member* member = find_member(value, "axes_of"); member && find(value, "frame"))
    report(reader, member->place, "output has both \"frame\" and \"axes_of\"");
  return output.in_body_axes.value_or(false) ? own : body_of(reader, value, "axes_of");
}

/// Observer of a relative motion: by default the body of the axes; ground for a motion that is not relative.
int observer_of(Reader& reader, const Value& value, int axes) {
  const Member* member = find_member(value, "observer");
  if (find(value, "relative_to")) return member ? body_of(reader, value, "observer") : axes;
  if (member)
    report(reader, member->place, "\"observer\" needs \"relative_to\"",
           "without it the motion is that which is seen from ground");
  return kNoBody;
}

bool is_sequence(const std::string& text) {
  const auto is_axis = [](char c) { return c == 'x' || c == 'y' || c == 'z'; };
  return text.size() == 3 && std::all_of(text.begin(), text.end(), is_axis) && text[0] != text[1] && text[1] != text[2];
}

RotationOutput rotation_output(Reader& reader, const Value& value, const OutputFields& output, Quantities quantity) {
  const std::string_view name = quantity_name(value, "angle");
  RotationOutput rotation;
  rotation.what = offset<RotationOutput::What>(quantity, Quantities::angle);
  rotation.body = body_of(reader, value, "body");
  rotation.relative_to = body_of(reader, value, "relative_to");
  require(reader, value, quantity == Quantities::angle ? "turn" : "axis", name);
  rotation.axis = static_cast<int>(output.axis.value_or(Letter::x));
  rotation.turn = static_cast<int>(output.turn.value_or(Turn::first));
  rotation.axes = axes_of(reader, value, output, rotation.body);
  if (quantity == Quantities::angular_acceleration) rotation.observer = observer_of(reader, value, rotation.axes);
  const std::string sequence = output.sequence.value_or("zyx");
  if (!is_sequence(sequence))
    report(reader, *find(value, "sequence"),
           "sequence must be three of x, y and z, neighbours different, got " + in_quotes(sequence));
  else
    for (std::size_t i = 0; i < 3; ++i) rotation.sequence[i] = sequence[i] - 'x';
  return rotation;
}

Resolved momentum_output(Reader& reader, const Value& value, const OutputFields& output, Quantities quantity,
                         int body) {
  MomentumOutput source;
  source.what = offset<MomentumOutput::What>(quantity, Quantities::kinetic_energy);
  source.body = body;
  if (quantity <= Quantities::potential_energy) return {source, "J"};
  require(reader, value, "axis", quantity_name(value, "momentum"));
  source.axis = static_cast<int>(output.axis.value_or(Letter::x));
  source.axes = axes_of(reader, value, output, body);
  if (output.about) source.about = *output.about;
  return {source, quantity == Quantities::momentum ? "kg m/s" : "kg m^2/s"};
}

/// Fields for quantities of bodies.
std::string_view taken_by(Quantities quantity) {
  switch (quantity) {
    case Quantities::angle:
      return "relative_to sequence turn";
    case Quantities::rotation_vector:
    case Quantities::quaternion:
      return "relative_to axis";
    case Quantities::angular_velocity:
      return "relative_to axis frame axes_of";
    case Quantities::angular_acceleration:
      return "relative_to axis frame axes_of observer";
    case Quantities::momentum:
      return "axis frame axes_of";
    case Quantities::angular_momentum:
      return "axis frame axes_of about";
    default:
      return "";
  }
}

/// Axes of a vehicle at the reference configuration, without a body the global ones.
Pose pose_of_vehicle(const Model& model, int vehicle) {
  return vehicle == kNoBody ? Pose{} : model.bodies[static_cast<std::size_t>(vehicle)].pose;
}

/// 1 for a wheel on the left of a vehicle or in its middle, -1 on its right: from the reference configuration.
double side_of(const Model& model, const Attachment& at, int vehicle) {
  constexpr double kMiddle = 1e-6;  // m
  const Pose pose = pose_of_vehicle(model, vehicle);
  const Vector3 centre = reference_position(model, at);
  const Vector3 from_origin{centre[0] - pose.origin[0], centre[1] - pose.origin[1], centre[2] - pose.origin[2]};
  return rotated(transposed(pose.rotation), from_origin)[1] < -kMiddle ? -1 : 1;
}

/// Takes the wheel that turns in a joint: its axis, pointing to the left, and its side.
void take_joint(Reader& reader, const Value& value, int index, std::string_view quantity, WheelOutput& wheel) {
  if (index < 0) return;
  const Joint& joint = reader.model.joints[static_cast<std::size_t>(index)];
  const Value& written = *find(value, "joint");
  if (joint.type != JointType::revolute) {
    report(reader, written,
           fmt::format("{} needs the revolute joint of a wheel, {} is of type {}", quantity, in_quotes(joint.name),
                       name_of(joint.type)));
    return;
  }
  if (joint.to.body < 0 || std::isnan(joint.axis[0])) return;
  const Vector3 seen = rotated(transposed(pose_of_vehicle(reader.model, wheel.vehicle).rotation), joint.axis);
  constexpr double kUpright = 1e-3;  // rad between the axis and the vertical
  if (quantity != "caster" && quantity != "kingpin_inclination" && std::hypot(seen[0], seen[1]) < kUpright) {
    report(reader, written,
           fmt::format("the axis of joint {} is vertical, a wheel in it has no {}", in_quotes(joint.name), quantity),
           "name the joint that the wheel turns in");
    return;
  }
  wheel.joint = index;
  wheel.axis = joint.axis;
  if (seen[1] < 0)
    for (double& component : wheel.axis) component = component == 0 ? 0 : -component;
  wheel.side = side_of(reader.model, joint.to, wheel.vehicle);
}

}  // namespace

void refuse(Reader& reader, const Value& value, std::string_view key, std::string_view source) {
  if (const Member* member = find_member(value, key))
    report(reader, member->place, fmt::format("an output of {} takes no {}", source, in_quotes(key)));
}

void require(Reader& reader, const Value& value, std::string_view key, std::string_view source) {
  if (!find(value, key)) report(reader, value, fmt::format("an output of {} needs {}", source, in_quotes(key)));
}

Quantities quantity_of(Reader& reader, const Value& value, const OutputFields& output,
                       std::span<const Quantities> allowed, std::string_view source) {
  if (!output.quantity) return allowed.front();
  if (std::find(allowed.begin(), allowed.end(), *output.quantity) != allowed.end()) return *output.quantity;
  report(reader, *find(value, "quantity"), fmt::format("a {} has no {}", source, find(value, "quantity")->text));
  return allowed.front();
}

int find_element(Reader& reader, const Value& value, std::string_view key, const NameMap<int>& names) {
  return find_named(reader, *find(value, key), key, names);
}

const char* motion_unit(bool rotation, Quantities quantity) {
  if (quantity == Quantities::position) return rotation ? "rad" : "m";
  if (quantity == Quantities::velocity) return rotation ? "rad/s" : "m/s";
  return rotation ? "rad/s^2" : "m/s^2";
}

Resolved point_output(Reader& reader, const Value& value, const OutputFields& output) {
  const Quantities quantity = quantity_of(reader, value, output, kMotionQuantities, "point");
  require(reader, value, "axis", "point");
  if (quantity == Quantities::position) refuse(reader, value, "observer", "position");
  PointOutput point;
  point.what = offset<PointOutput::What>(quantity, Quantities::position);
  point.point = *output.point;
  point.axis = static_cast<int>(output.axis.value_or(Letter::x));
  point.in_body_axes = output.in_body_axes.value_or(false);
  point.axes = axes_of(reader, value, output, point.point.body);
  if (output.relative_to) read_value(reader, *output.relative_to, {}, point.relative_to);
  if (quantity != Quantities::position) point.observer = observer_of(reader, value, point.axes);
  return {point, motion_unit(false, quantity)};
}

Resolved points_output(Reader& reader, const Value& value, const OutputFields& output) {
  PointsOutput source;
  const std::vector<Attachment>& points = *output.points;
  std::copy_n(points.begin(), std::min(points.size(), source.points.size()), source.points.begin());
  const bool is_angle = points.size() == 3;
  const Quantities only[] = {is_angle ? Quantities::angle : Quantities::distance};
  quantity_of(reader, value, output, only, is_angle ? "triple of points" : "pair of points");
  return {source, is_angle ? "rad" : "m"};
}

Resolved body_output(Reader& reader, const Value& value, const OutputFields& output) {
  const Quantities quantity = quantity_of(reader, value, output, kBodyQuantities, "body");
  if (!is_known(output, quantity)) return {};
  const std::string_view name = quantity_name(value, "angle");
  refuse_others(reader, value, {"axis", "frame", "axes_of", "relative_to", "observer", "sequence", "turn", "about"},
                taken_by(quantity), name);
  if (quantity >= Quantities::kinetic_energy)
    return momentum_output(reader, value, output, quantity, body_of(reader, value, "body"));
  const RotationOutput source = rotation_output(reader, value, output, quantity);
  if (quantity == Quantities::quaternion) return {source, "1"};
  if (quantity == Quantities::angular_velocity) return {source, "rad/s"};
  return {source, quantity == Quantities::angular_acceleration ? "rad/s^2" : "rad"};
}

Resolved bodies_output(Reader& reader, const Value& value, const OutputFields& output) {
  const Quantities quantity = quantity_of(reader, value, output, kMomentumQuantities, "set of bodies");
  if (!is_known(output, quantity)) return {};
  refuse_others(reader, value, {"axis", "axes_of", "about"}, taken_by(quantity),
                quantity_name(value, "kinetic_energy"));
  return momentum_output(reader, value, output, quantity, kNoBody);
}

Resolved wheel_output(Reader& reader, const Value& value, const OutputFields& output, Quantities quantity) {
  WheelOutput wheel;
  wheel.what = offset<WheelOutput::What>(quantity, Quantities::toe);
  wheel.vehicle = body_of(reader, value, "relative_to");
  const std::string_view name = quantity_name(value, "toe");
  if (output.joint) {
    take_joint(reader, value, output.joint->joint, name, wheel);
  } else {
    wheel.tyre = find_element(reader, value, "tyre", names_of<Tyre>(reader));
    if (wheel.tyre >= 0)
      wheel.side =
          side_of(reader.model, reader.model.tyres[static_cast<std::size_t>(wheel.tyre)].centre, wheel.vehicle);
  }
  if (quantity < Quantities::caster) {
    refuse(reader, value, "steering_axis", name);
    return {wheel, "rad"};
  }
  require(reader, value, "steering_axis", name);
  if (output.steering_axis && output.steering_axis->size() == 2) {
    wheel.lower = output.steering_axis->front();
    wheel.upper = output.steering_axis->back();
  }
  return {wheel, "rad"};
}

}  // namespace mbgen::reading
