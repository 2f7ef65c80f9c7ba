// Paths of ropes: their stations, wheels, and the geometry at the reference.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/reader/elements/rope.hpp"
#include "compiler/reader/positions.hpp"

namespace mbgen::reading {
namespace {

using Station = RopeStation;

/// In the order of RopeStation::Kind.
constexpr std::array<std::string_view, 5> kStations = {"point", "pulley", "drum", "cylinder", "sphere"};

constexpr double kTurn = 6.283185307179586;
constexpr double kMuchWrapped = 0.8 * kTurn;  ///< rad: more is probably the other side
constexpr double kRopeOnAxis = 1e-6;          ///< m: rounding of a hardpoint table in micrometres

/// Index among kStations of the place of a station, -1 with a problem for none or several.
int kind_of_station(Reader& reader, const Value& value) {
  int kind = -1;
  for (std::size_t i = 0; i < kStations.size(); ++i) {
    const Member* member = find_member(value, kStations[i]);
    if (!member) continue;
    if (kind >= 0) {
      report(reader, member->place,
             fmt::format("a station of a rope is a {} or a {}, not both", kStations[static_cast<std::size_t>(kind)],
                         kStations[i]),
             "write an object for each");
      return -1;
    }
    kind = static_cast<int>(i);
  }
  if (kind < 0)
    report(reader, value, "station of a rope has no place", "give it point, pulley, drum, cylinder or sphere");
  return kind;
}

/// Reports fields that a kind of station does not have, and missing ones.
void check_station(Reader& reader, const Value& value, const Station& station) {
  const std::string_view name = kStations[static_cast<std::size_t>(station.kind)];
  const bool is_point = station.kind == Station::Kind::point, is_sphere = station.kind == Station::Kind::sphere;
  const auto refuse_field = [&](std::string_view key, bool has) {
    if (const Member* member = find_member(value, key); member && !has)
      report(reader, member->place, fmt::format("a {} of a rope has no {}", name, in_quotes(key)), "leave it out");
  };
  const auto need = [&](std::string_view key, bool needs, const char* hint) {
    if (needs && !find(value, key))
      report(reader, value, fmt::format("a {} of a rope needs {}", name, in_quotes(key)), hint);
  };
  refuse_field("radius", !is_point);
  for (const std::string_view key : {"axis", "sense"}) refuse_field(key, !is_point && !is_sphere);
  for (const std::string_view key : {"turns", "contact", "friction"})
    refuse_field(key, station.kind == Station::Kind::pulley);
  refuse_field("joint", station.is_circle());
  need("radius", !is_point, "to the middle of the rope, in m");
  need("axis", !is_point && !is_sphere, "a letter, three numbers or two points");
  need("sense", !is_point && !is_sphere,
       "positive where the rope, followed along its path, turns about the axis as a right-handed screw, else negative");
  if (const Member* friction = find_member(value, "friction"); friction && find(value, "contact"))
    report(reader, friction->place, "a pulley of a rope has both \"contact\" and \"friction\"",
           "leave out one of them");
}

/// Whether a rotation of a joint has the direction of a wheel's axis, and goes through its centre.
bool turns_about(const Model& model, const Joint& joint, std::size_t component, const Station& station) {
  const Freedom& freedom = joint.freedoms[component];
  if (freedom.kind != FreedomKind::revolute || norm(cross(freedom.axis, station.axis)) > kRopeOnAxis) return false;
  if (joint.type == JointType::planar) return true;
  if (joint.type != JointType::revolute && joint.type != JointType::cylindrical) return false;
  const Vector3 centre = reference_position(model, station.at), pin = reference_position(model, joint.from);
  return norm(cross(freedom.axis, from_to(pin, centre))) <= kRopeOnAxis;
}

/// The joint component of a wheel: the written one, or the one that is found; whether there is one.
bool find_wheel(const Model& model, const std::vector<int>& groups, const CoordinateReference* written,
                Station& station) {
  const auto is_own = [&](const Attachment& at) {
    return at.body >= 0 &&
           groups[static_cast<std::size_t>(at.body)] == groups[static_cast<std::size_t>(station.at.body)];
  };
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    if (is_own(joint.from) == is_own(joint.to)) continue;
    for (std::size_t c = 0; c < joint.freedoms.size(); ++c) {
      const CoordinateReference coordinate{static_cast<int>(j), static_cast<int>(c)};
      if (written ? !(coordinate == *written) : !turns_about(model, joint, c, station)) continue;
      if (!turns_about(model, joint, c, station)) return false;
      const bool is_child = is_own(joint.to);
      station.wheel = coordinate;
      station.carrier = is_child ? joint.from.body : joint.to.body;
      station.wheel_sense = (dot(joint.freedoms[c].axis, station.axis) > 0) == is_child ? 1 : -1;
      return true;
    }
  }
  return false;
}

/// Gives a pulley or drum the rotation of its wheel.
void place_wheel(Reader& reader, const Value& value, const std::vector<int>& groups, RopeStationFields& station) {
  station.carrier = station.at.body;
  if (!station.is_circle() || (station.joint && station.joint->joint < 0)) return;
  const bool found = find_wheel(reader.model, groups, station.joint ? &*station.joint : nullptr, station);
  if (station.joint && !found)
    report(reader, *find(value, "joint"),
           "this coordinate does not turn the body about the axis and centre of the circle",
           "name the coordinate of its revolute, cylindrical or planar joint, or leave \"joint\" out");
  if (!found) return;
  Expression turned{"z." + coordinate_name(reader.model, station.wheel), {}};
  ExpressionNode node;
  node.kind = ExpressionNode::Kind::position;
  node.coordinate = station.wheel;
  turned.nodes.push_back(node);
  if (!station.separates()) return;
  reader.model.expressions.push_back(std::move(turned));
  station.angle.expression = static_cast<int>(reader.model.expressions.size()) - 1;
}

/// Reads one station. Result: whether it is sound.
bool read_station(Reader& reader, const Value& value, const std::vector<int>& groups, RopeStationFields& station) {
  station = with_defaults<RopeStationFields>();
  const std::size_t problems = reader.problems.size();
  if (!read_fields(reader, value, station)) return false;
  const int kind = kind_of_station(reader, value);
  if (kind < 0) return false;
  station.kind = static_cast<Station::Kind>(kind);
  const std::array places = {station.point, station.pulley, station.drum, station.cylinder, station.sphere};
  station.at = places[static_cast<std::size_t>(kind)].value_or(Attachment{});
  check_station(reader, value, station);
  if (const double turns = station.turns.value_or(0); turns != std::floor(turns))
    report(reader, *find(value, "turns"), fmt::format("must be a whole number, got {}", turns));
  if (station.at.body < 0 || station.at.point < 0 || reader.problems.size() > problems) return false;
  if (station.written_axis) {
    turn_axis_by_points(reader, find(value, "axis"), station.at.body, *station.written_axis);
    station.axis = placed_direction(reader, station.at.body, *station.written_axis);
  }
  station.radius = station.written_radius.value_or(Quantity{});
  const bool is_mirrored = handedness(current_scope(reader).placement) < 0;
  station.sense = (station.written_sense == RopeStationFields::Sense::negative) != is_mirrored ? -1 : 1;
  if (station.written_friction) {
    station.contact = Station::Contact::rubs;
    station.friction = *station.written_friction;
  } else if (station.written_contact == RopeStationFields::WrittenContact::grips) {
    station.contact = Station::Contact::grips;
  }
  place_wheel(reader, value, groups, station);
  return reader.problems.size() == problems;
}

/// Geometry of a rope at its reference: tangents of circles, see rope.hpp of the formulation.
struct RopeAtReference {
  Reader& reader;
  const Value& value;  ///< its path
  Rope& rope;

