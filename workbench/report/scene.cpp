#include "workbench/report/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "compiler/model/vectors.hpp"
#include "workbench/report/element_pictures.hpp"
#include "workbench/report/places.hpp"

namespace mbgen {
namespace {

using Json = nlohmann::ordered_json;

/// Tyres are about so wide, in radii; the middles of twin tyres stand this far apart, in widths.
constexpr double kTyreWidth = 0.56, kTwinGap = 1.12;
/// Heavier than so many kg and lighter than so many kg/m^3 a body's box of equal mass and inertia is a hull; of steel
/// and iron it is a few thousand.
constexpr double kHullMass = 50, kHullDensity = 700;
/// Radius of a body's tubes over the largest distance of its points, and its bounds over the size of the model.
constexpr double kTube = 0.05, kThinnest = 0.0016, kThickest = 0.011;
/// Radius of the tubes between a hull and the points outside it, over the size of the model.
constexpr double kBracket = 0.0044;
/// Radii over the size of the model.
constexpr double kRod = 0.0022, kDamper = 0.0032, kSpring = 0.0075, kSpringSlimness = 0.075, kJoint = 0.0022,
                 kStop = 0.006;

/// Box around all shapes, at the reference.
Box extent_of(const Model& model) {
  Box extent;
  for (const BodyPlace& place : drawn_places(model)) {
    extent.add(to_global(model.bodies[place.body].pose, place.at), place.margin);
  }
  if (extent.is_empty()) extent.add({0, 0, 0}, 1);
  return extent;
}

double size_of(const Box& extent) {
  constexpr double kLeastSize = 1e-3;
  return std::max(kLeastSize, extent.diagonal());
}

std::string colour_text(const DisplayShape& shape) {
  return fmt::format("#{:02x}{:02x}{:02x}", shape.rgb[0], shape.rgb[1], shape.rgb[2]);
}

Json shape_json(const Model& model, const DisplayShape& shape) {
  const Vector3 from = place_of(model, shape.from);
  Json json;
  if (shape.kind == DisplayShape::Kind::sphere) {
    json = {{"kind", "sphere"}, {"at", from}, {"radius", shape.radius}};
  } else if (const Vector3 to = place_of(model, shape.to); shape.kind == DisplayShape::Kind::cylinder) {
    json = {{"kind", "cylinder"}, {"from", from}, {"to", to}, {"radius", shape.radius}};
  } else {
    Vector3 middle{}, size{};
    for (int i = 0; i < 3; ++i) {
      middle[i] = (from[i] + to[i]) / 2;
      size[i] = std::abs(to[i] - from[i]);
    }
    json = {{"kind", "box"}, {"at", middle}, {"size", size}};
  }
  if (shape.has_colour) json["colour"] = colour_text(shape);
  return json;
}

/// One tyre, or two side by side.
void add_tyres(const Model& model, const Tyre& tyre, Json& shapes) {
  const Vector3 axis = to_body_axes(model.bodies[tyre.centre.body].pose, tyre.axis);
  const Vector3 centre = place_of(model, tyre.centre);
  const double radius = tyre.radius.value, width = kTyreWidth * radius;
  const int count = std::clamp(static_cast<int>(std::lround(tyre.count)), 1, 4);
  for (int i = 0; i < count; ++i) {
    Vector3 at = centre;
    for (int k = 0; k < 3; ++k) at[k] += (i - (count - 1) / 2.0) * kTwinGap * width * axis[k];
    shapes.push_back({{"kind", "tyre"}, {"at", at}, {"axis", axis}, {"radius", radius}, {"width", width}});
  }
}

/// The box of a body's mass and inertia, where its axes are the body's and it is far lighter than metal. Result: its
/// size, 0 where there is none.
Vector3 add_hull(const Body& body, Json& shapes) {
  const double mass = body.mass.value;
  if (!(mass > kHullMass)) return {};
  Vector3 size{};
  double volume = 1;
  for (int i = 0; i < 3; ++i) {
    const double own = body.inertia[i].value;
    const double square = 6 * (body.inertia[0].value + body.inertia[1].value + body.inertia[2].value - 2 * own) / mass;
    size[i] = std::sqrt(std::max(0.0, square));
    volume *= size[i];
  }
  if (volume <= 0 || mass / volume > kHullDensity) return {};
  shapes.push_back({{"kind", "box"}, {"at", values(body.com)}, {"size", size}, {"hull", true}});
  return size;
}

/// Tubes from a body's hull to its points outside.
void add_brackets(const Body& body, const Vector3& hull, const std::set<Vector3>& points, double radius, Json& shapes) {
  for (const Vector3& point : points) {
    Vector3 nearest = values(body.com);
    for (int i = 0; i < 3; ++i) nearest[i] = std::clamp(point[i], nearest[i] - hull[i] / 2, nearest[i] + hull[i] / 2);
    if (distance(nearest, point) <= radius / 2) continue;
    shapes.push_back({{"kind", "tube"}, {"from", nearest}, {"to", point}, {"radius", radius}});
  }
}

/// Tubes from the middle of a body to its points.
void add_tubes(const Body& body, const std::set<Vector3>& points, double size, Json& shapes) {
  double largest = 0;
  for (const Vector3& a : points) {
    for (const Vector3& b : points) largest = std::max(largest, distance(a, b));
  }
  const double radius = std::clamp(kTube * largest, kThinnest * size, kThickest * size);
  const auto add = [&](const Vector3& from, const Vector3& to) {
    if (distance(from, to) > radius / 2) {
      shapes.push_back({{"kind", "tube"}, {"from", from}, {"to", to}, {"radius", radius}});
    }
  };
  if (points.size() == 2) return add(*points.begin(), *points.rbegin());
  Vector3 middle{};
  for (const Vector3& point : points) {
    for (int i = 0; i < 3; ++i) middle[i] += point[i] / static_cast<double>(points.size());
  }
  if (body.mass.value > 0) middle = values(body.com);
  for (const Vector3& point : points) add(middle, point);
  if (points.size() < 2) shapes.push_back({{"kind", "sphere"}, {"at", middle}, {"radius", 2 * kThickest * size}});
}

Json bodies_json(const Model& model, double size) {
  std::vector<std::set<Vector3>> points(model.bodies.size());
  for (const Attachment& at : attachments(model)) points[at.body].insert(place_of(model, at));
  std::vector<Json> shapes(model.bodies.size(), Json::array());
  for (const DisplayShape& shape : model.shapes) shapes[shape.from.body].push_back(shape_json(model, shape));
  for (const Tyre& tyre : model.tyres) add_tyres(model, tyre, shapes[tyre.centre.body]);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (!shapes[b].empty() || static_cast<int>(b) == model.ground) continue;
    const Vector3 hull = add_hull(model.bodies[b], shapes[b]);
    if (!shapes[b].empty()) {
      add_brackets(model.bodies[b], hull, points[b], kBracket * size, shapes[b]);
    } else if (!points[b].empty()) {
      add_tubes(model.bodies[b], points[b], size, shapes[b]);
    }
  }
  add_element_shapes(model, kThickest * size, shapes);
  Json bodies = Json::array();
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    bodies.push_back({{"name", model.bodies[b].name}, {"shapes", shapes[b]}});
  return bodies;
}

Json end_json(const Model& model, const Attachment& at) { return {at.body, place_of(model, at)}; }

/// Between two places at the reference, m, GLOBAL axes.
Vector3 way_between(const Model& model, const Attachment& from, const Attachment& to) {
  const auto global = [&](const Attachment& at) { return to_global(model.bodies[at.body].pose, place_of(model, at)); };
  return from_to(global(from), global(to));
}

/// A link as it is drawn; radius over the size of the model.
struct LinkLook {
  const char* kind;
  double radius;
};

/// Damper, spring or both by the laws that an element has, as wide as its area where it has one. length: at the
/// reference, over the size of the model.
template <class Element>
LinkLook look_of(const Element& element, double length, double size) {
  constexpr double kPi = 3.14159265358979323846;
  if constexpr (requires { std::get_if<Quantity>(&element.area); }) {
    const Quantity* area = std::get_if<Quantity>(&element.area);
    return {KindOf<Element>::key, area ? std::sqrt(area->value / kPi) / size : kSpring};
  } else if constexpr (requires { element.damping.has_value(), element.stiffness.has_value(); }) {
    const bool is_damper = element.damping.has_value(), is_spring = element.stiffness || element.force;
    return {is_damper && is_spring ? "strut"
            : is_damper            ? "damper"
                                   : "spring",
            is_spring ? std::max(kSpring, kSpringSlimness * length) : kDamper};
  } else {
    return {KindOf<Element>::key, kDamper};
  }
}

Json links_json(const Model& model, double size) {
  Json links = Json::array();
  std::set<std::array<int, 4>> taken;
  const auto add = [&](const auto& element, const LinkLook& look) {
    const Attachment &from = element.from, &to = element.to;
    // Of elements with the same ends one is seen.
    if (!taken.insert({from.body, from.point, to.body, to.point}).second) return;
    links.push_back({{"name", element.name},
                     {"kind", look.kind},
                     {"from", end_json(model, from)},
                     {"to", end_json(model, to)},
                     {"radius", look.radius * size}});
  };
  const auto add_elements = [&](bool wide) {
    each_element(model, [&]<class Element>(const Element& element) {
      if constexpr (requires { element.from, element.to; } && KindOf<Element>::drawing == Drawing::link) {
        const double length = distance({}, way_between(model, element.from, element.to)) / size;
        if (wide == requires { element.area; } && length <= kFarAway) add(element, look_of(element, length, size));
      }
    });
  };
  for (const Rod& rod : model.rods) add(rod, {"rod", kRod});
  add_elements(true);
  add_elements(false);
  add_element_lines(model, kDamper / 3 * size, links);
  return links;
}

/// Whether a joint is a thing at a place: not one that lets all go or holds directions alone, nor the length of a rod.
bool has_mark(const Model& model, const Joint& joint) {
  if (joint.type == JointType::free || joint.type == JointType::fixed || joint.type == JointType::parallel_axes ||
      joint.type == JointType::orientation)
    return false;
  return std::none_of(model.rods.begin(), model.rods.end(), [&](const Rod& rod) {
    return rod.drive >= 0 && &model.joints[static_cast<std::size_t>(rod.drive)] == &joint;
  });
}

/// The mark of an element at a place of it; axis: in the axes of its body.
template <class Element>
Json mark_json(const Model& model, const Element& element, const Attachment& at, const Vector3& axis, double radius) {
  return {{"name", element.name}, {"kind", KindOf<Element>::key}, {"body", at.body},
          {"on_ground", false},   {"at", place_of(model, at)},    {"axis", axis},
          {"radius", radius}};
}

/// Adds marks of elements with frames, then of pads.
void add_element_marks(const Model& model, double size, Json& marks) {
  each_element(model, [&](const auto& element) {
    const Connection connection = connection_of(element);
    const BetweenFrames* frames = std::get_if<BetweenFrames>(&connection);
    if (!frames) return;
    Json axes = Json::array();
    for (std::size_t k = 0; k < 3; ++k)
      axes.push_back(to_body_axes(model.bodies[frames->from.body].pose,
                                  {frames->axes[k], frames->axes[3 + k], frames->axes[6 + k]}));
    marks.push_back(mark_json(model, element, frames->from, axes[2], kJoint * size));
    marks.back()["axes"] = axes;
  });
  each_element(model, [&]<class Element>(const Element& element) {
    if constexpr (requires { KindOf<Element>::pad(element); }) {
      if (std::holds_alternative<OnCoordinate>(connection_of(element))) return;
      const Pad pad = KindOf<Element>::pad(element);
      Vector3 way = pad.axis.value_or(way_between(model, pad.at, pad.other));
      if (distance({}, way) == 0) way = {0, 0, 1};
      const Vector3 axis = to_body_axes(model.bodies[pad.at.body].pose, way);
      marks.push_back(mark_json(model, element, pad.at, axis, kStop * size));
      marks.back()["mark"] = "pad";
    }
  });
}

Json joints_json(const Model& model, double size) {
  Json joints = Json::array();
  for (const Joint& joint : model.joints) {
    if (!has_mark(model, joint)) continue;
    joints.push_back({{"name", joint.name},
                      {"kind", name_of(joint.type)},
                      {"body", joint.from.body},
                      {"on_ground", joint.from.body == model.ground || joint.to.body == model.ground},
                      {"at", place_of(model, joint.from)},
                      {"axis", to_body_axes(model.bodies[joint.from.body].pose, joint.axis)},
                      {"radius", kJoint * size}});
  }
  add_element_marks(model, size, joints);
  return joints;
}

/// The heaviest body that moves freely, for the camera to go with.
int body_to_follow(const Model& model) {
  int follow = -1;
  for (const Joint& joint : model.joints) {
    if (joint.type != JointType::free && joint.type != JointType::planar) continue;
    const int body = joint.from.body == model.ground ? joint.to.body
                     : joint.to.body == model.ground ? joint.from.body
                                                     : -1;
    if (body >= 0 && (follow < 0 || model.bodies[body].mass.value > model.bodies[follow].mass.value)) follow = body;
  }
  return follow;
}

}  // namespace

