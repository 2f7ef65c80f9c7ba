// MJCF: settings, default classes and frames.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "compiler/algebra/turns.hpp"
#include "workbench/import/mjcf.hpp"

namespace mbgen::importing {
namespace {

constexpr const char* kMainClass = "main";
constexpr std::array<std::string_view, 5> kOrientations = {"quat", "axisangle", "euler", "xyaxes", "zaxis"};

bool is_true(const Element& element, std::string_view name) { return text_of(element, name) == "true"; }

/// Values of an attribute; zeros, and a problem, where it is unreadable.
std::vector<double> exactly(Mjcf& mjcf, const Attribute& attribute, std::size_t count) {
  return numbers(mjcf.reading, attribute, count, count).value_or(std::vector<double>(count, 0.0));
}

void read_compiler(Mjcf& mjcf, const Element& element) {
  MjcfSettings& settings = mjcf.settings;
  if (const Attribute* angle = attribute(element, "angle")) settings.is_in_degrees = angle->value != "radian";
  if (const Attribute* coordinate = attribute(element, "coordinate"); coordinate && coordinate->value == "global") {
    problem(mjcf.reading, coordinate->spot, "global coordinates are not read",
            "load the model in MuJoCo 2.3 or older and save it: it is written in local coordinates");
  }
  if (const Attribute* sequence = attribute(element, "eulerseq")) {
    const auto is_letter = [](char c) { return std::string_view("xyzXYZ").find(c) != std::string_view::npos; };
    const bool is_sequence =
        sequence->value.size() == 3 && std::all_of(sequence->value.begin(), sequence->value.end(), is_letter);
    if (is_sequence) {
      settings.euler_sequence = sequence->value;
    } else {
      problem(mjcf.reading, sequence->spot,
              "eulerseq takes three of x, y, z, X, Y, Z, got " + quoted_text(sequence->value));
    }
  }
  if (const Attribute* from = attribute(element, "inertiafromgeom")) {
    using From = MjcfSettings::InertiaFromGeom;
    settings.inertia_from_geom = from->value == "true"    ? From::always
                                 : from->value == "false" ? From::never
                                                          : From::automatic;
  }
  if (attribute(element, "autolimits")) settings.limits_by_range = is_true(element, "autolimits");
  if (attribute(element, "balanceinertia")) settings.balances_inertia = is_true(element, "balanceinertia");
  settings.bound_mass = number(mjcf.reading, element, "boundmass", settings.bound_mass);
  settings.bound_inertia = number(mjcf.reading, element, "boundinertia", settings.bound_inertia);
  settings.total_mass = number(mjcf.reading, element, "settotalmass", settings.total_mass);
  if (const Attribute* range = attribute(element, "inertiagrouprange")) {
    const std::vector<double> groups = exactly(mjcf, *range, 2);
    settings.first_group = groups[0];
    settings.last_group = groups[1];
  }
}

/// Removes parts disabled by <flag> from the model.
void read_flags(Mjcf& mjcf, const Element& flags) {
  MjcfSettings& settings = mjcf.settings;
  for (const Attribute& flag : flags.attributes) {
    if (flag.value != "disable") continue;
    const bool is_any = flag.name == "constraint";
    std::string lost;
    const auto leave_out = [&](bool& has, std::string_view name) {
      has = false;
      lost += fmt::format("{}{}", lost.empty() ? "" : ", ", name);
    };
    if (flag.name == "gravity") mjcf.assembly.gravity.setZero();
    if (flag.name == "passive" || flag.name == "spring") leave_out(settings.has_springs, "springs");
    if (flag.name == "passive" || flag.name == "damper") leave_out(settings.has_dampers, "dampers");
    if (is_any || flag.name == "equality") leave_out(settings.has_equalities, "equalities");
    if (is_any || flag.name == "frictionloss") leave_out(settings.has_friction, "friction");
    if (flag.name == "actuation") leave_out(settings.has_actuators, "actuators");
    if (!lost.empty())
      note(mjcf.reading, flag.spot, fmt::format("flag {}=\"disable\": {} are left out of the model", flag.name, lost));
  }
}

void read_option(Mjcf& mjcf, const Element& element) {
  if (const Attribute* gravity = attribute(element, "gravity")) {
    const std::vector<double> g = exactly(mjcf, *gravity, 3);
    mjcf.assembly.gravity = {g[0], g[1], g[2]};
  }
  if (const Attribute* step = attribute(element, "timestep")) {
    mjcf.assembly.step = exactly(mjcf, *step, 1)[0];
    if (!(mjcf.assembly.step > 0)) problem(mjcf.reading, step->spot, "timestep must be positive");
  }
  for (const char* name : {"density", "viscosity", "wind"}) {
    if (const Attribute* medium = attribute(element, name)) {
      note(mjcf.reading, medium->spot, fmt::format("{} is not carried over: there are no forces of a medium", name));
    }
  }
  if (const Element* flags = child(element, "flag")) read_flags(mjcf, *flags);
}

void read_class(Mjcf& mjcf, const Element& element, const std::string& parent) {
  const bool is_top = parent.empty();
  const Attribute* named = attribute(element, "class");
  if (!named && !is_top) {
    problem(mjcf.reading, element.spot, "a <default> inside another needs a class");
    return;
  }
  const std::string name = named ? named->value : kMainClass;
  MjcfClass& filled = mjcf.classes[name];
  // The top class is also known by its own name and by the common parent's name.
  filled.parent = is_top && name != kMainClass ? kMainClass : parent;
  // As in MuJoCo: a class inside takes over the class around it, and nothing that is added to that one later.
  const std::string written = is_top ? kMainClass : name;
  for (const Element& inner : element.children)
    if (inner.name != "default") mjcf.classes[written].elements.push_back(&inner);
  for (const Element& inner : element.children) {
    if (inner.name != "default") continue;
    read_class(mjcf, inner, written);
    if (const Attribute* inside = attribute(inner, "class"); inside && mjcf.classes.contains(inside->value))
      mjcf.classes[inside->value].taken_over = mjcf.classes[written].elements.size();
  }
}

/// The element itself, then the elements of this name in its classes, the nearest first.
std::vector<const Element*> chain(const Mjcf& mjcf, const Element& element, const std::string& childclass,
                                  std::string_view as = {}) {
  const std::string_view name = as.empty() ? element.name : as;
  return with_defaults(mjcf, element, childclass, [&](std::string_view other) { return other == name; });
}

Eigen::Quaterniond euler(const Mjcf& mjcf, const std::vector<double>& angles) {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  for (std::size_t i = 0; i < 3; ++i) {
    const char letter = mjcf.settings.euler_sequence[i];
    const bool is_fixed = letter < 'a';
    const Vector3d axis = Vector3d::Unit((is_fixed ? letter - 'X' : letter - 'x'));
    const double angle = angles[i] * (mjcf.settings.is_in_degrees ? std::numbers::pi / 180 : 1.0);
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, axis));
    rotation = is_fixed ? turn * rotation : rotation * turn;
  }
  return rotation;
}

