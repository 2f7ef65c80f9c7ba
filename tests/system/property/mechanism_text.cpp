#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tests/system/property/random_mechanism.hpp"
#include "tests/system/property/workshop.hpp"

namespace mbgen::testing {
namespace {

using Json = nlohmann::ordered_json;

/// Axes as the joint's type wants them.
void add_axes(const RandomJoint& joint, Json& entry) {
  static constexpr const char* kWithoutAxis[] = {"spherical", "free", "fixed", "orientation"};
  if (std::ranges::find(kWithoutAxis, joint.type) == std::end(kWithoutAxis)) entry["axis"] = joint.axis;
  if (joint.type == "universal") entry["axis2"] = across(joint.axis);
  if (joint.type == "rolling_disc" || joint.type == "knife_edge")
    entry["axis2"] = plus(across(joint.axis), times(0.3, joint.axis));
  if (joint.type == "homokinetic") entry["axis2"] = plus(joint.axis, times(0.4, across(joint.axis)));
}

/// Of an actuator: at zero that of the reference.
std::string length_over_time(const RandomLink& link) {
  const Point way = plus(link.end, times(-1, link.start));
  char text[80];
  std::snprintf(text, sizeof text, "%.17g + %.17g*sin(3*t)", std::hypot(way[0], way[1], way[2]), link.stroke);
  return text;
}

Json bushing_entry(const RandomBushing& bushing, const std::string& from, const std::string& to) {
  Json entry{{"from", from}, {"to", to}, {"axis", bushing.axis}, {"axis2", bushing.axis2}};
  static constexpr const char* kFreedoms[] = {"tx", "ty", "tz", "rx", "ry", "rz"};
  for (std::size_t i = 0; i < 6; ++i) entry[kFreedoms[i]]["stiffness"] = bushing.stiffness[i];
  return entry;
}

/// The state of a spring: it follows what expressions see of the length and its rate, and of a coordinate.
Json oil_of(const RandomLink& link) {
  char text[160];
  std::snprintf(text, sizeof text, "%.17g*(length.%s - %.17g) + %.17g*rate.%s - 3*%s_oil", link.oil, link.name.c_str(),
                kFreeLength, 0.02 * link.oil, link.name.c_str(), link.name.c_str());
  const std::string felt = link.felt.empty() ? "" : " + z." + link.felt + "*(2 - zd." + link.felt + ")";
  return {{"derivative", text + felt}, {"initial", link.oil / 50}};
}

/// Bump stops with their beginning within the reach of random states, on both sides of it.
void add_stops(const RandomMechanism& mechanism, Json& model) {
  for (const RandomLink& link : mechanism.links) {
    if (link.stop == 0) continue;
    model["bump_stops"][link.name + "_stop"] = {
        {"spring", link.name}, {"clearance", -0.01}, {"stiffness", link.stop}, {"exponent", 1.5}, {"damping", 0.1}};
    model["bump_stops"][link.name + "_rebound"] = {{"spring", link.name},
                                                   {"side", "extension"},
                                                   {"clearance", 0.005},
                                                   {"stiffness", {{"table", {{0, 0}, {0.01, link.stop / 50}}}}}};
  }
  for (const RandomJoint& joint : mechanism.joints)
    if (joint.stop > 0)
      model["bump_stops"][joint.name + "_stop"] = {{"joint", joint.name},
                                                   {"side", "below"},
                                                   {"clearance", -0.02},
                                                   {"force", "0.1*penetration*rate"},
                                                   {"stiffness", joint.stop}};
}

/// points: names of the points of both ends.
Json contact_entry(const RandomContact& contact, const std::string& from, const std::string& to) {
  static constexpr const char* kShapes[] = {"plane", "sphere", "cylinder", "cylinder", "box"};
  const Point way = plus(contact.start, times(-1, contact.end));
  const double length = std::hypot(way[0], way[1], way[2]);
  Json entry{{"from", from},           {"to", to},        {"shape", kShapes[contact.shape]},
             {"radius", 0.6 * length}, {"friction", 0.5}, {"stiction", 0.6},
             {"bristle", 2e-3},        {"lag", 0.01},     {"stribeck_velocity", 0.5},
             {"exponent", 1.5},        {"damping", 0.1},  {"stiffness", contact.stiffness}};
  if (contact.shape == 0) {
    entry["radius"] = 1.1 * length;
    entry["axis"] = times(1 / length, way);
  } else if (contact.shape < 4) {
    entry["to_radius"] = 0.5 * length;
  }
  if (contact.shape >= 2) entry["axis"] = contact.axis;
  if (contact.shape == 2) entry["length"] = 0.9 * length;
  if (contact.shape == 4) {
    entry["axis2"] = contact.axis2;
    entry["size"] = {length, 0.9 * length, 1.1 * length};
  }
  return entry;
}

/// Frictions by bristles, which bend by up to the millimetres of random states.
void add_grips(const RandomMechanism& mechanism, Json& model) {
  for (const RandomLink& link : mechanism.links)
    if (link.grip > 0)
      model["frictions"][link.name + "_grip"] = {
          {"spring", link.name},          {"normal", link.name},         {"law", "elasto_plastic"},
          {"coulomb", link.grip},         {"stiction", 1.5 * link.grip}, {"stribeck_velocity", 0.5},
          {"stiffness", 500 * link.grip}, {"damping", link.grip},        {"lag", 0.01}};
  for (const RandomJoint& joint : mechanism.joints)
    if (joint.grip > 0)
      model["frictions"][joint.name + "_grip"] = {{"joint", joint.name},
                                                  {"law", "lugre"},
                                                  {"coulomb", joint.grip},
                                                  {"stiffness", 500 * joint.grip},
                                                  {"damping", joint.grip},
                                                  {"viscous", 0.1},
                                                  {"lag", 0.01}};
}

/// Velocities of the centres of mass; the energy of springs and bushings, where no expression makes a force.
Json outputs_of(const RandomMechanism& mechanism) {
  Json outputs = Json::object();
  for (const RandomBody& body : mechanism.bodies)
    for (const char* letter : {"x", "y", "z"})
      outputs[body.name + "_v" + letter] = {{"point", body.name + ".com"}, {"quantity", "velocity"}, {"axis", letter}};
  if (!is_driven(mechanism)) outputs["stored"] = {{"elements", "all"}};
  return outputs;
}

/// points: of ground, then of each body, by their names.
Json bodies_of(const RandomMechanism& mechanism, const std::vector<Json>& points) {
  Json bodies{{"ground", {{"points", points[0]}}}};
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const RandomBody& body = mechanism.bodies[b];
    Json entry = Json::object();
    if (body.mass > 0) entry = {{"mass", body.mass}, {"com", body.com}, {"inertia", body.inertia}};
    Json named = points[b + 1];
    named["com"] = body.com;
    entry["points"] = named;
    bodies[body.name] = entry;
  }
  return bodies;
}

void add_couplings(const RandomMechanism& mechanism, Json& model) {
  for (const RandomRelation& relation : mechanism.relations) {
    Json entry{{"relation", relation.text}};
    if (!relation.points.empty()) {
      const Json curve{{"table", relation.points}, {"interpolation", "spline"}, {"periodic", relation.periodic}};
      entry = {{"joint", relation.joints[0]}, {"follows", relation.joints[1]}, {"curve", curve}};
    }
    model["couplings"][relation.name] = entry;
  }
}

}  // namespace

