// Readers of references to other elements and of structured values: attachments, coordinates, laws, poses.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/reader/positions.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

Matrix3 identity() { return {1, 0, 0, 0, 1, 0, 0, 0, 1}; }

/// Rotation by `angle` about a unit axis (Rodrigues).
Matrix3 rotation_about(const Vector3& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const auto [x, y, z] = axis;
  const double d = 1 - c;
  return {c + x * x * d,     x * y * d - z * s, x * z * d + y * s,  //
          y * x * d + z * s, c + y * y * d,     y * z * d - x * s,  //
          z * x * d - y * s, z * y * d + x * s, c + z * z * d};
}

}  // namespace

void read_value(Reader& reader, const Value& value, const FieldInfo&, Matrix3& target) {
  target = identity();
  const auto apply = [&](const Value& one) {
    RotationFields rotation = with_defaults<RotationFields>();
    if (!read_fields(reader, one, rotation)) return;
    if (const Value* axis = find(one, "axis")) turn_axis_by_points(*axis, target, rotation.axis);
    note_turns(reader, member_or_object(one, "angle"), rotation.angle);
    target = product(target, rotation_about(rotation.axis, rotation.angle));
  };
  if (value.kind != Value::Kind::array) return apply(value);
  for (const Value& item : value.items) apply(item);
}

void read_value(Reader& reader, const Value& value, const FieldInfo&, Pose& target) {
  read_fields(reader, value, target);
}

void read_value(Reader& reader, const Value& value, const FieldInfo&, Attachment& target) {
  const auto dot = value.text.find('.');
  if (value.kind != Value::Kind::text || dot == std::string::npos ||
      value.text.find('.', dot + 1) != std::string::npos) {
    report(reader, value, fmt::format("must be \"body.point\", got {}", describe(value)));
    return;
  }
  const std::string body = value.text.substr(0, dot), point = value.text.substr(dot + 1);
  const int index = find_body(reader, body);
  if (index < 0 && is_connected(reader, body)) return;  // an unknown body of the connection was reported there
  if (index < 0) {
    std::string hint = body == "ground" ? "give ground its points in bodies: \"ground\": { \"points\": { ... } }"
                                        : suggestion(reader, body, reader.names.bodies);
    report(reader, place_in_text(reader.documents, value, 0), "unknown body " + in_quotes(body), std::move(hint));
    return;
  }
  const NameMap<int>& points = reader.names.points[static_cast<std::size_t>(index)];
  target = find_point(reader, index, point);
  if (target.point < 0) {
    target = {};
    if (reader.names.points_unreadable[static_cast<std::size_t>(index)]) return;
    NameMap<int> candidates = points;
    candidates.insert(reader.hardpoints.names.begin(), reader.hardpoints.names.end());
    report(reader, place_in_text(reader.documents, value, dot + 1),
           fmt::format("body {} has no point {}", in_quotes(body), in_quotes(point)),
           suggestion(reader, point, candidates));
  }
}

void read_value(Reader& reader, const Value& value, const FieldInfo& info, std::vector<Attachment>& target) {
  const std::size_t size = value.kind == Value::Kind::array ? value.items.size() : 0;
  if (size < 2 || size > info.most) {
    report(reader, value,
           fmt::format("must be an array of {} points \"body.point\", got {}", info.most > 2 ? "2 or 3" : "2",
                       describe(value)));
    return;
  }
  for (const Value& item : value.items) {
    Attachment point;
    read_value(reader, item, info, point);
    const auto is_same = [&](const Attachment& other) {
      return point.body >= 0 && other.body == point.body && other.point == point.point;
    };
    if (std::any_of(target.begin(), target.end(), is_same))
      report(reader, item, in_quotes(item.text) + " stands here twice");
    target.push_back(point);
  }
}

