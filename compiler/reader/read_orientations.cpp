// Initial orientations of spherical and free joints, as values of their angles and rates.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"
#include "mbgen/charts.hpp"

namespace mbgen::reading {
namespace {

/// Rotations of a joint in their order: coordinates, and axes in `from`.
struct Turns {
  std::vector<CoordinateReference> coordinates;
  std::vector<int> axes;  ///< 0 x, 1 y, 2 z
};

/// Instances may reverse axes, and values with them: equal coordinates are mirrored motions.
Turns turns_of(const Model& model, int joint) {
  Turns turns;
  const Joint& of = model.joints[static_cast<std::size_t>(joint)];
  if (!is_ball(of.type)) return turns;
  const Matrix3 to_body = transposed(model.bodies[static_cast<std::size_t>(of.from.body)].pose.rotation);
  for (std::size_t k = 0; k < of.freedoms.size(); ++k) {
    if (of.freedoms[k].kind != FreedomKind::revolute) continue;
    const Vector3 axis = rotated(to_body, of.freedoms[k].axis);
    const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
    turns.coordinates.push_back({joint, static_cast<int>(k)});
    turns.axes.push_back(static_cast<int>(std::max_element(axis.begin(), axis.end(), larger) - axis.begin()));
  }
  return turns;
}

Matrix3 matrix_of(const std::array<double, 4>& q) {
  const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  const double w = q[0] / length, x = q[1] / length, y = q[2] / length, z = q[3] / length;
  return {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
          2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
          2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
}

std::array<double, 4> quaternion_of(const Vector3& rotation) {
  const double angle = norm(rotation), sine = angle > 0 ? std::sin(angle / 2) / angle : 0.5;
  return {std::cos(angle / 2), sine * rotation[0], sine * rotation[1], sine * rotation[2]};
}

/// A rotation in the axes of a joint's rotations: the first, the second, and their right-handed complement.
ball_detail::Turn<double> turn_in(const Turns& turns, const Matrix3& r, const Vector3& velocity) {
  const std::size_t i = static_cast<std::size_t>(turns.axes[0]), j = static_cast<std::size_t>(turns.axes[1]);
  const std::size_t axis[3] = {i, j, 3 - i - j};
  const double sign[3] = {1, 1, j == (i + 1) % 3 ? 1.0 : -1.0};
  ball_detail::Turn<double> turn{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column)
      turn.row[row][column] = sign[row] * sign[column] * r[3 * axis[row] + axis[column]];
    turn.velocity[row] = sign[row] * velocity[axis[row]];
  }
  return turn;
}

/// Sign of a joint's rotations: the third is reversed for left-handed axes.
double sign_of(const Turns& turns, std::size_t k) {
  return k == 2 && turns.axes[1] != (turns.axes[0] + 1) % 3 ? -1 : 1;
}

void set_value(std::vector<InitialValue>& list, const CoordinateReference& coordinate, double value,
               const Where& where) {
  std::erase_if(list, [&](const InitialValue& other) { return other.coordinate == coordinate; });
  InitialValue initial;
  initial.coordinate = coordinate;
  initial.value = value;
  initial.where = where;
  list.push_back(initial);
}

/// Initial angles of a joint, from the values of its coordinates.
ball_detail::Angles<double> angles_at_start(const Turns& turns, const Initial& initial) {
  ball_detail::Angles<double> angles{};
  for (std::size_t k = 0; k < 3; ++k)
    for (const InitialValue& value : initial.positions)
      if (value.coordinate == turns.coordinates[k]) angles.z[k] = sign_of(turns, k) * value.value;
  return angles;
}

void set_orientation(const Turns& turns, const OrientationFields& fields, const Where& where, Initial& initial) {
  if (!fields.quaternion && !fields.rotation_vector) return;
  const Matrix3 r = matrix_of(fields.quaternion ? *fields.quaternion : quaternion_of(*fields.rotation_vector));
  const ball_detail::Angles<double> angles = ball_detail::angles_of(turn_in(turns, r, {}));
  for (std::size_t k = 0; k < 3; ++k)
    set_value(initial.positions, turns.coordinates[k], sign_of(turns, k) * angles.z[k], where);
}

/// Sets an angular velocity as rates of the angles, or directly near their pole.
void set_angular_velocity(int joint, const Turns& turns, const Vector3& velocity, const Where& where,
                          Initial& initial) {
  constexpr double kNearPole = 1e-3;  // cosine of the second angle: three digits are lost below
  const ball_detail::Angles<double> angles = angles_at_start(turns, initial);
  const double s = std::sin(angles.z[0]), c = std::cos(angles.z[0]), cosine = std::cos(angles.z[1]);
  if (!(std::abs(cosine) > kNearPole)) {
    for (const CoordinateReference& coordinate : turns.coordinates)
      std::erase_if(initial.velocities, [&](const InitialValue& other) { return other.coordinate == coordinate; });
    initial.turnings.push_back({joint, velocity, where});
    return;
  }
  const ball_detail::Turn<double> turn = turn_in(turns, {}, velocity);
  const double* v = turn.velocity;
  const double third = (c * v[2] - s * v[1]) / cosine;
  const double rates[3] = {v[0] - std::sin(angles.z[1]) * third, c * v[1] + s * v[2], third};
  for (std::size_t k = 0; k < 3; ++k)
    set_value(initial.velocities, turns.coordinates[k], sign_of(turns, k) * rates[k], where);
}

void read_orientation(Reader& reader, const Member& member, Initial& initial) {
  OrientationFields fields = with_defaults<OrientationFields>();
  read_fields(reader, member.value, fields);
  const Visibility& visible = current_scope(reader).visible;
  const auto found = find_visible(reader.names.joints, member.key, visible);
  if (found == reader.names.joints.end()) {
    if (!may_be_unreadable(reader.names, member.key))
      report(reader, member.place, "unknown joint " + in_quotes(member.key));
    return;
  }
  const Turns turns = turns_of(reader.model, found->second);
  if (turns.coordinates.size() != 3) {
    report(reader, member.place, fmt::format("joint {} is no spherical or free one", in_quotes(member.key)),
           "give its coordinates in \"positions\" and \"velocities\"");
    return;
  }
  if (fields.quaternion && fields.rotation_vector) {
    report(reader, member.value, "must have at most one of quaternion, rotation_vector");
    return;
  }
  const auto is_zero = [](double part) { return part == 0; };
  if (fields.quaternion && std::all_of(fields.quaternion->begin(), fields.quaternion->end(), is_zero)) {
    report(reader, *find(member.value, "quaternion"), "must not be zero");
    return;
  }
  const Where where = where_of(reader.documents, member.place);
  for (const CoordinateReference& coordinate : turns.coordinates) refuse_reversed(reader, member.place, coordinate);
  set_orientation(turns, fields, where, initial);
  if (fields.angular_velocity) set_angular_velocity(found->second, turns, *fields.angular_velocity, where, initial);
}

}  // namespace

void read_orientations(Reader& reader, const Value* values, Initial& initial) {
  if (!values) return;
  if (values->kind != Value::Kind::object) {
    report(reader, *values, "must be an object of joints, got " + describe(*values));
    return;
  }
  for (const Member& member : values->members) read_orientation(reader, member, initial);
}

}  // namespace mbgen::reading
