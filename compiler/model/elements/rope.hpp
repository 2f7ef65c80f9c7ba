#pragma once
// Ropes and belts: elastic, without mass, through points and over pulleys, drums, cylinders and spheres.

#include <string>
#include <vector>

#include "compiler/model/elements/kind.hpp"

namespace mbgen {

/// A place that a rope passes: a point (a fixed end, or between the ends an eyelet without friction), a pulley that it
/// goes round, a drum that its end is wound on, or a cylinder or sphere that it may touch, without friction.
struct RopeStation {
  enum class Kind { point, pulley, drum, cylinder, sphere };
  /// How the rope passes a pulley: without friction, without slip, or with friction in the groove.
  enum class Contact { slides, grips, rubs };
  Kind kind = Kind::point;
  Contact contact = Contact::slides;  ///< of a pulley; a drum grips
  Attachment at;                      ///< the point, or the centre
  Vector3 axis{0, 0, 1};              ///< unit, GLOBAL axes at the reference; of pulleys, drums and cylinders
  Quantity radius;                    ///< m
  int sense = 1;                      ///< 1 where the rope runs round in the positive sense about the axis, else -1
  Quantity friction;                  ///< of a groove that rubs
  /// body whose axes directions are counted in: the one that carries the wheel, or the body of `at` itself
  int carrier = -1;
  /// rotation of the wheel about `axis` relative to the carrier: wheel_sense times a coordinate, an expression of it
  CoordinateReference wheel;
  Quantity angle;
  int wheel_sense = 1;
  // At the reference and default parameters, around which angles are counted.
  double wrap = 0;  ///< rad, with whole turns
  Vector3 arrives{0, 0, 0},
      leaves{0, 0, 0};                     ///< unit, GLOBAL axes: along the rope where it meets and leaves the circle
  Vector3 meets{0, 0, 0}, parts{0, 0, 0};  ///< m, GLOBAL axes: the tangent points

  /// Whether the tensions on both sides differ.
  bool separates() const { return kind == Kind::drum || contact != Contact::slides; }
  bool is_circle() const { return kind == Kind::pulley || kind == Kind::drum; }
  bool is_obstacle() const { return kind == Kind::cylinder || kind == Kind::sphere; }
  bool has_wheel() const { return wheel.joint >= 0; }
};

/// One span of tension of a rope: from one station that separates tensions, or an end, to the next. With stretch
/// e = length - free length, extended by the rope that comes from wheels, and k = EA / free length:
///   tension = k (max(e, 0) + damping de/dt), the part of damping between minus and plus the elastic one.
/// The first span of a rope has its path and acts for all; a rope of several spans is as many elements.
struct Rope {
  std::string name;
  Where where;
  int span = 0, spans = 1;        ///< index among the spans of its rope, their number
  std::vector<RopeStation> path;  ///< of the first span
  bool closed = false;            ///< a belt: after the last station comes the first, at which the first span begins
  std::optional<Quantity> ea;     ///< N: stiffness times length, or
  std::optional<Quantity> stiffness;  ///< N/m, of each span
  Quantity damping;                   ///< s, over stiffness
  /// m, of the whole rope off its drums at the reference, with its parts on pulleys; default: no tension there
  std::optional<Quantity> free_length;
  std::optional<Quantity> pretension;  ///< N, of all spans at the reference, in place of free_length
  /// s, in which a groove with friction comes to its limit; the reader sets it to the step of the solver
  std::optional<double> lag;

