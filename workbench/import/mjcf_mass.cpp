// MJCF: masses, as <inertial> gives them or of the shapes of the geoms.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "compiler/algebra/dense.hpp"
#include "compiler/algebra/turns.hpp"
#include "workbench/import/mjcf.hpp"

namespace mbgen::importing {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDensity = 1000;  // kg/m^3, MuJoCo's default

/// Mass of volume one, and the moments about the centre of mass for mass one, in the geom's axes.
struct Shape {
  double volume = 0;
  Vector3d moments = Vector3d::Zero();
};

Shape box(const Vector3d& a) {
  const Vector3d s = a.cwiseAbs2();
  return {8 * a.prod(), Vector3d(s[1] + s[2], s[0] + s[2], s[0] + s[1]) / 3};
}

Shape ellipsoid(const Vector3d& a) {
  const Vector3d s = a.cwiseAbs2();
  return {4 * kPi / 3 * a.prod(), Vector3d(s[1] + s[2], s[0] + s[2], s[0] + s[1]) / 5};
}

Shape cylinder(double radius, double half) {
  const double across = radius * radius / 4 + half * half / 3;
  return {2 * kPi * radius * radius * half, {across, across, radius * radius / 2}};
}

/// A cylinder with a half ball at each end, whose centre of mass is 3/8 of the radius beyond the cylinder's end.
Shape capsule(double radius, double half) {
  const double r2 = radius * radius;
  const double straight = 2 * kPi * r2 * half, balls = 4 * kPi / 3 * r2 * radius, volume = straight + balls;
  const double ball_across = 2 * r2 / 5 + half * half + 0.75 * half * radius;
  const double across = (straight * (r2 / 4 + half * half / 3) + balls * ball_across) / volume;
  return {volume, {across, across, (straight * r2 / 2 + balls * 2 * r2 / 5) / volume}};
}

/// Thin shells of the same outer sizes, `volume` is the area: kg/m^2 takes the place of kg/m^3, as MuJoCo has it.
Shape box_shell(const Vector3d& a) {
  // Three pairs of plates: each plate about its centre, and its distance from the centre of the box.
  Shape shell;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double area = 8 * a[j] * a[k];
    shell.volume += area;
    shell.moments[i] += area * (a[j] * a[j] + a[k] * a[k]) / 3;
    shell.moments[j] += area * (a[k] * a[k] / 3 + a[i] * a[i]);
    shell.moments[k] += area * (a[j] * a[j] / 3 + a[i] * a[i]);
  }
  shell.moments /= shell.volume;
  return shell;
}

Shape cylinder_shell(double radius, double half) {
  const double side = 4 * kPi * radius * half, caps = 2 * kPi * radius * radius, area = side + caps,
               r2 = radius * radius;
  const double across = (side * (r2 / 2 + half * half / 3) + caps * (r2 / 4 + half * half)) / area;
  return {area, {across, across, (side * r2 + caps * r2 / 2) / area}};
}

/// The half balls have their centres of mass half a radius beyond the cylinder's ends.
Shape capsule_shell(double radius, double half) {
  const double side = 4 * kPi * radius * half, balls = 4 * kPi * radius * radius, area = side + balls,
               r2 = radius * radius;
  const double ball_across = 2 * r2 / 3 + half * half + half * radius;
  const double across = (side * (r2 / 2 + half * half / 3) + balls * ball_across) / area;
  return {area, {across, across, (side * r2 + balls * 2 * r2 / 3) / area}};
}

/// Between two ellipsoids of which one is thinner by a layer of even thickness; the area by Thomsen's approximation, as
/// MuJoCo takes them.
Shape ellipsoid_shell(const Vector3d& a) {
  constexpr double kPower = 1.6075, kLayer = 1e-6;
  const auto power = [&](double x) { return std::pow(x, kPower); };
  const double mean = (power(a[0] * a[1]) + power(a[1] * a[2]) + power(a[2] * a[0])) / 3;
  const Shape outer = ellipsoid(a), inner = ellipsoid(a - Vector3d::Constant(kLayer));
  return {4 * kPi * std::pow(mean, 1 / kPower),
          (outer.volume * outer.moments - inner.volume * inner.moments) / (outer.volume - inner.volume)};
}

/// A geom that has a mass: its frame in the body and its shape.
struct Solid {
  double mass = 0;
  Isometry3d frame = Isometry3d::Identity();
  Vector3d moments = Vector3d::Zero();
};