  Vector3 centre(const Station& s) const { return reference_position(reader.model, s.at); }
  static double signed_radius(const Station& s) { return s.is_circle() ? s.sense * s.radius.value : 0; }

  /// Direction of the rope at one of two circles, in its plane; zero if there is no tangent.
  static Vector3 direction(const Vector3& gap, const Vector3& axis, double offset) {
    const Vector3 across = sum(gap, axis, -dot(gap, axis));
    const double square = dot(across, across), rest = square - offset * offset;
    if (!(rest > 0)) return {0, 0, 0};
    const Vector3 along = times(across, std::sqrt(rest) / square);
    return sum(along, cross(axis, across), offset / square);
  }

  /// Sets directions and tangent points of a piece. Result: whether there is a tangent.
  bool set_piece(std::size_t i) {
    Station &a = rope.path[i % rope.path.size()], &b = rope.path[(i + 1) % rope.path.size()];
    const Vector3 gap = from_to(centre(a), centre(b));
    const double ra = signed_radius(a), rb = signed_radius(b), cosine = ra != 0 && rb != 0 ? dot(a.axis, b.axis) : 1;
    const double distance = norm(gap);
    a.parts = centre(a), b.meets = centre(b);
    a.leaves = ra != 0 ? direction(gap, a.axis, ra - cosine * rb) : times(gap, 1 / distance);
    b.arrives = rb != 0 ? direction(gap, b.axis, cosine * ra - rb) : times(gap, 1 / distance);
    if (ra != 0) a.parts = sum(a.parts, cross(a.leaves, a.axis), ra);
    if (rb != 0) b.meets = sum(b.meets, cross(b.arrives, b.axis), rb);
    return distance > kRopeOnAxis && norm(a.leaves) > 0 && norm(b.arrives) > 0;
  }

