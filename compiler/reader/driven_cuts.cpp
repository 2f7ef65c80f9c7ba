// Driven joints that are cut: their coordinates are in the tree, on a massless body.
#include <fmt/format.h>

#include "compiler/reader/carried_body.hpp"

namespace mbgen::reading {

Attachment add_carried_body(Reader& reader, const std::string& name, const Where& where, const Attachment& at,
                            std::size_t scope) {
  const auto place = static_cast<std::size_t>(at.body);
  Body body;
  body.name = name;
  body.where = where;
  body.pose = reader.model.bodies[place].pose;
  body.points = {reader.model.bodies[place].points[static_cast<std::size_t>(at.point)]};
  const int index = static_cast<int>(reader.model.bodies.size());
  reader.names.bodies.emplace(name, index);
  reader.names.body_scopes.push_back(scope);
  reader.names.points.push_back({{body.points.front().name, 0}});
  reader.names.points_unreadable.push_back(false);
  const Pose frame = reader.body_frames[place];
  reader.body_frames.push_back(frame);
  reader.inertias.emplace_back();
  reader.model.bodies.push_back(std::move(body));
  return {index, 0};
}

void drive_at_cut(Reader& reader, const Entry& entry, int joint) {
  constexpr std::string_view kEnd = "_end", kClosure = "_closure";
  Model& model = reader.model;
  Names& names = reader.names;
  Joint& driven = model.joints[static_cast<std::size_t>(joint)];
  if (driven.to.body < 0 || driven.to.point < 0 || driven.from.body < 0) return;
  const std::string end = fmt::format("{}{}", driven.name, kEnd), closure = fmt::format("{}{}", driven.name, kClosure);
  for (const std::string& name : {end, closure}) {
    const bool is_taken = names.bodies.contains(name) || names.joints.contains(name) || names.rods.contains(name);
    if (!is_taken && is_valid_name(name)) continue;
    report(reader, entry.place,
           fmt::format("joint {} is driven where it is cut, and so needs the name {}, which {}", in_quotes(driven.name),
                       in_quotes(name), is_taken ? "another element has" : "is too long"),
           "rename one of them, or take the mark \"cut\": true away");
    return;
  }
  const Attachment carried = add_carried_body(reader, end, driven.where, driven.to, entry.scope);
  Joint fixed;
  fixed.name = closure;
  fixed.where = driven.where;
  fixed.type = JointType::fixed;
  fixed.from = carried;
  fixed.to = driven.to;
  fixed.cut = CutMark::cut;
  driven.to = carried;
  driven.cut = CutMark::tree;
  driven.closure = static_cast<int>(model.joints.size());
  names.joints.emplace(closure, driven.closure);
  model.joints.push_back(std::move(fixed));
}

}  // namespace mbgen::reading
