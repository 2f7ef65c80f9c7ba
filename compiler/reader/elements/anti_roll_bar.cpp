// Anti-roll bars: half bars, torsion between them, droplinks.
#include "compiler/reader/elements/anti_roll_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "compiler/model/vectors.hpp"
#include "compiler/reader/positions.hpp"
#include "compiler/reader/raw.hpp"

namespace mbgen::reading {
namespace {

constexpr double kNearestOfBar = 1e-6;   ///< m: rounding of hardpoint tables
constexpr double kSmallestLever = 0.02;  ///< of the arm: a droplink nearer to the direction of the arm does not twist
constexpr std::array<std::string_view, 2> kBarSides = {"left", "right"};
constexpr std::array<std::string_view, 3> kBarPoints = {"pivot", "arm", "link"};

/// Three points of one side: pivot, arm, link.
using BarPoints = std::array<Vector3Quantity, 3>;

Vector3 reference_of(const Vector3Quantity& position) {
  return {position[0].value, position[1].value, position[2].value};
}

std::string point_of_bar(const Entry& bar, std::size_t point, std::size_t side) {
  return fmt::format("{}_{}_{}", bar.written, kBarPoints[point], kBarSides[side]);
}

/// Both sides' points. Result: false with a problem.
bool read_bar_points(Reader& reader, const Value& value, const AntiRollBarFields& fields,
                     std::array<BarPoints, 2>& points) {
  const std::array<const Value*, 3> left = {fields.pivot, fields.arm, fields.link},
                                    right = {fields.right_pivot, fields.right_arm, fields.right_link};
  const FieldInfo info{.name = "point", .shape = Shape::position, .depends = Depends::parameters};
  const Pose frame;
  Matrix3 mirror = frame.rotation;
  constexpr std::size_t kNormals[] = {1, 0, 2};  // of xz, yz, xy
  mirror[4 * kNormals[static_cast<std::size_t>(fields.mirror)]] = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    points[0][i].fill(kUnreadable);
    if (left[i]) read_position(reader, *left[i], info, frame, points[0][i]);
    points[1][i] = transformed(reader, mirror, points[0][i]);
    if (right[i]) read_position(reader, *right[i], info, frame, points[1][i]);
  }
  double sum = 0;
  for (const BarPoints& side : points) {
    for (const Vector3Quantity& point : side) sum += norm(reference_of(point));
  }
  if (std::isnan(sum)) return false;
  if (norm(from_to(reference_of(points[1][0]), reference_of(points[0][0]))) >= kNearestOfBar) return true;
  report(reader, member_or_object(value, "pivot"), "both pivots are at one place, the bar has no axis",
         fields.right_pivot ? "" : "\"pivot\" is the left bearing, off the mirror plane");
  return false;
}

/// Lever of a droplink's force about the bar's axis, m; 0 with a problem.
double lever_of(Reader& reader, const Value& value, const std::array<BarPoints, 2>& points, std::size_t side) {
  const std::string prefix = side == 0 ? "" : "right_";
  const Vector3 pivot = reference_of(points[side][0]), arm = reference_of(points[side][1]),
                link = reference_of(points[side][2]);
  const Vector3 axis = normalised(from_to(reference_of(points[1][0]), reference_of(points[0][0])));
  const Vector3 to_arm = from_to(pivot, arm), rod = from_to(arm, link);
  if (norm(rod) < kNearestOfBar) {
    report(reader, member_or_object(value, prefix + "link"), "the droplink has no length, it ends at the arm");
    return 0;
  }
  const double radius = norm(cross(axis, to_arm));
  if (radius < kNearestOfBar) {
    report(reader, member_or_object(value, prefix + "arm"), "the arm ends on the bar's axis, it cannot twist the bar");
    return 0;
  }
  const double lever = std::abs(dot(axis, cross(to_arm, normalised(rod))));
  if (lever >= kSmallestLever * radius) return lever;
  report(reader, member_or_object(value, prefix + "link"),
         fmt::format("the droplink has a lever of {:.3g} m about the bar's axis, its arm has {:.3g} m: it cannot twist "
                     "the bar",
                     lever, radius),
         "a droplink is about perpendicular to its arm and to the bar");
  return 0;
}

/// Torsional stiffness from the cross-section, N m/rad. distance: of the pivots.
double stiffness_of_section(Reader& reader, const Value& value, double distance) {
  BarSectionFields section = with_defaults<BarSectionFields>();
  if (!read_fields(reader, value, section)) return kUnreadable;
  if (section.inner_diameter >= section.diameter) {
    report(reader, member_or_object(value, "inner_diameter"),
           fmt::format("must be less than the diameter of {:g} m", section.diameter));
    return kUnreadable;
  }
  const double polar = std::numbers::pi / 32 * (std::pow(section.diameter, 4) - std::pow(section.inner_diameter, 4));
  return section.shear_modulus * polar / section.length.value_or(distance);
}

/// Mass, centre and inertia of a half bar: a thin rod from the middle to the pivot, and on to the arm's end.
void add_inertia(Composed& body, double mass, const Vector3& middle, const Vector3& pivot, const Vector3& arm) {
  const std::array<std::array<Vector3, 2>, 2> pieces = {{{middle, pivot}, {pivot, arm}}};
  const double whole = norm(from_to(middle, pivot)) + norm(from_to(pivot, arm));
  Vector3 centre{};
  for (const auto& [from, to] : pieces) {
    const double part = norm(from_to(from, to)) / whole;
    for (std::size_t i = 0; i < 3; ++i) centre[i] += part * (from[i] + to[i]) / 2;
  }
  std::array<double, 6> inertia{};  // xx yy zz xy xz yz
  const auto add = [&](double factor, const Vector3& d) {
    for (std::size_t i = 0; i < 3; ++i) inertia[i] += factor * (dot(d, d) - d[i] * d[i]);
    inertia[3] -= factor * d[0] * d[1];
    inertia[4] -= factor * d[0] * d[2];
    inertia[5] -= factor * d[1] * d[2];
  };
  for (const auto& [from, to] : pieces) {
    const Vector3 along = from_to(from, to);
    const double part = mass * norm(along) / whole;
    add(part / 12, along);
    add(part, from_to(centre, {(from[0] + to[0]) / 2, (from[1] + to[1]) / 2, (from[2] + to[2]) / 2}));
  }
  body.add_number("mass", mass);
  body.add_numbers("com", centre);
  body.add_numbers("inertia", inertia);
}

/// Makes the bar's points known as hardpoints.
void add_hardpoints_of_bar(Reader& reader, const Entry& bar, const std::array<BarPoints, 2>& points) {
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t point = 0; point < 3; ++point)
      add_composed_hardpoint(reader, bar, point_of_bar(bar, point, side), points[side][point]);
  }
}