/// The geom's shape by its type. Fails (nothing): it has no volume of its own, or a problem was added.
std::optional<Shape> shape_of(Mjcf& mjcf, const Element& geom, const std::string& type, const std::vector<double>& size,
                              bool is_shell) {
  const std::size_t needed = type == "sphere" ? 1 : type == "box" || type == "ellipsoid" ? 3 : 2;
  const bool is_positive =
      size.size() >= needed &&
      std::all_of(size.begin(), size.begin() + static_cast<std::ptrdiff_t>(needed), [](double s) { return s > 0; });
  if (!is_positive) {
    problem(mjcf.reading, geom.spot,
            fmt::format("a {} needs {} positive size{}", type, needed, needed == 1 ? "" : "s"));
    return std::nullopt;
  }
  if (is_shell) {
    if (type == "sphere") return capsule_shell(size[0], 0);
    if (type == "box") return box_shell({size[0], size[1], size[2]});
    if (type == "ellipsoid") return ellipsoid_shell({size[0], size[1], size[2]});
    return type == "cylinder" ? cylinder_shell(size[0], size[1]) : capsule_shell(size[0], size[1]);
  }
  if (type == "sphere") return ellipsoid(Vector3d::Constant(size[0]));
  if (type == "box") return box({size[0], size[1], size[2]});
  if (type == "ellipsoid") return ellipsoid({size[0], size[1], size[2]});
  return type == "cylinder" ? cylinder(size[0], size[1]) : capsule(size[0], size[1]);
}

/// Size and frame by fromto: the z axis runs between the two points.
void lay_between(Mjcf& mjcf, const Attribute& fromto, const std::string& type, std::vector<double>& size,
                 Isometry3d& frame) {
  const std::vector<double> v = numbers(mjcf.reading, fromto, 6, 6).value_or(std::vector<double>{0, 0, 0, 0, 0, 1});
  const Vector3d from(v[0], v[1], v[2]), to(v[3], v[4], v[5]);
  if ((to - from).norm() == 0) problem(mjcf.reading, fromto.spot, "fromto has zero length");
  frame.translation() = (from + to) / 2;
  frame.linear() = shortest_turn(Vector3d::UnitZ(), to - from).toRotationMatrix();
  if (size.empty()) return;
  const double half = (to - from).norm() / 2;
  size = type == "box" || type == "ellipsoid" ? std::vector<double>{size[0], size[0], half}
                                              : std::vector<double>{size[0], half};
}

std::optional<Solid> read_solid(Mjcf& mjcf, const Element& geom, const std::string& childclass, bool& has_lost) {
  static constexpr std::array<std::string_view, 5> solid_types = {"sphere", "capsule", "ellipsoid", "cylinder", "box"};
  require_class(mjcf, geom, "class");
  const bool has_mesh = inherited(mjcf, geom, childclass, "mesh") != nullptr;
  const std::string type = inherited_text(mjcf, geom, childclass, "type", has_mesh ? "mesh" : "sphere");
  const double group = inherited_number(mjcf, geom, childclass, "group", 0);
  if (group < mjcf.settings.first_group || group > mjcf.settings.last_group) return std::nullopt;
  const double given = inherited_number(mjcf, geom, childclass, "mass", -1);
  const double density = inherited_number(mjcf, geom, childclass, "density", kDensity);
  if (given == 0 || (given < 0 && density == 0)) return std::nullopt;
  if (std::find(solid_types.begin(), solid_types.end(), type) == solid_types.end() || has_mesh) {
    if (type != "plane" && type != "hfield") {
      lose(mjcf, geom.spot, "geom of a mesh: its mass is not carried over, give the body an <inertial>");
      has_lost = true;
    }
    return std::nullopt;
  }
  std::vector<double> size;
  if (const Attribute* found = inherited(mjcf, geom, childclass, "size")) {
    size = numbers(mjcf.reading, *found, 1, 3).value_or(std::vector<double>{});
  }
  Isometry3d frame = read_pose(mjcf, geom, childclass);
  if (const Attribute* fromto = inherited(mjcf, geom, childclass, "fromto"); fromto && type != "sphere") {
    lay_between(mjcf, *fromto, type, size, frame);
  }
  const std::optional<Shape> shape =
      shape_of(mjcf, geom, type, size, inherited_text(mjcf, geom, childclass, "shellinertia", "false") == "true");
  if (!shape) return std::nullopt;
  const double mass = given >= 0 ? given : density * shape->volume;
  return Solid{mass, frame, mass * shape->moments};
}

