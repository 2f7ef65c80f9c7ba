// Contacts: shapes, law along the normal, friction.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "compiler/model/vectors.hpp"
#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/positions.hpp"
#include "compiler/reader/presentation.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"
#include "compiler/text/number.hpp"

namespace mbgen::reading {

/// A contact as written, before its surface is resolved.
struct ContactFields : SurfaceContact {
  std::optional<Attachment> written_to;
  std::optional<Shape> written_shape;
  std::optional<std::string> written_road;
  std::optional<Vector3> written_axis, axis2;
  std::optional<Vector3Quantity> written_size;
  std::optional<Quantity> to_radius, stiffness;
  std::optional<Quantity> written_stiction, written_stribeck;
  std::optional<double> modulus, exponent;
  Quantity damping;
};

template <>
std::span<const Field<ContactFields>> fields<ContactFields>();
namespace {

constexpr std::array<std::string_view, 5> kShapeWords = {"plane", "road", "sphere", "cylinder", "box"};

/// Fields of the sphere and of the surface.
auto contact_place_fields() {
  using S = ContactFields;
  return std::array{
      field<S, &S::from>(element_end("from", "centre of the sphere, or the point that touches")),
      field<S, &S::radius>({.name = "radius",
                            .doc = "of the sphere; 0: a point",
                            .unit = "m",
                            .fallback = 0,
                            .bound = Bound::not_negative}),
      field<S, &S::written_shape>({.name = "shape",
                                   .shape = Shape::word,
                                   .doc = "surface that is touched; default: road where `road` is given, else plane",
                                   .words = kShapeWords}),
      field<S, &S::written_to>(
          {.name = "to",
           .shape = Shape::attachment,
           .doc = "point of the plane, or centre of the sphere, cylinder or box, on another body"}),
      field<S, &S::written_road>({.name = "road",
                                  .shape = Shape::reference,
                                  .doc = "road that is touched; default with shape road: the only one",
                                  .of = "roads"}),
      field<S, &S::written_axis>({.name = "axis",
                                  .shape = Shape::axis,
                                  .doc = "normal of the plane, out of its body, axis of the cylinder, or axis z of the "
                                         "box, in the frame of `to`; default z",
                                  .by_points = true}),
      field<S, &S::axis2>({.name = "axis2",
                           .shape = Shape::axis,
                           .doc = "direction of axis x of the box, likewise; its component perpendicular to `axis` is "
                                  "used; default: the next letter after `axis`, or a perpendicular of a skew one",
                           .by_points = true}),
      field<S, &S::to_radius>(
          {.name = "to_radius", .doc = "of the other sphere or cylinder", .unit = "m", .bound = Bound::positive}),
      field<S, &S::length>({.name = "length",
                            .doc = "of the cylinder between its flat ends; default: infinite",
                            .unit = "m",
                            .bound = Bound::positive}),
      field<S, &S::written_size>({.name = "size",
                                  .shape = Shape::quantity_vector,
                                  .doc = "edges of the box along its axes x, y, z, about `to`",
                                  .unit = "m"}),
  };
}

/// Fields of the law along the normal.
auto contact_push_fields() {
  using S = ContactFields;
  return std::array{
      field<S, &S::stiffness>({.name = "stiffness",
                               .doc = "force over the penetration to the power of `exponent`",
                               .unit = "N/m^exponent",
                               .bound = Bound::not_negative}),
      field<S, &S::modulus>({.name = "modulus",
                             .shape = Shape::number,
                             .doc = "instead of `stiffness`: E of the contact by Hertz, 1/E = (1 - n1^2)/E1 + "
                                    "(1 - n2^2)/E2 with the moduli and Poisson's ratios of both materials; the "
                                    "stiffness is 4/3 E sqrt(R), the exponent 1.5, 1/R the sum of both curvatures",
                             .unit = "N/m^2",
                             .bound = Bound::positive}),
      field<S, &S::exponent>({.name = "exponent",
                              .shape = Shape::number,
                              .doc = "power of the penetration, at least 1; default: 1, with `modulus` 1.5"}),
      field<S, &S::damping>({.name = "damping",
                             .doc = "relative increase of the force over the rate of penetration",
                             .unit = "s/m",
                             .fallback = 0,
                             .bound = Bound::not_negative}),
  };
}

/// Fields of the friction.
auto contact_friction_fields() {
  using S = ContactFields;
  return std::array{
      field<S, &S::friction>({.name = "friction",
                              .doc = "coefficient of sliding friction; on a road times the road's own factor",
                              .unit = "1",
                              .fallback = 0,
                              .bound = Bound::not_negative}),
      field<S, &S::written_stiction>({.name = "stiction",
                                      .doc = "coefficient at the start of sliding; default: friction",
                                      .unit = "1",
                                      .bound = Bound::positive}),
      field<S, &S::written_stribeck>({.name = "stribeck_velocity",
                                      .doc = "speed over which stiction fades",
                                      .unit = "m/s",
                                      .bound = Bound::positive}),
      field<S, &S::bristle>({.name = "bristle",
                             .doc = "way by which the contact gives before it slides under the largest friction",
                             .unit = "m",
                             .fallback = 1e-4,
                             .bound = Bound::positive}),
      field<S, &S::bristle_damping>({.name = "bristle_damping",
                                     .doc = "damping of this way: over its stiffness",
                                     .unit = "s",
                                     .fallback = 1e-3,
                                     .bound = Bound::not_negative}),
      field<S, &S::elastic>({.name = "elastic",
                             .doc = "share of the way up to which nothing slides, below 1",
                             .unit = "1",
                             .fallback = 0.8,
                             .bound = Bound::not_negative}),
      field<S, &S::lag>({.name = "lag",
                         .shape = Shape::number,
                         .doc = "least time constant of the bristles; default: the step of solver",
                         .unit = "s",
                         .bound = Bound::not_negative}),
  };
}

}  // namespace

template <>
std::span<const Field<ContactFields>> fields<ContactFields>() {
  static const std::array table =
      joined(joined(contact_place_fields(), contact_push_fields()), contact_friction_fields());
  return table;
}
namespace {

/// "a plane, a cylinder or a box".
std::string shapes_with(std::initializer_list<SurfaceContact::Shape> shapes) {
  std::string words;
  for (const SurfaceContact::Shape* shape = shapes.begin(); shape != shapes.end(); ++shape)
    words += (shape == shapes.begin()     ? "a "
              : shape + 1 == shapes.end() ? " or a "
                                          : ", a ") +
             std::string(kShapeWords[static_cast<std::size_t>(*shape)]);
  return words;
}

/// Reports a field of other shapes, and a missing one. needed: by each of these shapes.
void check_field_of_shape(Reader& reader, const Value& value, const ContactFields& contact, const char* key,
                          std::initializer_list<SurfaceContact::Shape> shapes, bool needed) {
  const bool has_it = std::ranges::count(shapes, contact.shape) > 0;
  const Member* member = find_member(value, key);
  const std::string_view own = kShapeWords[static_cast<std::size_t>(contact.shape)];
  if (member && !has_it)
    report(reader, member->place,
           fmt::format("\"{}\" is of a contact with {}, not with a {}", key, shapes_with(shapes), own),
           "leave it out, or give \"shape\"");
  if (!member && has_it && needed) report(reader, value, fmt::format("a contact with a {} needs \"{}\"", own, key));
}

/// Sets the axes of the surface.
void place_surface_axes(Reader& reader, const Value& value, ContactFields& contact) {
  if (const auto axes = placed_axes(reader, value, contact.to.body, contact.written_axis, contact.axis2, "box"))
    contact.axes = *axes;
}

/// The road that is touched: the named one, or the only one.
void use_road_of_contact(Reader& reader, const Value& value, ContactFields& contact) {
  const NameMap<int>& roads = reader.names.roads;
  if (contact.written_road) {
    contact.road = find_named(reader, *find(value, "road"), "road", roads);
  } else if (roads.size() == 1) {
    contact.road = 0;
  } else {
    report(reader, value, "contact does not say which road it touches",
           roads.empty() ? "the model has none: give it \"roads\", or touch a plane of ground"
                         : fmt::format("give it \"road\", for example \"road\": \"{}\"", roads.begin()->first));
  }
  if (contact.road >= 0 && reader.model.roads[static_cast<std::size_t>(contact.road)].is_of_one_point()) {
    report(reader, member_or_object(value, "road"), "this road tells a plane below the one wheel that a host knows",
           "touch a road with heights over x and y, or a plane of ground");
    contact.road = -1;
  }
}

/// The surface that is touched.
void place_contact(Reader& reader, const Value& value, ContactFields& contact) {
  using enum SurfaceContact::Shape;
  const bool names_road = find(value, "road") != nullptr;
  contact.shape = contact.written_shape.value_or(names_road ? road : plane);
  if (find(value, "shape") && !contact.written_shape) return;
  check_field_of_shape(reader, value, contact, "road", {road}, false);
  check_field_of_shape(reader, value, contact, "to", {plane, sphere, cylinder, box}, true);
  check_field_of_shape(reader, value, contact, "axis", {plane, cylinder, box}, false);
  check_field_of_shape(reader, value, contact, "axis2", {box}, false);
  check_field_of_shape(reader, value, contact, "to_radius", {sphere, cylinder}, true);
  check_field_of_shape(reader, value, contact, "length", {cylinder}, false);
  check_field_of_shape(reader, value, contact, "size", {box}, true);
  contact.other_radius = contact.to_radius.value_or(Quantity(1.0));
  contact.size = contact.written_size.value_or(Vector3Quantity{1.0, 1.0, 1.0});
  for (const Quantity& edge : contact.size)
    if (edge.expression < 0 && !(edge.value > 0))
      report(reader, member_or_object(value, "size"), fmt::format("edges must be positive, got {}", edge.value));
  if (contact.shape == road) {
    use_road_of_contact(reader, value, contact);
    return;
  }
  contact.to = contact.written_to.value_or(Attachment{});
  check_ends(reader, value, contact.from, contact.to);
  place_surface_axes(reader, value, contact);
}

/// Stiffness by Hertz, of a sphere on a sphere or a plane; 1 with a problem.
double stiffness_by_hertz(Reader& reader, const Value& value, const ContactFields& contact) {
  const Value& modulus = *find(value, "modulus");
  if (contact.shape == SurfaceContact::Shape::cylinder) {
    report(reader, modulus, "on a cylinder the contact is no circle, and its stiffness does not follow from a modulus",
           "give \"stiffness\"");
    return 1;
  }
  const bool on_sphere = contact.shape == SurfaceContact::Shape::sphere;
  if (contact.radius.expression >= 0 || (on_sphere && contact.other_radius.expression >= 0) ||
      !(contact.radius.value > 0)) {
    report(reader, modulus, "a stiffness by \"modulus\" needs radii that are positive numbers", "give \"stiffness\"");
    return 1;
  }
  const double curvature = 1 / contact.radius.value + (on_sphere ? 1 / contact.other_radius.value : 0);
  return 4.0 / 3 * *contact.modulus / std::sqrt(curvature);
}

void set_push(Reader& reader, const Value& value, ContactFields& contact) {
  contact.push.name = contact.name;
  contact.push.where = contact.where;
  contact.push.damping = contact.damping;
  contact.push.exponent = contact.exponent.value_or(contact.modulus ? 1.5 : 1.0);
  contact.push.stiffness = contact.stiffness.value_or(Quantity(1.0));
  const Member *stiffness = find_member(value, "stiffness"), *modulus = find_member(value, "modulus");
  if (!stiffness && !modulus)
    report(reader, value, "contact has neither \"stiffness\" nor \"modulus\"",
           "stiffness: N over m to the power of exponent");
  if (stiffness && modulus)
    report(reader, modulus->place, "contact has both \"stiffness\" and \"modulus\"", "leave out one");
  if (const Member* exponent = find_member(value, "exponent"); exponent && modulus)
    report(reader, exponent->place, "the exponent by Hertz is 1.5, it is not given beside \"modulus\"");
  else if (contact.push.exponent < 1)
    report(reader, *find(value, "exponent"), fmt::format("must be at least 1, got {}", contact.push.exponent),
           "a smaller power has a stiffness without bound at the contact");
  if (contact.modulus && !std::isnan(*contact.modulus) && !stiffness)
    contact.push.stiffness = Quantity(stiffness_by_hertz(reader, value, contact));
}

void set_friction(Reader& reader, const Value& value, ContactFields& contact) {
  contact.stiction = contact.written_stiction.value_or(contact.friction);
  contact.stribeck_velocity = contact.written_stribeck.value_or(Quantity(1.0));
  if (!find(value, "friction")) {
    for (const char* key : {"stiction", "stribeck_velocity", "bristle", "bristle_damping", "elastic", "lag"})
      if (const Member* member = find_member(value, key))
        report(reader, member->place, fmt::format("\"{}\" is of a contact with friction", key),
               "leave it out, or give \"friction\"");
    return;
  }
  if (contact.elastic.value >= 1)
    report(reader, *find(value, "elastic"), fmt::format("must be below 1, got {}", contact.elastic.value));
  if (!find(value, "stiction")) {
    if (const Member* member = find_member(value, "stribeck_velocity"))
      report(reader, member->place, "\"stribeck_velocity\" is of a contact with stiction");
    return;
  }
  if (!find(value, "stribeck_velocity"))
    report(reader, value, "key \"stribeck_velocity\" is missing", "give the speed over which stiction fades");
  if (contact.stiction.value < contact.friction.value)
    report(reader, *find(value, "stiction"),
           fmt::format("stiction {} is below friction {}", contact.stiction.value, contact.friction.value));
}

void read_contacts(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries)
    names_of<SurfaceContact>(reader).emplace(entry.name, static_cast<int>(names_of<SurfaceContact>(reader).size()));
  std::vector<ContactFields> contacts;
  read_list(reader, entries, contacts, [](Reader& r, const Value& value, ContactFields& contact) {
    place_contact(r, value, contact);
    set_push(r, value, contact);
    set_friction(r, value, contact);
    r.model.contacts.push_back(contact);
  });
}

std::string trouble_of_contact(const Model& model, std::size_t index) {
  const SurfaceContact& contact = model.contacts[index];
  return look_at_motion(model, contact.push.stiffness, contact.radius, contact.other_radius, contact.length,
                        contact.size)
             ? kByMotion
             : "";
}

/// Mass that a contact stops, kg: of the lighter of both bodies; 0 where neither has one.
double stopped_mass(const Model& model, const SurfaceContact& contact) {
  double least = HUGE_VAL;
  for (const Attachment& at : {contact.from, contact.to})
    if (at.body >= 0 && model.bodies[static_cast<std::size_t>(at.body)].mass.value > 0)
      least = std::min(least, model.bodies[static_cast<std::size_t>(at.body)].mass.value);
  return std::isfinite(least) ? least : 0;
}

/// Notes contacts that swing faster under the weight of their body than the solver's step resolves.
void note_contacts(Reader& reader) {
  constexpr double kStepsOfSwing = 20;  // of a period: rk4 then errs by some 1e-4 of the energy in it
  const Model& model = reader.model;
  if (model.solver.is_implicit()) return;
  const double weight = std::hypot(model.gravity[0].value, model.gravity[1].value, model.gravity[2].value);
  for (const SurfaceContact& contact : model.contacts) {
    const Quantity& stiffness = std::get<Quantity>(*contact.push.stiffness);
    const double mass = stopped_mass(model, contact), n = contact.push.exponent;
    if (!(mass > 0) || !(stiffness.value > 0)) continue;
    const double force = mass * (weight > 0 ? weight : 1), depth = std::pow(force / stiffness.value, 1 / n);
    const double period = 2 * std::numbers::pi * std::sqrt(mass * depth / (n * force)), wanted = period / kStepsOfSwing;
    if (model.solver.step <= wanted) continue;
    note_at(
        reader, contact.where,
        fmt::format("contact {} swings at {:.4g} Hz under {:.4g} kg, a period of {:.3g} s, in which the solver makes "
                    "{:.2g} steps of {:g} s",
                    in_quotes(contact.name), 1 / period, mass, period, period / model.solver.step, model.solver.step),
        fmt::format("give \"step\" of solver as {:g}, a softer contact, or integrator rosenbrock",
                    round_number_below(wanted)));
  }
}

}  // namespace

ElementSection section_of(Leader<SurfaceContact>) {
  return {"contacts of spheres and points with planes, roads, spheres, cylinders and boxes",
          [] {
            return std::vector<ObjectKind>{kind_of<ContactFields>(
                "contact",
                "a sphere of a body that touches a surface of another body, or a road; it pushes, never "
                "pulls, and sticks or slides")};
          },
          read_contacts, trouble_of_contact, note_contacts};
}

}  // namespace mbgen::reading
