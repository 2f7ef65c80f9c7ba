// Axes by two points: from one to the other.
#include <fmt/format.h>

#include <cmath>

#include "compiler/decimal/decimal.hpp"
#include "compiler/reader/positions.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr double kNearest = 1e-6;  ///< m: nearer points have no direction, hardpoint tables leave micrometres
constexpr Vector3 kNowhere = {kUnreadable, kUnreadable, kUnreadable};

/// One end of an axis in the axes of the current scope: constants, a hardpoint, or a point of a body.
Vector3 read_end(Reader& reader, const Value& value) {
  Vector3 end = kNowhere;
  if (value.text.find('.') == std::string::npos) {
    read_value(reader, value, FieldInfo{.name = "end", .shape = Shape::position}, end);
    return end;
  }
  if (!reader.has_bodies) {
    report(reader, value, "points of bodies have no place yet where bodies and instances are turned",
           "name a hardpoint, or write three numbers");
    return end;
  }
  Attachment at;
  read_value(reader, value, FieldInfo{.name = "end", .shape = Shape::attachment}, at);
  if (at.body < 0 || at.point < 0) return end;
  const Body& body = reader.model.bodies[static_cast<std::size_t>(at.body)];
  const Vector3Quantity local = body.points[static_cast<std::size_t>(at.point)].position;
  const Matrix3 rotation = without_rest(body.pose.rotation);
  const Vector3Quantity in_model = moved(reader, transformed(reader, rotation, local), body.pose.origin);
  return constant_position(reader, value, "point " + in_quotes(value.text), position_here(reader, 0, in_model));
}

/// Name of the ends in messages.
std::string ends_text(const AxisFields& axis) {
  const bool are_named = axis.from->kind == Value::Kind::text && axis.to->kind == Value::Kind::text;
  return are_named ? fmt::format("{} and {}", in_quotes(axis.from->text), in_quotes(axis.to->text)) : "its two points";
}

}  // namespace

void read_axis_by_points(Reader& reader, const Value& value, Vector3& target) {
  target = kNowhere;
  AxisFields axis;
  if (!read_fields(reader, value, axis) || !axis.from || !axis.to) return;
  const Vector3 from = read_end(reader, *axis.from), to = read_end(reader, *axis.to);
  if (std::isnan(from[0] + from[1] + from[2] + to[0] + to[1] + to[2])) return;
  Vector3 difference{};
  for (std::size_t i = 0; i < 3; ++i) difference[i] = decimal_sum(to[i], -from[i]);
  const double length = norm(difference);
  if (length < kNearest) {
    report(reader, value, fmt::format("axis has no direction, {} are {:.3g} m apart", ends_text(axis), length),
           "name two points at different places");
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) target[i] = difference[i] / length;
}

void turn_axis_by_points(const Reader& reader, const Value* written, int body, Vector3& axis) {
  if (body < 0 || !written) return;
  const auto index = static_cast<std::size_t>(body);
  if (reader.names.body_scopes[index] != reader.scope) return;  // its axes are those of the file where it stands
  turn_axis_by_points(*written, reader.body_frames[index].rotation, axis);
}

void turn_axis_by_points(const Value& written, const Matrix3& rotation, Vector3& axis) {
  if (written.kind != Value::Kind::object || std::isnan(axis[0])) return;
  axis = rotated(without_rest(transposed(rotation)), axis);
  // A rest of turning would give coordinates other names and the equations more terms.
  for (double& component : axis) component = without_rounding(component, 1);
}

}  // namespace mbgen::reading