/// Name of a body as written. Result: false with a problem.
bool is_name_of_body(Reader& reader, const Value& value, std::string_view key) {
  const Value* member = find(value, key);
  if (!member || member->kind != Value::Kind::text) return false;
  if (is_valid_name(member->text)) return true;
  report(reader, *member, fmt::format("must be the name of a body, got {}", in_quotes(member->text)));
  return false;
}

bool check_bodies(Reader& reader, const Value& value, const AntiRollBarFields& fields) {
  bool is_good = true;
  for (const std::string_view key : {"body", "left", "right"}) is_good = is_name_of_body(reader, value, key) && is_good;
  if (!is_good) return false;
  for (const std::string_view key : kBarSides) {
    if ((key == "left" ? fields.left : fields.right) != fields.body) continue;
    report(reader, *find(value, key), fmt::format("{} is the body in which the bar turns", in_quotes(fields.body)),
           "name the body at the other end of the droplink");
    is_good = false;
  }
  return is_good;
}

/// Reports none or several of the fields that give the stiffness.
bool check_one_stiffness(Reader& reader, const Value& value) {
  const Member* first = nullptr;
  for (const std::string_view key : {"stiffness", "link_stiffness", "section"}) {
    const Member* member = find_member(value, key);
    if (!member) continue;
    if (first) {
      report(reader, member->place, fmt::format("bar has both {} and {}", in_quotes(first->key), in_quotes(key)),
             "leave out one of them");
      return false;
    }
    first = member;
  }
  if (!first) report(reader, value, "bar has no stiffness", "write \"stiffness\", \"link_stiffness\" or \"section\"");
  return first != nullptr;
}