  /// Number of neighbours among the stations.
  std::size_t pieces() const { return closed ? path.size() : path.size() - 1; }
};

/// A piece of a rope from one station to the next, over an obstacle between both or straight.
struct RopeLeg {
  std::size_t from = 0, to = 0;  ///< indices into Rope::path
  int over = -1;                 ///< likewise, of an obstacle; -1: none
  int span = 0;
};

/// The pieces of a rope in its order. Requires: obstacles stand between points of an open rope.
inline std::vector<RopeLeg> legs_of(const Rope& rope) {
  std::vector<RopeLeg> legs;
  for (std::size_t i = 0; i < rope.pieces(); ++i) {
    RopeLeg leg{i, (i + 1) % rope.path.size(), -1, legs.empty() ? 0 : legs.back().span};
    if (!legs.empty() && rope.path[i].separates()) ++leg.span;
    if (rope.path[leg.to].is_obstacle()) {
      leg.over = static_cast<int>(leg.to);
      leg.to = ++i + 1;
    }
    legs.push_back(leg);
  }
  return legs;
}

/// Number of grooves of a rope with friction.
inline int rubbing_grooves(const Rope& rope) {
  int count = 0;
  for (const RopeStation& station : rope.path) count += station.contact == RopeStation::Contact::rubs ? 1 : 0;
  return count;
}

template <>
struct KindOf<Rope> : KindDefaults {
  using Element = Rope;
  static constexpr const char *key = "rope", *section = "ropes", *words = "rope";
  static constexpr bool is_elastic = true;
  static constexpr std::array quantities = {ElementQuantity{"force", "N"},      ElementQuantity{"length", "m"},
                                            ElementQuantity{"deflection", "m"}, ElementQuantity{"rate", "m/s"},
                                            ElementQuantity{"angle", "rad"},    ElementQuantity{kPotentialEnergy, "J"}};
  static constexpr const char* shows =
      "rope, or span NAME_1, NAME_2, ... of a rope with several tensions: its tension, its length, its stretch, the "
      "rate of that, the sum of its angles of wrap, or its potential energy";
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.ropes;
  }
  static Connection connection(const Rope& element) {
    ThroughPoints through;
    for (std::size_t i = 0; !element.path.empty() && i <= element.pieces(); ++i) {
      const RopeStation& station = element.path[i % element.path.size()];
      through.points.push_back(station.at);
      through.turns.push_back(station.separates() ? station.axis : Vector3{0, 0, 0});
    }
    return through;
  }
  static constexpr std::array bounds = {FieldBound{"EA", QuantityBound::positive},
                                        FieldBound{"stiffness", QuantityBound::positive},
                                        FieldBound{"damping", QuantityBound::not_negative},
                                        FieldBound{"free_length", QuantityBound::positive},
                                        FieldBound{"pretension", QuantityBound::not_negative},
                                        FieldBound{"radius", QuantityBound::positive},
                                        FieldBound{"friction", QuantityBound::not_negative}};
  template <class Use>
  static void fields(const Rope& element, const Use& use) {
    use("EA", element.ea);
    use("stiffness", element.stiffness);
    use("damping", element.damping);
    use("free_length", element.free_length);
    use("pretension", element.pretension);
    for (std::size_t i = 0; i < element.path.size(); ++i) {
      const RopeStation& station = element.path[i];
      if (station.kind == RopeStation::Kind::point) continue;
      const std::string place = "path" + std::to_string(i + 1) + ".";
      use(place + "radius", station.radius);
      if (station.kind != RopeStation::Kind::sphere) {
        use(place + "axis", station.axis);
        use(place + "sense", static_cast<double>(station.sense));
      }
      if (station.contact == RopeStation::Contact::rubs) use(place + "friction", station.friction);
      if (station.has_wheel()) use(place + "angle", station.angle);
    }
  }
  /// One for all spans.
  template <class Words>
  static std::string sentence(const Words& words, const Rope& element) {
    static constexpr const char* kKinds[] = {"", "a pulley on ", "a drum on ", "a cylinder on ", "a sphere on "};
    static constexpr const char* kContacts[] = {"", " that grips", " with friction"};
    if (element.path.empty()) return "";
    std::vector<std::string> stations, slips;
    for (const RopeStation& station : element.path)
      stations.push_back(kKinds[static_cast<int>(station.kind)] + words.body(station.at) +
                         kContacts[static_cast<int>(station.contact)]);
    states(element, [&](const HiddenState& state) { slips.push_back("x." + element.name + state.suffix); });
    std::string text = element.name + (element.closed ? " is a belt over " : " is a rope over ") + words.list(stations);
    if (element.spans > 1) text += ", with " + std::to_string(element.spans) + " tensions";
    text += ".";
    if (!slips.empty())
      text += std::string(" Its slip in grooves with friction ") + (slips.size() == 1 ? "is" : "are") + " the " +
              words.states(slips) + ".";
    return text;
  }
  /// Straight between tangent points, and along the wraps on pulleys.
  template <class Canvas>
  static void draw_lines(Canvas& canvas, const Rope& element) {
    if (element.path.empty()) return;
    for (const RopeLeg& leg : legs_of(element)) {
      const RopeStation &from = element.path[leg.from], &to = element.path[leg.to];
      canvas.line(from.carrier, from.parts, to.carrier, to.meets);
    }
    for (const RopeStation& station : element.path)
      if (station.kind == RopeStation::Kind::pulley)
        canvas.arc(station.carrier, station.at, station.axis, station.meets, station.sense * station.wrap);
  }
  static constexpr StateNature nature = StateNature::slip;
  template <class Use>
  static void states(const Rope& element, const Use& use) {
    constexpr double kSlip = 1e-3;  // m: typical slip in a groove
    for (int i = 1; i <= rubbing_grooves(element); ++i) use(HiddenState{"_slip" + std::to_string(i), kSlip});
  }
  /// By its first span: its legs, "hoist from drum.O to load.O", which may have no way; its pulleys, "hoist at load.O",
  /// off which it may lift; its spans, which may be wound up.
  template <class SomeModel>
  static void holds(const SomeModel& model, std::size_t first, std::vector<std::string>& names) {
    const Rope& rope = model.ropes[first];
    if (rope.path.empty()) return;
    const std::string own = rope.spans > 1 ? rope.name.substr(0, rope.name.size() - 2) : rope.name;  // without _1
    const auto at = [&](std::size_t station) {
      const Attachment& place = rope.path[station].at;
      const Body& body = model.bodies[static_cast<std::size_t>(place.body)];
      return body.name + "." + body.points[static_cast<std::size_t>(place.point)].name;
    };
    const std::vector<RopeLeg> legs = legs_of(rope);
    for (const RopeLeg& leg : legs) names.push_back(own + " from " + at(leg.from) + " to " + at(leg.to));
    for (const RopeLeg& leg : legs)
      if (rope.path[leg.to].kind == RopeStation::Kind::pulley) names.push_back(own + " at " + at(leg.to));
    for (int g = 0; g < rope.spans; ++g) names.push_back(model.ropes[first + static_cast<std::size_t>(g)].name);
  }
  /// Removal by a rig: almost no stiffness, since speeds of slip are ratios of stiffnesses, and no pretension.
  static void silence(Rope& element) {
    constexpr double kAlmostNone = 1e-9;  // N/m
    element.stiffness = kAlmostNone;
    element.ea.reset();
    element.pretension.reset();
  }
};

}  // namespace mbgen