Matrix3d from_axes(Vector3d x, Vector3d y) {
  x.normalize();
  y -= x * x.dot(y);
  y.normalize();
  Matrix3d rotation;
  rotation << x, y, x.cross(y);
  return rotation;
}

Matrix3d read_rotation(Mjcf& mjcf, const Attribute& attribute) {
  const std::size_t count = attribute.name == "xyaxes"                                  ? 6
                            : attribute.name == "quat" || attribute.name == "axisangle" ? 4
                                                                                        : 3;
  const std::vector<double> v = exactly(mjcf, attribute, count);
  if (attribute.name == "euler") return euler(mjcf, v).toRotationMatrix();
  const Vector3d first(v[0], v[1], v[2]);
  const bool is_nothing = attribute.name == "quat" ? first.norm() + std::abs(v[3]) == 0 : first.norm() == 0;
  const bool is_flat = attribute.name == "xyaxes" && first.cross(Vector3d(v[3], v[4], v[5])).norm() == 0;
  if (is_nothing || is_flat) {
    problem(mjcf.reading, attribute.spot, attribute.name + " gives no orientation");
    return Matrix3d::Identity();
  }
  if (attribute.name == "quat") return Eigen::Quaterniond(v[0], v[1], v[2], v[3]).normalized().toRotationMatrix();
  if (attribute.name == "xyaxes") return from_axes(first, {v[3], v[4], v[5]});
  if (attribute.name == "zaxis") return shortest_turn(Vector3d::UnitZ(), first).toRotationMatrix();
  const double angle = v[3] * (mjcf.settings.is_in_degrees ? std::numbers::pi / 180 : 1.0);
  return Eigen::AngleAxisd(angle, first.normalized()).toRotationMatrix();
}

}  // namespace