int find_named(Reader& reader, const Value& reference, std::string_view kind, const NameMap<int>& names) {
  if (reference.kind != Value::Kind::text) return -1;
  const auto found = find_visible(names, reference.text, current_scope(reader).visible);
  if (found != names.end()) return found->second;
  report(reader, reference, fmt::format("unknown {} {}", kind, in_quotes(reference.text)),
         suggestion(reader, reference.text, names));
  return -1;
}

namespace {

/// Reports a coordinate with the name of a body: with the joint that moves the body, or at the body without one.
/// Result: false if the name is no body, or if joints could not be read.
bool refuse_body(Reader& reader, Place place, const std::string& name) {
  const auto found = find_visible(reader.names.bodies, name, current_scope(reader).visible);
  if (found == reader.names.bodies.end()) return false;
  const Model& model = reader.model;
  const int body = found->second;
  const std::string shown = in_quotes(model.bodies[static_cast<std::size_t>(body)].name);
  for (const Joint& joint : model.joints) {
    if (joint.to.body < 0 || joint.from.body < 0) return false;
    if (joint.to.body != body && joint.from.body != body) continue;
    report(reader, place, "unknown coordinate " + in_quotes(name),
           fmt::format("coordinates have the names of joints: body {} has joint {}", shown, in_quotes(joint.name)));
    return true;
  }
  if (body == model.ground) return false;
  const InScope of_body(reader, reader.names.body_scopes[static_cast<std::size_t>(body)]);
  report(reader, reader.body_places[static_cast<std::size_t>(body)], "no joint moves body " + shown,
         "add a joint whose \"to\" is a point of it; its coordinate has the joint's name");
  return true;
}

}  // namespace

CoordinateReference read_coordinate(Reader& reader, Place place, const std::string& name) {
  const Visibility& visible = current_scope(reader).visible;
  if (const CoordinateReference* found = find_coordinate(reader.names, name, visible)) return *found;
  if (may_be_unreadable(reader.names, name)) return {};
  const auto joint = find_visible(reader.names.joints, name, visible);
  if (joint == reader.names.joints.end()) {
    if (refuse_body(reader, place, name)) return {};
    std::string hint = suggests(reader) ? did_you_mean(name, reader.names.coordinates[visible.front().scope]) : "";
    report(reader, place, "unknown coordinate " + in_quotes(name), std::move(hint));
    return {};
  }
  std::string coordinates;
  const int freedoms = static_cast<int>(reader.model.joints[static_cast<std::size_t>(joint->second)].freedoms.size());
  for (int component = 0; component < freedoms; ++component) {
    for (const auto& [coordinate, reference] : reader.names.coordinates[visible.front().scope]) {
      if (reference == CoordinateReference{joint->second, component})
        coordinates += (coordinates.empty() ? "" : ", ") + coordinate;
    }
  }
  if (coordinates.empty()) {
    const JointType type = reader.model.joints[static_cast<std::size_t>(joint->second)].type;
    report(reader, place,
           fmt::format("joint {} is {} and has no coordinate", in_quotes(name),
                       closes_only(type) ? fmt::format("of type {}", name_of(type)) : "fixed"));
  } else {
    report(reader, place, fmt::format("joint {} has several coordinates", in_quotes(name)),
           "name one of " + coordinates);
  }
  return {};
}

void read_value(Reader& reader, const Value& value, const FieldInfo&, CoordinateReference& target) {
  if (value.kind != Value::Kind::text) {
    report(reader, value, fmt::format("must be the name of a coordinate, got {}", describe(value)));
  } else {
    target = read_coordinate(reader, value.place, value.text);
  }
}

void read_value(Reader& reader, const Value& value, const FieldInfo& info, Law& target) {
  if (value.kind != Value::Kind::object || find(value, "deg")) {
    Quantity quantity;
    read_value(reader, value, info, quantity);
    target = quantity;
    return;
  }
  Table table;
  read_value(reader, value, info, table);
  target = std::move(table);
}

}  // namespace mbgen::reading
