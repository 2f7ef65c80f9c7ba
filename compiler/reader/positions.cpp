// Hardpoints, and the points of bodies that stand at them.
#include "compiler/reader/positions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/decimal/decimal.hpp"

namespace mbgen::reading {
namespace {

/// A position of a scope in the coordinates of a body frame, both as the scope writes them.
Vector3Quantity in_frame(Reader& reader, const Pose& frame, const Vector3Quantity& position) {
  const auto& [x, y, z] = frame.origin;
  return transformed(reader, without_rest(transposed(frame.rotation)), moved(reader, position, {-x, -y, -z}));
}

Vector3Quantity between(Reader& reader, const Vector3Quantity& position, std::size_t from, std::size_t to) {
  if (from == to) return position;
  const Placement start = reader.scopes[from].placement, end = reader.scopes[to].placement;
  const auto& [x, y, z] = end.origin;
  const Vector3Quantity in_model = moved(reader, transformed(reader, axes_of(start), position), start.origin);
  return transformed(reader, transposed(axes_of(end)), moved(reader, in_model, {-x, -y, -z}));
}

/// The first tunable parameter that a position follows from.
std::optional<std::string> tunable_parameter(const Model& model, const Vector3Quantity& position) {
  for (const Quantity& quantity : position) {
    if (quantity.expression < 0) continue;
    for (const ExpressionNode& node : model.expressions[static_cast<std::size_t>(quantity.expression)].nodes) {
      if (node.kind == ExpressionNode::Kind::parameter)
        return model.parameters[static_cast<std::size_t>(node.index)].name;
    }
  }
  return {};
}

/// Name of a body's point at a hardpoint: the hardpoint's name in the scope of the body, unless it is taken.
std::string name_of_point(const Reader& reader, const Hardpoint& hardpoint, int body) {
  const Level& level = reader.scopes[reader.names.body_scopes[static_cast<std::size_t>(body)]].visible.front();
  const std::vector<Point>& points = reader.model.bodies[static_cast<std::size_t>(body)].points;
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(points.begin(), points.end(), [&](const Point& point) { return point.name == name; });
  };
  std::string name(name_from_inside(hardpoint.name, {level}));
  if (is_taken(name)) name = hardpoint.name;
  while (is_taken(name)) name += '_';
  return name;
}

/// The point of a body at a hardpoint; the body gets it when it is first asked for.
Attachment attached(Reader& reader, int body, int index) {
  const auto [place, is_new] = reader.hardpoints.points.try_emplace({body, index}, -1);
  if (is_new) {
    Point point{name_of_point(reader, reader.hardpoints.list[static_cast<std::size_t>(index)], body),
                position_on_body(reader, index, body)};
    std::vector<Point>& points = reader.model.bodies[static_cast<std::size_t>(body)].points;
    place->second = static_cast<int>(points.size());
    points.push_back(std::move(point));
  }
  return {body, place->second};
}

}  // namespace

Vector3Quantity moved(Reader& reader, const Vector3Quantity& position, const Vector3& by) {
  Vector3Quantity result = transformed(reader, Placement{}.rotation, position, by);
  for (std::size_t i = 0; i < 3; ++i) {
    if (position[i].expression < 0) result[i] = decimal_sum(position[i].value, by[i]);
  }
  return result;
}

void read_hardpoints(Reader& reader, const Entries& entries) {
  const FieldInfo info{.name = "hardpoint", .shape = Shape::quantity_vector, .depends = Depends::parameters};
  for (const Entry& entry : entries) {
    const InScope in_scope(reader, entry.scope);
    Hardpoint hardpoint{entry.name, entry.scope, entry.place, {}};
    read_value(reader, *entry.value, info, hardpoint.position);
    reader.hardpoints.names.emplace(entry.name, static_cast<int>(reader.hardpoints.list.size()));
    reader.hardpoints.list.push_back(std::move(hardpoint));
  }
}

void finish_hardpoints(Reader& reader) {
  constexpr std::size_t kMostListed = 8;
  std::map<std::size_t, std::vector<const Hardpoint*>> unused;  // per scope: one note for a table of many
  for (const Hardpoint& hardpoint : reader.hardpoints.list) {
    reader.model.hardpoints.push_back({hardpoint.name, between(reader, hardpoint.position, hardpoint.scope, 0)});
    if (!hardpoint.is_used) unused[hardpoint.scope].push_back(&hardpoint);
  }
  for (const auto& [scope, list] : unused) {
    const InScope in_scope(reader, scope);
    std::string names;
    for (std::size_t i = 0; i < std::min(list.size(), kMostListed); ++i) {
      names += names.empty() ? "" : ", ";
      names += in_quotes(name_from_inside(list[i]->name, current_scope(reader).visible));
    }
    if (list.size() > kMostListed) names += fmt::format(" and {} more", list.size() - kMostListed);
    const bool several = list.size() > 1;
    note(reader, list.front()->place, fmt::format("nothing uses hardpoint{} {}", several ? "s" : "", names),
         fmt::format("a joint, rod or spring attaches a body to one by \"body.{}\"",
                     name_from_inside(list.front()->name, current_scope(reader).visible)));
  }
}

