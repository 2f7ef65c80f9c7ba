#include "compiler/reader/elements/beam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "compiler/model/vectors.hpp"
#include "compiler/reader/positions.hpp"

namespace mbgen::reading {
namespace {

constexpr double kMostSegments = 1000;
constexpr double kShortest = 1e-4;  ///< m, between two points
constexpr double kLeastUp = 0.02;   ///< part of `up` across the beam

/// A named point of the file.
struct BeamPoint {
  std::string name;
  Place place;
  Vector3 at{};
  const Value* support = nullptr;
  BeamSupportFields joined;
};

/// A node at the end of segments.
struct BeamNode {
  std::string suffix;  ///< of its body: "_left", "_left_1"
  Vector3 at{};
  const BeamPoint* point = nullptr;
  bool is_supported() const { return point && point->support; }
};

/// A segment between two nodes, with the axes of its section.
struct BeamSegment {
  double length = 0;
  Vector3 x{}, y{}, z{};
};

/// A beam as read.
struct BeamParts {
  const Entry& entry;
  BeamFields fields;
  BeamSection section;
  BeamMaterial material;
  std::vector<BeamPoint> points = {};
  std::vector<BeamNode> nodes = {};
  std::vector<BeamSegment> segments = {};

  std::string name_of(std::size_t node) const { return entry.written + nodes[node].suffix; }
  /// A node's body at a hardpoint.
  std::string place_of(std::size_t node, const std::string& hardpoint) const { return name_of(node) + "." + hardpoint; }
};

std::vector<BeamPoint> read_beam_points(Reader& reader, const Value& points) {
  std::vector<BeamPoint> list;
  const FieldInfo info{.name = "points", .shape = Shape::position, .depends = Depends::parameters};
  if (points.kind != Value::Kind::object) {
    report(reader, points, "must be an object of named positions, got " + describe(points));
    return list;
  }
  for (const Member& member : points.members) {
    if (!is_valid_name(member.key))
      report(reader, member.place, fmt::format("invalid name {}", in_quotes(member.key)), kNameRule);
    Vector3Quantity position;
    position.fill(kUnreadable);
    read_position(reader, member.value, info, Pose{}, position);
    list.push_back({member.key,
                    member.place,
                    constant_position(reader, member.value, "a point of a beam", position),
                    nullptr,
                    {}});
  }
  if (points.members.size() < 2) report(reader, points, "a beam has at least two points");
  for (std::size_t i = 1; i < list.size(); ++i)
    if (norm(from_to(list[i - 1].at, list[i].at)) < kShortest)
      report(reader, list[i].place,
             fmt::format("point {} is at the place of {}", in_quotes(list[i].name), in_quotes(list[i - 1].name)));
  return list;
}

void read_supports(Reader& reader, const Value& supports, std::vector<BeamPoint>& points) {
  if (supports.kind != Value::Kind::object)
    return report(reader, supports, "must be an object of named supports, got " + describe(supports));
  for (const Member& member : supports.members) {
    const auto point = std::ranges::find(points, member.key, &BeamPoint::name);
    if (point == points.end()) {
      std::vector<std::string_view> known;
      for (const BeamPoint& one : points) known.push_back(one.name);
      report(reader, member.place, fmt::format("beam has no point {}", in_quotes(member.key)),
             did_you_mean(member.key, known));
      continue;
    }
    BeamSupportFields joined = with_defaults<BeamSupportFields>();
    if (!read_fields(reader, member.value, joined)) continue;
    const bool is_hinge = joined.type == BeamSupport::hinge;
    if (is_hinge != (joined.axis != nullptr))
      report(reader, joined.axis ? *joined.axis : member.value,
             is_hinge ? "a hinge needs \"axis\"" : "only a hinge has an axis");
    point->support = &member.value;
    point->joined = std::move(joined);
  }
}

/// Nodes and segments of equal length between two points; segments go to where the beam is long.
void divide(BeamParts& beam) {
  double whole = 0;
  for (std::size_t i = 1; i < beam.points.size(); ++i) whole += norm(from_to(beam.points[i - 1].at, beam.points[i].at));
  for (std::size_t i = 0; i + 1 < beam.points.size(); ++i) {
    const BeamPoint &from = beam.points[i], &to = beam.points[i + 1];
    const Vector3 along = from_to(from.at, to.at);
    const double length = norm(along), count = std::max(1.0, std::round(beam.fields.segments * length / whole));
    for (double k = 0; k < count; ++k) {
      const std::string suffix = k == 0 ? "_" + from.name : fmt::format("_{}_{:g}", from.name, k);
      beam.nodes.push_back({suffix, sum(from.at, along, k / count), k == 0 ? &from : nullptr});
      beam.segments.push_back({length / count, times(along, 1 / length), {}, {}});
    }
  }
  beam.nodes.push_back({"_" + beam.points.back().name, beam.points.back().at, &beam.points.back()});
}

/// Axes of the sections: z is `up` as far as it is across the beam, y = z x x.
bool turn_sections(Reader& reader, BeamParts& beam) {
  const Value& value = *beam.entry.value;
  const double size = norm(beam.fields.up);
  if (size == 0) {
    report(reader, member_or_object(value, "up"), "must not be zero");
    return false;
  }
  for (BeamSegment& segment : beam.segments) {
    const Vector3 across = sum(beam.fields.up, segment.x, -dot(beam.fields.up, segment.x));
    if (!(norm(across) >= kLeastUp * size)) {
      report(reader, member_or_object(value, "up"), "a segment of the beam is along `up`, its section has no axis z",
             "give \"up\" another direction");
      return false;
    }
    segment.z = times(across, 1 / norm(across));
    segment.y = cross(segment.z, segment.x);
  }
  return true;
}

/// Mass, first moment and rotary inertia that the halves of its segments give a node.
void add_beam_body(Reader& reader, const BeamParts& beam, std::size_t node, ComposedParts& made) {
  const double line = beam.material.density * beam.section.area;
  double mass = 0;
  Vector3 moment{};
  std::array<double, 6> inertia{};  // xx yy zz xy xz yz
  const auto add_half = [&](const BeamSegment& segment, double sign) {
    const double half = line * segment.length / 2;
    mass += half;
    moment = sum(moment, segment.x, sign * half * segment.length / 6);
    const double rotary = beam.material.density * segment.length / 2;
    const std::array<std::pair<const Vector3*, double>, 3> axes = {{{&segment.x, beam.section.iy + beam.section.iz},
                                                                    {&segment.y, beam.section.iy},
                                                                    {&segment.z, beam.section.iz}}};
    for (const auto& [axis, second] : axes) {
      const Vector3& a = *axis;
      constexpr std::size_t kPairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
      for (std::size_t i = 0; i < 6; ++i) inertia[i] += rotary * second * a[kPairs[i][0]] * a[kPairs[i][1]];
    }
  };
  if (node > 0) add_half(beam.segments[node - 1], -1);
  if (node < beam.segments.size()) add_half(beam.segments[node], 1);
  Composed body(beam.entry.place);
  body.add_number("mass", mass);
  body.add_numbers("com", sum(beam.nodes[node].at, moment, 1 / mass));
  body.add_numbers("inertia", inertia);
  add_composed(reader, made.bodies, beam.entry, beam.nodes[node].suffix, std::move(body));
}

/// The node that a node without support is joined to: its neighbour on the way to the nearest support; itself if the
/// beam has none and it is the first.
std::size_t carrier_of(const BeamParts& beam, std::size_t node) {
  const std::size_t count = beam.nodes.size();
  for (std::size_t away = 1; away < count; ++away) {
    if (node >= away && beam.nodes[node - away].is_supported()) return node - 1;
    if (node + away < count && beam.nodes[node + away].is_supported()) return node + 1;
  }
  return node == 0 ? 0 : node - 1;
}

void add_beam_joint(Reader& reader, const BeamParts& beam, std::size_t node, ComposedParts& made) {
  constexpr std::array<const char*, 3> kTypes = {"fixed", "spherical", "revolute"};
  const std::string hardpoint = beam.name_of(node);
  Composed joint(beam.entry.place);
  if (beam.nodes[node].is_supported()) {
    const BeamPoint& point = *beam.nodes[node].point;
    joint.add_text("type", kTypes[static_cast<std::size_t>(point.joined.type)]);
    joint.add_text("from", point.joined.body + "." + hardpoint, find(*point.support, "body")->place);
    if (point.joined.axis) joint.add("axis", *point.joined.axis);
  } else {
    const std::size_t carrier = carrier_of(beam, node);
    const std::string on = carrier != node ? beam.name_of(carrier) : beam.fields.on.empty() ? "ground" : beam.fields.on;
    joint.add_text("type", "free");
    joint.add_text("from", on + "." + hardpoint);
  }
  joint.add_text("to", beam.place_of(node, hardpoint));
  add_composed(reader, made.joints, beam.entry, beam.nodes[node].suffix, std::move(joint));
}

/// The elastic connection of a segment: its frame has z along the beam, x along the section's y.
void add_beam_bushing(Reader& reader, const BeamParts& beam, std::size_t first, ComposedParts& made) {
  const BeamSegment& segment = beam.segments[first];
  const BeamSection& s = beam.section;
  const double l = segment.length, e = beam.material.youngs_modulus, g = beam.material.shear_modulus;
  const std::array<std::pair<const char*, double>, 6> freedoms = {{{"tx", 12 * e * s.iz / (l * l * l)},
                                                                   {"ty", 12 * e * s.iy / (l * l * l)},
                                                                   {"tz", e * s.area / l},
                                                                   {"rx", e * s.iy / l},
                                                                   {"ry", e * s.iz / l},
                                                                   {"rz", g * s.j / l}}};
  const std::string middle = beam.name_of(first) + "_mid";
  Composed bushing(beam.entry.place), axis(beam.entry.place);
  axis.add_text("from", beam.name_of(first));
  axis.add_text("to", beam.name_of(first + 1));
  bushing.add_text("from", beam.place_of(first, middle));
  bushing.add_text("to", beam.place_of(first + 1, middle));
  bushing.add("axis", std::move(axis.object));
  bushing.add_numbers("axis2", segment.y);
  for (const auto& [name, stiffness] : freedoms) {
    Composed freedom(beam.entry.place);
    freedom.add_number("stiffness", stiffness);
    if (beam.fields.damping > 0) freedom.add_number("damping", beam.fields.damping * stiffness);
    bushing.add(name, std::move(freedom.object));
  }
  add_composed(reader, made.of<Bushing>(), beam.entry, beam.nodes[first].suffix, std::move(bushing));
}

/// Both halves of a segment as cylinders of the radius that a round section with these second moments has.
void add_beam_shapes(Reader& reader, const BeamParts& beam, std::size_t first, ComposedParts& made) {
  const double radius = std::sqrt(2 * (beam.section.iy + beam.section.iz) / beam.section.area);
  const std::string middle = beam.name_of(first) + "_mid";
  for (const std::size_t node : {first, first + 1}) {
    Composed shape(beam.entry.place);
    shape.add_text("type", "cylinder");
    shape.add_text("from", beam.place_of(node, beam.name_of(node)));
    shape.add_text("to", beam.place_of(node, middle));
    shape.add_number("radius", radius);
    add_composed(reader, made.shapes, beam.entry, beam.nodes[first].suffix + (node == first ? "_begin" : "_end"),
                 std::move(shape));
  }
}

Vector3Quantity constants_of(const Vector3& at) { return {Quantity(at[0]), Quantity(at[1]), Quantity(at[2])}; }

/// The beam as checks see it.
Beam checked_beam(Reader& reader, const BeamParts& beam) {
  Beam known{beam.entry.name, where_of(reader.documents, beam.entry.place), beam.section, beam.material, {}, {}};
  for (std::size_t i = 0; i < beam.nodes.size(); ++i) {
    const BeamNode& node = beam.nodes[i];
    known.nodes.push_back(node.at);
    const bool is_welded = node.is_supported() && node.point->joined.type == BeamSupport::welded;
    known.supports.push_back(is_welded ? BeamEnd::welded : node.is_supported() ? BeamEnd::pinned : BeamEnd::free);
  }
  return known;
}

void compose_beam(Reader& reader, const Entry& entry, ComposedParts& made) {
  const std::size_t problems = reader.problems.size();
  BeamParts beam{
      .entry = entry, .fields = with_defaults<BeamFields>(), .section = {}, .material = with_defaults<BeamMaterial>()};
  if (!read_fields(reader, *entry.value, beam.fields) || reader.problems.size() > problems) return;
  if (const std::optional<BeamSection> section = read_beam_section(reader, *beam.fields.section))
    beam.section = *section;
  if (beam.fields.material) read_fields(reader, *beam.fields.material, beam.material);
  beam.points = read_beam_points(reader, *beam.fields.points);
  if (beam.fields.supports) read_supports(reader, *beam.fields.supports, beam.points);
  if (beam.fields.segments != std::floor(beam.fields.segments) || beam.fields.segments > kMostSegments)
    report(reader, *find(*entry.value, "segments"),
           fmt::format("must be a whole number up to {:g}, got {:g}", kMostSegments, beam.fields.segments));
  if (!beam.fields.on.empty() && std::ranges::any_of(beam.points, &BeamPoint::support))
    report(reader, *find(*entry.value, "on"), "the beam is on the bodies of its supports");
  if (reader.problems.size() > problems) return;
  divide(beam);
  if (!turn_sections(reader, beam)) return;
  for (std::size_t i = 0; i < beam.nodes.size(); ++i) {
    add_composed_hardpoint(reader, entry, beam.name_of(i), constants_of(beam.nodes[i].at));
    add_beam_body(reader, beam, i, made);
    add_beam_joint(reader, beam, i, made);
  }
  for (std::size_t i = 0; i < beam.segments.size(); ++i) {
    const Vector3 middle = sum(beam.nodes[i].at, beam.segments[i].x, beam.segments[i].length / 2);
    add_composed_hardpoint(reader, entry, beam.name_of(i) + "_mid", constants_of(middle));
    add_beam_bushing(reader, beam, i, made);
    add_beam_shapes(reader, beam, i, made);
  }
  const auto is_hinged = [](const BeamPoint& point) {
    return point.support && point.joined.type == BeamSupport::hinge;
  };
  if (std::ranges::none_of(beam.points, is_hinged)) reader.model.beams.push_back(checked_beam(reader, beam));
}

}  // namespace

void compose_beams(Reader& reader, const Entries& beams, ComposedParts& made) {
  for (const Entry& beam : beams) {
    const InScope in_scope(reader, beam.scope);
    compose_beam(reader, beam, made);
  }
}

}  // namespace mbgen::reading