void add_sides(Reader& reader, const Entry& bar, const AntiRollBarFields& fields,
               const std::array<BarPoints, 2>& points, ComposedParts& made) {
  const Value& value = *bar.value;
  const Vector3 left = reference_of(points[0][0]), right = reference_of(points[1][0]);
  const Vector3 middle = {(left[0] + right[0]) / 2, (left[1] + right[1]) / 2, (left[2] + right[2]) / 2};
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string suffix = fmt::format("_{}", kBarSides[side]), half = bar.written + suffix;
    const auto at = [&](const std::string& body, std::size_t point) {
      return body + "." + point_of_bar(bar, point, side);
    };
    Composed body(bar.place), joint(bar.place), rod(bar.place), axis(bar.place);
    if (fields.mass > 0)
      add_inertia(body, fields.mass / 2, middle, reference_of(points[side][0]), reference_of(points[side][1]));
    axis.add_text("from", point_of_bar(bar, 0, 1), bar.place);
    axis.add_text("to", point_of_bar(bar, 0, 0), bar.place);
    joint.add_text("type", "revolute", bar.place);
    joint.add_text("from", at(fields.body, 0), find(value, "body")->place);
    joint.add_text("to", at(half, 0), bar.place);
    joint.add("axis", std::move(axis.object));
    rod.add_text("from", at(half, 1), bar.place);
    rod.add_text("to", at(side == 0 ? fields.left : fields.right, 2), find(value, kBarSides[side])->place);
    if (fields.link_mass > 0) rod.add_number("mass", fields.link_mass);
    add_composed(reader, made.bodies, bar, suffix, std::move(body));
    add_composed(reader, made.joints, bar, suffix, std::move(joint));
    add_composed(reader, made.rods, bar, "_link" + suffix, std::move(rod));
  }
}

void compose_bar(Reader& reader, const Entry& bar, ComposedParts& made) {
  const std::size_t problems = reader.problems.size();
  const Value& value = *bar.value;
  AntiRollBarFields fields = with_defaults<AntiRollBarFields>();
  std::array<BarPoints, 2> points;
  if (!read_fields(reader, value, fields)) return;
  const bool has_bodies = check_bodies(reader, value, fields), has_stiffness = check_one_stiffness(reader, value);
  if (!has_bodies || !has_stiffness || !read_bar_points(reader, value, fields, points)) return;
  const bool is_mirrored = !fields.right_pivot && !fields.right_arm && !fields.right_link;
  const double lever = lever_of(reader, value, points, 0);
  const double other = is_mirrored ? lever : lever_of(reader, value, points, 1);
  const double distance = norm(from_to(reference_of(points[1][0]), reference_of(points[0][0])));
  double stiffness = fields.link_stiffness.value_or(0) * lever * other;
  if (fields.section) stiffness = stiffness_of_section(reader, *fields.section, distance);
  if (reader.problems.size() > problems) return;
  add_hardpoints_of_bar(reader, bar, points);
  add_sides(reader, bar, fields, points, made);
  Composed spring(bar.place);
  spring.add_text("joint", bar.written + "_left", bar.place);
  spring.add_text("relative_to", bar.written + "_right", bar.place);
  spring.add("stiffness", fields.stiffness ? *fields.stiffness : Composed::number_at(bar.place, stiffness));
  if (fields.damping) spring.add("damping", *fields.damping);
  add_composed(reader, made.of<JointSpring>(), bar, "", std::move(spring));
}

}  // namespace

void compose_bars(Reader& reader, const Entries& bars, ComposedParts& made) {
  for (const Entry& bar : bars) {
    const InScope in_scope(reader, bar.scope);
    const std::size_t problems = reader.problems.size();
    compose_bar(reader, bar, made);
    if (reader.problems.size() == problems) continue;
    // Expressions over the angles of its arms are no problems of their own.
    for (const std::string& name : {bar.name, bar.written}) reader.names.unreadable_joints.push_back(name);
  }
}

}  // namespace mbgen::reading