Vector3Quantity position_here(Reader& reader, std::size_t scope, const Vector3Quantity& position) {
  return between(reader, position, scope, reader.scope);
}

int find_hardpoint(Reader& reader, const Value& value) {
  const NameMap<int>& names = reader.hardpoints.names;
  const auto found = find_visible(names, value.text, current_scope(reader).visible);
  if (found == names.end()) {
    std::string hint = names.empty() && is_valid_name(value.text)
                           ? fmt::format("write \"hardpoints\": {{ {}: [x, y, z] }}", in_quotes(value.text))
                           : suggestion(reader, value.text, names);
    report(reader, value, "unknown hardpoint " + in_quotes(value.text), std::move(hint));
    return -1;
  }
  Hardpoint& hardpoint = reader.hardpoints.list[static_cast<std::size_t>(found->second)];
  hardpoint.is_used = true;
  if (hardpoint.scope < reader.placed_scopes) return found->second;
  report(reader, value, fmt::format("hardpoint {} is in an instance that is placed later", in_quotes(value.text)),
         "define it in this file, or move the instance up");
  return -1;
}

void read_position(Reader& reader, const Value& value, const FieldInfo& info, const Pose& frame,
                   Vector3Quantity& target) {
  if (value.kind != Value::Kind::text) return read_value(reader, value, info, target);
  target.fill(kUnreadable);
  const int index = find_hardpoint(reader, value);
  if (index < 0) return;
  const Hardpoint& hardpoint = reader.hardpoints.list[static_cast<std::size_t>(index)];
  target = in_frame(reader, frame, position_here(reader, hardpoint.scope, hardpoint.position));
}

Vector3 constant_position(Reader& reader, const Value& value, const std::string& what,
                          const Vector3Quantity& position) {
  if (const auto parameter = tunable_parameter(reader.model, position)) {
    report(reader, value,
           fmt::format("must be constant, {} depends on tunable parameter {}", what, in_quotes(*parameter)));
    return {kUnreadable, kUnreadable, kUnreadable};
  }
  return {position[0].value, position[1].value, position[2].value};
}

void read_constant_hardpoint(Reader& reader, const Value& value, Vector3& target) {
  target.fill(kUnreadable);
  const int index = find_hardpoint(reader, value);
  if (index < 0) return;
  const Hardpoint& hardpoint = reader.hardpoints.list[static_cast<std::size_t>(index)];
  target = constant_position(reader, value, "hardpoint " + in_quotes(value.text),
                             position_here(reader, hardpoint.scope, hardpoint.position));
}

Vector3Quantity position_on_body(Reader& reader, int hardpoint, int body) {
  Hardpoint& found = reader.hardpoints.list[static_cast<std::size_t>(hardpoint)];
  found.is_used = true;
  const auto index = static_cast<std::size_t>(body);
  const std::size_t scope = reader.names.body_scopes[index];
  const Vector3Quantity written =
      in_frame(reader, reader.body_frames[index], between(reader, found.position, found.scope, scope));
  const Vector3& flip = reader.scopes[scope].placement.flip;  // the frame of a mirrored body took it along
  return transformed(reader, {flip[0], 0, 0, 0, flip[1], 0, 0, 0, flip[2]}, written);
}

Attachment find_point(Reader& reader, int body, const std::string& name) {
  const NameMap<int>& points = reader.names.points[static_cast<std::size_t>(body)];
  const Visibility& of_body = reader.scopes[reader.names.body_scopes[static_cast<std::size_t>(body)]].visible;
  const Visibility& of_user = current_scope(reader).visible;
  const bool is_inside = of_body.size() > of_user.size();  // the inner names come first, from both sides
  for (const Visibility* visible : {is_inside ? &of_body : &of_user, is_inside ? &of_user : &of_body}) {
    for (const Level& level : *visible) {
      const std::string full = full_name(level, name);
      if (level.scope == of_body.front().scope) {
        if (const auto own = points.find(name); own != points.end()) return {body, own->second};
      }
      if (const auto point = points.find(full); point != points.end()) return {body, point->second};
      const auto hardpoint = reader.hardpoints.names.find(full);
      if (hardpoint != reader.hardpoints.names.end()) return attached(reader, body, hardpoint->second);
    }
  }
  return {body, -1};
}

}  // namespace mbgen::reading
