// Couplings, and ends and names of elements between points.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

/// The coordinates whose positions stand in an expression, each once, as they come.
std::vector<CoordinateReference> positions_in(const Expression& expression) {
  std::vector<CoordinateReference> found;
  for (const ExpressionNode& node : expression.nodes) {
    if (node.kind != ExpressionNode::Kind::position) continue;
    if (std::find(found.begin(), found.end(), node.coordinate) == found.end()) found.push_back(node.coordinate);
  }
  return found;
}

/// One coordinate as a smooth curve over another.
void check_curve(Reader& reader, const Value& value, Coupling& coupling) {
  for (const std::string_view key : {"joint", "follows"})
    if (!find(value, key)) report(reader, value, fmt::format("a coupling by a curve needs {}", in_quotes(key)));
  const Value& curve = *find(value, "curve");
  const Value& word = member_or_object(curve, "interpolation");
  if (curve.kind == Value::Kind::object && (&word == &curve || word.text == "linear"))
    report(reader, word, "the curve of a coupling has corners, at which velocities would jump",
           "write \"interpolation\": \"spline\", or \"monotone_cubic\" where the points rise and fall for certain");
  if (!coupling.joint || !coupling.follows) return;
  refuse_reversed(reader, find(value, "joint")->place, *coupling.joint);
  refuse_reversed(reader, find(value, "follows")->place, *coupling.follows);
  if (coupling.joint->joint >= 0 && *coupling.joint == *coupling.follows)
    report(reader, *find(value, "follows"),
           fmt::format("coordinate {} follows itself", in_quotes(coordinate_name(reader.model, *coupling.joint))));
  coupling.coordinates = {*coupling.joint, *coupling.follows};
}

}  // namespace

bool has_any(const Value& value, std::initializer_list<std::string_view> keys) {
  return std::any_of(keys.begin(), keys.end(), [&](std::string_view key) { return find(value, key) != nullptr; });
}

double check_ends(Reader& reader, const Value& value, const Attachment& from, const Attachment& to) {
  if (from.body < 0 || to.body < 0) return kUnreadable;
  if (from.body == to.body) {
    report(reader, *find(value, "to"),
           "both ends are on body " + in_quotes(reader.model.bodies[static_cast<std::size_t>(to.body)].name));
    return kUnreadable;
  }
  const Vector3 a = reference_position(reader.model, from), b = reference_position(reader.model, to);
  return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

void read_couplings(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries) {
    reader.names.couplings.emplace(entry.name, static_cast<int>(reader.names.couplings.size()));
  }
  read_list(reader, entries, reader.model.couplings, [](Reader& r, const Value& value, Coupling& coupling) {
    const Value* relation = find(value, "relation");
    if (!relation && !coupling.curve) report(r, value, "coupling needs \"relation\" or \"curve\"");
    if (relation && coupling.curve)
      report(r, find_member(value, "curve")->place, "coupling has both \"relation\" and \"curve\"");
    for (const std::string_view key : {"joint", "follows"})
      if (const Member* member = find_member(value, key); member && !coupling.curve)
        report(r, member->place, fmt::format("a coupling has {} beside a \"curve\" only", in_quotes(key)));
    if (coupling.curve) {
      check_curve(r, value, coupling);
      return;
    }
    if (coupling.relation.expression >= 0)
      coupling.coordinates = positions_in(r.model.expressions[coupling.relation.expression]);
    if (relation && !std::isnan(coupling.relation.value) && coupling.coordinates.empty())
      report(r, *relation, "relation has no coordinate",
             "write coordinates as z.NAME, for example \"z.wheel + 0.5*z.pinion\"");
  });
}

void name_lines(Reader& reader, const std::array<Entries, ElementKinds::count>& entries) {
  each_kind([&]<class Kind>(KindOf<Kind> kind) {
    if (!kind.has_length) return;
    LengthNames list{with_article(kind.words)};
    for (const Entry& entry : entries[kKindIndex<Kind>])
      list.names.emplace(entry.name, static_cast<int>(list.names.size()));
    reader.names.lengths.push_back(std::move(list));
  });
}

}  // namespace mbgen::reading