  /// Sets the wrap of a station between two pieces.
  void set_wrap(const RopeStationFields& written, Station& s) const {
    if (s.kind != Station::Kind::pulley) return;
    const double angle = std::atan2(s.sense * dot(s.axis, cross(s.arrives, s.leaves)), dot(s.arrives, s.leaves));
    s.wrap = (angle < 0 ? angle + kTurn : angle) + kTurn * written.turns.value_or(0);
  }

  /// The angle from one end of a cylinder's piece to the other, about its axis.
  void set_obstacle(std::size_t i) const {
    Station& s = rope.path[i];
    if (s.kind != Station::Kind::cylinder) return;
    const auto seen = [&](const Station& end) {
      const Vector3 gap = from_to(centre(s), centre(end));
      return sum(gap, s.axis, -dot(gap, s.axis));
    };
    const Vector3 from = seen(rope.path[i - 1]), to = seen(rope.path[i + 1]);
    const double angle = std::atan2(s.sense * dot(s.axis, cross(from, to)), dot(from, to));
    s.wrap = angle < 0 ? angle + kTurn : angle;
  }

  void set(const std::vector<RopeStationFields>& written) {
    for (std::size_t i = 0; i < rope.pieces(); ++i) {
      if (set_piece(i)) continue;
      report(reader, value.items[(i + 1) % rope.path.size()],
             fmt::format("the rope has no tangent from station {} to station {} at the reference", i + 1,
                         (i + 1) % rope.path.size() + 1),
             "the circles of its pulleys overlap, or a point lies within one: check radius, sense and places");
      return;
    }
    for (std::size_t i = 0; i < rope.path.size(); ++i) {
      set_wrap(written[i], rope.path[i]);
      set_obstacle(i);
      if (rope.path[i].kind == Station::Kind::pulley && std::fmod(rope.path[i].wrap, kTurn) > kMuchWrapped)
        note(reader, value.items[i].place,
             fmt::format("the rope goes round this pulley by {:.0f} degrees at the reference",
                         rope.path[i].wrap * 360 / kTurn),
             "with the other sense it would go by the other side");
    }
  }
};

/// Reports stations in a wrong place of the path.
void check_order(Reader& reader, const Value& value, const Rope& rope) {
  using Kind = Station::Kind;
  const std::size_t last = rope.path.size() - 1;
  bool has_wheel = false;
  for (std::size_t i = 0; i <= last; ++i) {
    const Station& s = rope.path[i];
    const bool is_end = !rope.closed && (i == 0 || i == last);
    has_wheel = has_wheel || s.kind == Kind::pulley;
    if (s.kind == Kind::drum && !is_end)
      report(reader, value.items[i], "a drum is an end of a rope", "write a pulley, or end the rope here");
    if (is_end && s.kind != Kind::drum && s.kind != Kind::point)
      report(reader, value.items[i],
             fmt::format("a rope cannot end on a {}", kStations[static_cast<std::size_t>(s.kind)]),
             "its ends are points or drums; a belt has \"closed\": true");
    const auto is_point = [&](std::size_t k) { return rope.path[k].kind == Kind::point; };
    if (s.is_obstacle() && (rope.closed || (!is_end && (!is_point(i - 1) || !is_point(i + 1)))))
      report(reader, value.items[i],
             fmt::format("a {} that a rope may touch stands between two points",
                         kStations[static_cast<std::size_t>(s.kind)]),
             "write a pulley where the rope always goes round");
  }
  if (rope.closed && !has_wheel)
    report(reader, value, "a closed rope needs a pulley", "leave \"closed\" out, or give its path pulleys");
  const auto other =
      std::ranges::find_if(rope.path, [&](const Station& s) { return s.at.body != rope.path[0].at.body; });
  if (other == rope.path.end())
    report(reader, value,
           fmt::format("all of the rope is on body {}",
                       in_quotes(reader.model.bodies[static_cast<std::size_t>(rope.path[0].at.body)].name)));
}

/// Turns a belt so that its first span begins where tensions are separated, and counts the spans.
void cut_into_spans(std::vector<RopeStationFields>& stations, Rope& rope) {
  const auto separates = [](const Station& s) { return s.separates(); };
  if (rope.closed) {
    const auto first = std::ranges::find_if(stations, separates);
    if (first != stations.end()) std::rotate(stations.begin(), first, stations.end());
    rope.spans = std::max(1, static_cast<int>(std::ranges::count_if(stations, separates)));
  } else {
    rope.spans = 1 + static_cast<int>(std::count_if(stations.begin() + 1, stations.end() - 1, separates));
  }
  rope.path.assign(stations.begin(), stations.end());
}

}  // namespace

bool read_path(Reader& reader, RopeFields& rope) {
  const Value* path = rope.written_path;
  if (!path) return false;
  if (path->kind != Value::Kind::array || path->items.size() < 2) {
    report(reader, *path, "must be a list of at least two stations, got " + describe(*path),
           "objects with point, pulley, drum, cylinder or sphere, in the order of the rope");
    return false;
  }
  const std::vector<int> groups = rigid_groups(reader.model);
  const std::size_t problems = reader.problems.size();
  std::vector<RopeStationFields> stations(path->items.size());
  bool is_sound = true;
  for (std::size_t i = 0; i < stations.size(); ++i)
    is_sound = read_station(reader, path->items[i], groups, stations[i]) && is_sound;
  if (!is_sound) return false;
  rope.path.assign(stations.begin(), stations.end());
  check_order(reader, *path, rope);
  if (reader.problems.size() > problems) return false;
  RopeAtReference{reader, *path, rope}.set(stations);
  for (std::size_t i = 0; i < stations.size(); ++i) static_cast<Station&>(stations[i]) = rope.path[i];
  cut_into_spans(stations, rope);
  return reader.problems.size() == problems;
}

}  // namespace mbgen::reading