/// All the geoms of a body together.
void add_solids(const std::vector<Solid>& solids, BodyDraft& body) {
  Vector3d moment = Vector3d::Zero();
  for (const Solid& solid : solids) {
    body.mass += solid.mass;
    moment += solid.mass * solid.frame.translation();
  }
  if (body.mass == 0) return;
  body.com = moment / body.mass;
  for (const Solid& solid : solids) {
    const Vector3d d = solid.frame.translation() - body.com;
    body.inertia += solid.frame.linear() * solid.moments.asDiagonal() * solid.frame.linear().transpose();
    body.inertia += solid.mass * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
  }
}

void read_inertial(Mjcf& mjcf, const Element& inertial, BodyDraft& body) {
  const Isometry3d frame = read_pose(mjcf, inertial, "");
  if (!required_text(mjcf.reading, inertial, "mass")) return;
  body.mass = number(mjcf.reading, inertial, "mass", 0);
  body.com = frame.translation();
  Matrix3d written = Matrix3d::Zero();
  if (const Attribute* full = attribute(inertial, "fullinertia")) {
    const std::vector<double> v = numbers(mjcf.reading, *full, 6, 6).value_or(std::vector<double>(6, 0.0));
    written << v[0], v[3], v[4], v[3], v[1], v[5], v[4], v[5], v[2];
  } else if (const Attribute* diagonal = attribute(inertial, "diaginertia")) {
    const std::vector<double> v = numbers(mjcf.reading, *diagonal, 3, 3).value_or(std::vector<double>(3, 0.0));
    written = Vector3d(v[0], v[1], v[2]).asDiagonal();
  } else {
    problem(mjcf.reading, inertial.spot, "<inertial> needs diaginertia or fullinertia");
  }
  body.inertia = frame.linear() * written * frame.linear().transpose();
}

/// Changes of every inertia that <compiler> asks for.
void correct_inertia(const MjcfSettings& settings, BodyDraft& body) {
  if (settings.bound_mass > 0) body.mass = std::max(body.mass, settings.bound_mass);
  if (settings.bound_inertia <= 0 && !settings.balances_inertia) return;
  const SymmetricEigenVectors principal = symmetric_eigenvectors(body.inertia);
  const Matrix3d axes = principal.vectors;
  Vector3d moments = principal.values.cwiseMax(settings.bound_inertia);
  if (settings.balances_inertia && moments[0] + moments[1] < moments[2]) moments.setConstant(moments.mean());
  body.inertia = axes * moments.asDiagonal() * axes.transpose();
}

}  // namespace

void read_mass(Mjcf& mjcf, const Element& element, const std::string& childclass, BodyDraft& body) {
  using From = MjcfSettings::InertiaFromGeom;
  const Element* inertial = child(element, "inertial");
  const bool uses_geoms = mjcf.settings.inertia_from_geom == From::always ||
                          (mjcf.settings.inertia_from_geom == From::automatic && !inertial);
  if (uses_geoms) {
    std::vector<Solid> solids;
    bool has_lost = false;
    for_children(mjcf, element, childclass, [&](const Element& geom, const Isometry3d& frame, const std::string& name) {
      if (geom.name != "geom") return;
      std::optional<Solid> solid = read_solid(mjcf, geom, name, has_lost);
      if (!solid) return;
      solid->frame = frame * solid->frame;
      solids.push_back(*solid);
    });
    add_solids(solids, body);
    if (has_lost && body.mass == 0) mjcf.massless.push_back(body.name);
  } else if (inertial) {
    read_inertial(mjcf, *inertial, body);
  }
  correct_inertia(mjcf.settings, body);
  body.title = "body " + quoted_text(body.name);
  body.inertia_spot = (inertial ? *inertial : element).spot;
  if (body.mass < 0)
    problem(mjcf.reading, body.inertia_spot, fmt::format("{}: mass is negative, {:.6g} kg", body.title, body.mass));
}

void scale_masses(Mjcf& mjcf) {
  double mass = 0;
  for (const BodyDraft& body : mjcf.assembly.bodies) mass += body.mass;
  if (mjcf.settings.total_mass <= 0 || mass == 0) return;
  for (BodyDraft& body : mjcf.assembly.bodies) {
    body.mass *= mjcf.settings.total_mass / mass;
    body.inertia *= mjcf.settings.total_mass / mass;
  }
}

}  // namespace mbgen::importing