bool has_corners(const RandomMechanism& mechanism) {
  const auto has = [](const auto& one) { return one.stop > 0 || one.grip > 0; };
  return !mechanism.contacts.empty() || std::ranges::any_of(mechanism.links, has) ||
         std::ranges::any_of(mechanism.joints, has);
}

bool is_driven(const RandomMechanism& mechanism) {
  return has_corners(mechanism) ||
         std::ranges::any_of(mechanism.links, [](const RandomLink& link) { return link.stroke > 0 || link.oil > 0; }) ||
         std::ranges::any_of(mechanism.joints, [](const RandomJoint& joint) { return joint.swing > 0; });
}

std::string model_text(const RandomMechanism& mechanism) {
  Json model{{"mbgen", 1}, {"name", "random"}, {"gravity", mechanism.gravity}};
  Json ground = Json::object();
  std::vector<Json> points(mechanism.bodies.size() + 1, Json::object());
  const auto name_of = [&](int body) {
    return body == kOnGround ? std::string("ground") : mechanism.bodies[body].name;
  };
  const auto place = [&](const std::string& owner, const char* end, int body, const Point& at) {
    points[body + 1][owner + end] = at;
    return name_of(body) + "." + owner + end;
  };
  Json joints = Json::object(), rods = Json::object(), springs = Json::object();
  for (const RandomJoint& joint : mechanism.joints) {
    // A point on a line begins somewhere on it, a disc or ball stands on its plane.
    const Point shift = joint.type == "point_on_line" || rolls(joint.type) ? times(0.3, joint.axis) : Point{};
    Json entry{{"type", joint.type},
               {"from", place(joint.name, "_from", joint.from, joint.at)},
               {"to", place(joint.name, "_to", joint.to, plus(joint.at, shift))}};
    add_axes(joint, entry);
    if (joint.cut) entry["cut"] = true;
    joints[joint.name] = entry;
  }
  for (const RandomLink& link : mechanism.links) {
    Json entry{{"from", place(link.name, "_from", link.from, link.start)},
               {"to", place(link.name, "_to", link.to, link.end)}};
    if (link.stiffness > 0) {
      entry["stiffness"] = link.stiffness;
      entry["free_length"] = kFreeLength;
      if (link.oil > 0) {
        entry["force"] = link.name + "_oil";
        model["states"][link.name + "_oil"] = oil_of(link);
      }
      springs[link.name] = entry;
    } else {
      if (link.mass > 0) entry["mass"] = link.mass;
      if (link.stroke > 0) entry["length"] = length_over_time(link);
      rods[link.name] = entry;
    }
  }
  Json bushings = Json::object();
  for (const RandomBushing& bushing : mechanism.bushings)
    bushings[bushing.name] = bushing_entry(bushing, place(bushing.name, "_from", bushing.from, bushing.at),
                                           place(bushing.name, "_to", bushing.to, bushing.at));
  for (const RandomContact& contact : mechanism.contacts)
    model["contacts"][contact.name] = contact_entry(contact, place(contact.name, "_from", contact.from, contact.start),
                                                    place(contact.name, "_to", contact.to, contact.end));
  model["bodies"] = bodies_of(mechanism, points);
  if (!joints.empty()) model["joints"] = joints;
  if (!rods.empty()) model["rods"] = rods;
  if (!springs.empty()) model["springs"] = springs;
  if (!bushings.empty()) model["bushings"] = bushings;
  add_stops(mechanism, model);
  add_grips(mechanism, model);
  for (const RandomJoint& joint : mechanism.joints)
    if (joint.swing > 0)
      model["motions"][joint.name] = {
          {"joint", joint.name},
          {joint.type == "prismatic" ? "position" : "angle", std::to_string(joint.swing) + "*sin(3*t)"}};
  add_couplings(mechanism, model);
  if (const Json outputs = outputs_of(mechanism); !outputs.empty()) model["outputs"] = outputs;
  return model.dump(2) + "\n";
}

}  // namespace mbgen::testing