void lose(Mjcf& mjcf, Spot spot, const std::string& text) {
  MjcfLoss& loss = mjcf.losses[text];
  if (loss.count++ == 0) loss.first = spot;
}

void read_settings(Mjcf& mjcf, const Element& root) {
  mjcf.classes[kMainClass];
  for (const Element& section : root.children) {
    if (section.name == "compiler") read_compiler(mjcf, section);
    if (section.name == "option") read_option(mjcf, section);
    if (section.name == "default") read_class(mjcf, section, "");
  }
}

std::vector<const Element*> with_defaults(const Mjcf& mjcf, const Element& element, const std::string& childclass,
                                          const std::function<bool(std::string_view)>& is_shared) {
  std::vector<const Element*> elements = {&element};
  const Attribute* own = attribute(element, "class");
  std::string name = own ? own->value : childclass.empty() ? kMainClass : childclass;
  std::size_t count = kAll;  // of elements in the next class
  for (std::size_t depth = 0; !name.empty() && depth <= mjcf.classes.size(); ++depth) {
    const auto found = mjcf.classes.find(name);
    if (found == mjcf.classes.end()) break;
    const MjcfClass& settings = found->second;
    for (std::size_t i = std::min(settings.elements.size(), count); i-- > 0;)
      if (is_shared(settings.elements[i]->name)) elements.push_back(settings.elements[i]);
    count = settings.taken_over;
    name = settings.parent;
  }
  return elements;
}

const Attribute* inherited(const Mjcf& mjcf, const Element& element, const std::string& childclass,
                           std::string_view name) {
  for (const Element* candidate : chain(mjcf, element, childclass)) {
    if (const Attribute* found = attribute(*candidate, name)) return found;
  }
  return nullptr;
}

const Attribute* inherited_as(const Mjcf& mjcf, const Element& element, std::string_view as, std::string_view name) {
  for (const Element* candidate : chain(mjcf, element, "", as)) {
    if (const Attribute* found = attribute(*candidate, name)) return found;
  }
  return nullptr;
}

double inherited_number(Mjcf& mjcf, const Element& element, const std::string& childclass, std::string_view name,
                        double fallback) {
  const Attribute* found = inherited(mjcf, element, childclass, name);
  return found ? exactly(mjcf, *found, 1)[0] : fallback;
}

Vector3d inherited_vector(Mjcf& mjcf, const Element& element, const std::string& childclass, std::string_view name,
                          const Vector3d& fallback) {
  const Attribute* found = inherited(mjcf, element, childclass, name);
  if (!found) return fallback;
  const std::vector<double> v = exactly(mjcf, *found, 3);
  return {v[0], v[1], v[2]};
}

std::string inherited_text(const Mjcf& mjcf, const Element& element, const std::string& childclass,
                           std::string_view name, std::string_view fallback) {
  const Attribute* found = inherited(mjcf, element, childclass, name);
  return std::string(found ? std::string_view(found->value) : fallback);
}

void require_class(Mjcf& mjcf, const Element& element, std::string_view attribute_name) {
  const Attribute* named = attribute(element, attribute_name);
  if (!named || mjcf.classes.contains(named->value)) return;
  problem(mjcf.reading, named->spot, "no default class is named " + quoted_text(named->value));
}

Isometry3d read_pose(Mjcf& mjcf, const Element& element, const std::string& childclass) {
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() = inherited_vector(mjcf, element, childclass, "pos", Vector3d::Zero());
  // An orientation of the element overrides one of another kind in its class.
  for (const Element* candidate : chain(mjcf, element, childclass)) {
    for (const std::string_view name : kOrientations) {
      if (const Attribute* found = attribute(*candidate, name)) {
        pose.linear() = read_rotation(mjcf, *found);
        return pose;
      }
    }
  }
  return pose;
}

void for_children(Mjcf& mjcf, const Element& body, const std::string& childclass, const VisitChild& visit) {
  for (const Element& inner : body.children) {
    if (inner.name != "frame") {
      visit(inner, Isometry3d::Identity(), childclass);
      continue;
    }
    require_class(mjcf, inner, "childclass");
    const Attribute* own = attribute(inner, "childclass");
    const Isometry3d frame = read_pose(mjcf, inner, childclass);
    for_children(mjcf, inner, own ? own->value : childclass,
                 [&](const Element& element, const Isometry3d& inside, const std::string& name) {
                   visit(element, frame * inside, name);
                 });
  }
}

}  // namespace mbgen::importing