double model_size(const Model& model) { return size_of(extent_of(model)); }

Json scene_json(const Model& model) {
  const Box extent = extent_of(model);
  const double size = size_of(extent);
  const Vector3 centre = extent.centre();
  Vector3 up = values(model.gravity);
  const double gravity = std::hypot(up[0], up[1], up[2]);
  for (double& component : up) component = gravity > 0 ? -component / gravity : 0;
  if (!(gravity > 0)) up = {0, 0, 1};
  Json scene = {{"bodies", bodies_json(model, size)},
                {"links", links_json(model, size)},
                {"joints", joints_json(model, size)},
                {"up", up},
                {"road", nullptr},
                {"floor", nullptr},
                {"centre", centre},
                {"size", size},
                {"follow", body_to_follow(model)}};
  const auto flat = std::find_if(model.tyres.begin(), model.tyres.end(), [](const Tyre& t) { return t.road < 0; });
  if (flat != model.tyres.end()) {
    scene["road"] = flat->road_height.value;
  } else if (gravity > 0) {
    double lowest = 1e300;
    for (int corner = 0; corner < 8; ++corner) {
      double height = 0;
      for (int i = 0; i < 3; ++i) height += up[i] * ((corner >> i & 1) != 0 ? extent.high[i] : extent.low[i]);
      lowest = std::min(lowest, height);
    }
    scene["floor"] = lowest - 0.08 * size;
  }
  return scene;
}

}  // namespace mbgen
