#include "workbench/start/equilibrium_causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/expressions/evaluate.hpp"
#include "compiler/model/tyres.hpp"
#include "compiler/model/vectors.hpp"
#include "runtime/generic/generic.hpp"
#include "workbench/engines/engine.hpp"

namespace mbgen {
namespace {

constexpr double kLargestRadius = 5;      // m, of a tyre of any vehicle
constexpr double kSmallestRadius = 0.01;  // m
constexpr double kOnePlace = 1e-3;        // m, between centres of tyres
constexpr double kCoincide = 1e-9;        // m
constexpr double kFalls = 0.5;            // of gravity

double distance(const Vector3& a, const Vector3& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// An attachment in poses of all bodies, global, m.
Vector3 place_in(const Model& model, const std::vector<Pose>& poses, const Attachment& at) {
  const Vector3Quantity& local =
      model.bodies[static_cast<std::size_t>(at.body)].points[static_cast<std::size_t>(at.point)].position;
  const Pose& pose = poses[static_cast<std::size_t>(at.body)];
  Vector3 place = rotated(pose.rotation, {local[0].value, local[1].value, local[2].value});
  for (std::size_t i = 0; i < 3; ++i) place[i] += pose.origin[i];
  return place;
}

bool has_lateral_force(const Tyre& tyre) {
  if (tyre.model == TyreModel::pac89) return true;
  return tyre.coefficients[tyre_field_index(tyre_fields(tyre.model), "PDY1")].value != 0;
}

/// "tyre "left" (car.json:30:5)", if the file has a line.
std::string placed(const std::string& kind, const std::string& name, const Where& where) {
  const std::string named = fmt::format("{} \"{}\"", kind, name);
  return where.line > 0 ? fmt::format("{} ({}:{}:{})", named, where.file, where.line, where.column) : named;
}

/// `radius of tyre "fl"`, with its place: in the .tir file if a note on the file says that the tyre has this number
/// from there, else in the tyre.
std::string placed_value(const Model& model, const Tyre& tyre, const char* what, const char* key, double number) {
  const std::string said = fmt::format(" is {:.6g} ", number);
  const auto tells = [&](const Diagnostic& note) {
    return note.message.starts_with(key) && note.message.find(said) != std::string::npos;
  };
  const auto note = std::find_if(model.notes.begin(), model.notes.end(), tells);
  return fmt::format("{} of {}", what, placed("tyre", tyre.name, note == model.notes.end() ? tyre.where : note->where));
}

/// Lines with the same cause for one tyre each: the first, and the number of the others.
void add_first(const std::vector<std::string>& lines, std::vector<std::string>& causes) {
  if (lines.empty()) return;
  causes.push_back(lines.front());
  if (lines.size() > 1) causes.back() += fmt::format(" (and {} more like it)", lines.size() - 1);
}

/// Whether the height of a tyre's road is one number.
bool is_flat_road(const Model& model, const Tyre& tyre) {
  if (tyre.road_height.expression >= 0) return false;
  return tyre.road < 0 || model.roads[static_cast<std::size_t>(tyre.road)].is_level();
}

/// Faults of tyres or their wheels.
void add_tyre_causes(const Model& model, std::vector<std::string>& causes) {
  double mass = 0;
  for (const Body& body : model.bodies) mass += body.mass.value;
  const double count = static_cast<double>(model.tyres.size());
  std::vector<std::string> large, soft, sideless, light;
  for (const Tyre& tyre : model.tyres) {
    const Body& wheel = model.bodies[static_cast<std::size_t>(tyre.centre.body)];
    const std::string name = placed("tyre", tyre.name, tyre.where);
    const double share = mass * std::abs(model.gravity[2].value) / count;
    if (tyre.radius.value > kLargestRadius || tyre.radius.value < kSmallestRadius) {
      large.push_back(fmt::format("{} is {:.4g} m: is it in {} see LENGTH in [UNITS] of a .tir file",
                                  placed_value(model, tyre, "radius", "UNLOADED_RADIUS", tyre.radius.value),
                                  tyre.radius.value, tyre.radius.value > kLargestRadius ? "millimetres?" : "metres?"));
    } else if (share > tyre.stiffness.value * tyre.radius.value * tyre.count) {
      soft.push_back(fmt::format("{} is {:.4g} N/m, too little for {:.4g} N, its share of the weight: is it in N/mm?",
                                 placed_value(model, tyre, "stiffness", "VERTICAL_STIFFNESS", tyre.stiffness.value),
                                 tyre.stiffness.value, share));
    }
    if (!has_lateral_force(tyre))
      sideless.push_back(
          fmt::format("{} has no lateral force, PDY1 is 0: has its .tir file a section [LATERAL]?", name));
    const bool has_inertia =
        std::any_of(wheel.inertia.begin(), wheel.inertia.end(), [](const Quantity& entry) { return entry.value != 0; });
    if (!has_inertia)
      light.push_back(
          fmt::format("{} of tyre \"{}\" has no inertia", placed("wheel", wheel.name, wheel.where), tyre.name));
  }
  for (const auto& lines : {large, soft, sideless, light}) add_first(lines, causes);
}

/// Centres of the tyres in a state, global, m.
std::vector<Vector3> tyre_centres(const Compilation& compilation, const GenericState& at) {
  const Model& model = compilation.model;
  const std::vector<Pose> poses = GenericSolver(model, compilation.topology, compilation.analysis).poses(at);
  std::vector<Vector3> centres;
  for (const Tyre& tyre : model.tyres) centres.push_back(place_in(model, poses, tyre.centre));
  return centres;
}

/// Wheels that are below a flat road.
void add_below_road(const Model& model, const std::vector<Vector3>& centres, std::vector<std::string>& causes) {
  std::vector<std::string> below;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const Tyre& tyre = model.tyres[i];
    if (!is_flat_road(model, tyre)) continue;
    const double origin = tyre.road < 0 ? 0 : model.roads[static_cast<std::size_t>(tyre.road)].origin[2];
    const double under = origin + tyre.road_height.value - centres[i][2];
    if (under > 0)
      below.push_back(
          fmt::format("the centre of {} is {:.4g} m below its road: is z down, or \"xy\" the plane of a "
                      "\"mirror\"?",
                      placed("tyre", tyre.name, tyre.where), under));
  }
  add_first(below, causes);
}

/// A centre of mass beyond the tyres, for which a vehicle tips over.
void add_overhang(const AtRest& rest, const std::vector<Vector3>& centres, std::vector<std::string>& causes) {
  constexpr std::size_t kStands = 3;  // tyres, on which a vehicle stands by itself
  const Model& model = rest.compilation.model;
  if (centres.size() < kStands) return;
  const std::vector<Pose> poses =
      GenericSolver(model, rest.compilation.topology, rest.compilation.analysis).poses(rest.start);
  double mass = 0;
  Vector3 moment{};
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    const Vector3 at = rotated(poses[i].rotation, {body.com[0].value, body.com[1].value, body.com[2].value});
    mass += body.mass.value;
    for (std::size_t k = 0; k < 3; ++k) moment[k] += body.mass.value * (poses[i].origin[k] + at[k]);
  }
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    const auto is_less = [&](const Vector3& a, const Vector3& b) { return a[axis] < b[axis]; };
    const auto [least, most] = std::minmax_element(centres.begin(), centres.end(), is_less);
    const double at = moment[axis] / mass;
    if (mass > 0 && (at < (*least)[axis] || at > (*most)[axis]))
      causes.push_back(
          fmt::format("the centre of all masses is at {0} = {1:.4g} m, the tyres are from {0} = {2:.4g} to "
                      "{3:.4g} m: it tips over",
                      axis == 0 ? "x" : "y", at, (*least)[axis], (*most)[axis]));
  }
}

/// Tyres at one place, and tyres above each other that should be left and right.
void add_places(const AtRest& rest, std::vector<std::string>& causes) {
  const Model& model = rest.compilation.model;
  if (model.tyres.empty()) return;
  const std::vector<Vector3> centres = tyre_centres(rest.compilation, rest.start);
  const std::size_t before = causes.size();
  for (std::size_t i = 0; i < centres.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Tyre &one = model.tyres[k], &other = model.tyres[i];
      if (distance(centres[i], centres[k]) > kOnePlace) continue;
      causes.push_back(
          fmt::format("{} and {} are at one place: is a \"mirror\" of an instance forgotten, or of another plane?",
                      placed("tyre", one.name, one.where), placed("tyre", other.name, other.where)));
    }
  }
  const auto is_lower = [](const Vector3& a, const Vector3& b) { return a[2] < b[2] - kOnePlace; };
  const auto low = std::min_element(centres.begin(), centres.end(), is_lower),
             high = std::max_element(centres.begin(), centres.end(), is_lower);
  const Tyre &lowest = model.tyres[static_cast<std::size_t>(low - centres.begin())],
             &highest = model.tyres[static_cast<std::size_t>(high - centres.begin())];
  if ((*high)[2] - (*low)[2] > std::abs(lowest.radius.value) + std::abs(highest.radius.value)) {
    causes.push_back(fmt::format("{} is {:.4g} m above {}: z is up, are axes swapped?",
                                 placed("tyre", highest.name, highest.where), (*high)[2] - (*low)[2],
                                 placed("tyre", lowest.name, lowest.where)));
  }
  if (causes.size() == before) add_below_road(model, centres, causes);
  if (causes.size() == before) add_overhang(rest, centres, causes);
}

std::string unit_of_force(const TreeBody& body) { return body.kind == FreedomKind::prismatic ? "N" : "N m"; }

double value_at(const AtRest& rest, const Quantity& quantity) {
  return evaluate<double>(quantity, rest.compilation.model.expressions, rest);
}

/// The coordinate that accelerates most.
const TreeBody& fastest_of(const AtRest& rest) {
  return rest.compilation.topology.bodies[static_cast<std::size_t>(rest.fastest())];
}

/// A joint force drives that coordinate.
void add_drive(const AtRest& rest, const JointForce& force, std::vector<std::string>& causes) {
  const double now = value_at(rest, force.force);
  if (now == 0 || tree_coordinate(rest.compilation.topology, force.joint) != rest.fastest()) return;
  const TreeBody& body = fastest_of(rest);
  causes.push_back(fmt::format("{} drives {} by {:.4g} {} at rest", placed("joint force", force.name, force.where),
                               body.coordinate, now, unit_of_force(body)));
}

/// Of models with tyres a force acts along the road, which nothing that rolls withstands.
void add_drive(const AtRest& rest, const AppliedForce& force, std::vector<std::string>& causes) {
  const Model& model = rest.compilation.model;
  const double along = std::hypot(value_at(rest, force.force[0]), value_at(rest, force.force[1]));
  if (model.tyres.empty() || !(along > 0)) return;
  causes.push_back(fmt::format("{} pushes body {} along the road by {:.4g} N at rest",
                               placed("force", force.name, force.where),
                               model.bodies[static_cast<std::size_t>(force.at.body)].name, along));
}

/// Forces that act at rest.
void add_drives(const AtRest& rest, std::vector<std::string>& causes) {
  each_kind([&](auto kind) {
    using Element = typename decltype(kind)::Element;
    if constexpr (requires(const Element& element) { add_drive(rest, element, causes); })
      for (const Element& element : kind.list(rest.compilation.model)) add_drive(rest, element, causes);
  });
}

/// Stick-slip frictions on the coordinate that accelerates most whose limit is below the force there.
void add_holds(const AtRest& rest, std::vector<std::string>& causes) {
  const Model& model = rest.compilation.model;
  for (const JointFriction& friction : model.frictions) {
    const auto is_fastest = [&](const CoordinateReference& joint) {
      return tree_coordinate(rest.compilation.topology, joint) == rest.fastest();
    };
    const bool is_there = is_fastest(friction.joint) || (friction.relative_to && is_fastest(*friction.relative_to));
    if (!friction.has_bristle() || !is_there) continue;
    const double holds = value_at(rest, friction.stiction);
    if (!(holds > 0)) continue;
    const char* unit = friction.normal >= 0 || friction.load >= 0 ? " per N that presses" : "";
    causes.push_back(fmt::format("{} holds {:.4g} {}{} at most", placed("friction", friction.name, friction.where),
                                 holds, unit_of_force(fastest_of(rest)), unit));
  }
}

/// Bodies that fall without support.
void add_falling(const AtRest& rest, std::vector<std::string>& causes) {
  const Model& model = rest.compilation.model;
  const Topology& topology = rest.compilation.topology;
  const double g = std::abs(model.gravity[2].value);
  for (std::size_t i = 0; i < rest.zdd.size(); ++i) {
    const TreeBody& body = topology.bodies[i];
    const double down = std::abs(body.axis[2]) * g;
    if (body.kind != FreedomKind::prismatic || !(std::abs(rest.zdd[i]) > kFalls * down) || !(down > kFalls * g))
      continue;
    const Joint& joint = model.joints[static_cast<std::size_t>(body.joint)];
    causes.push_back(fmt::format("nothing holds {} of {}: a spring, a tyre or a joint may be missing", body.coordinate,
                                 placed("joint", joint.name, joint.where)));
  }
}

}  // namespace

std::vector<std::string> coinciding_ends(const Compilation& compilation, const GenericState& at) {
  const Model& model = compilation.model;
  const std::vector<Pose> poses = GenericSolver(model, compilation.topology, compilation.analysis).poses(at);
  std::vector<std::string> result;
  each_element(model, [&]<class Kind>(const Kind& element) {
    if (KindOf<Kind>::drawing == Drawing::pad) return;  // it has the ends of a spring, which is told
    const Connection connection = connection_of(element);
    const BetweenPoints* line = std::get_if<BetweenPoints>(&connection);
    if (line && distance(place_in(model, poses, line->from), place_in(model, poses, line->to)) < kCoincide)
      result.push_back(fmt::format("the ends of {} coincide: it has no direction there",
                                   placed(KindOf<Kind>::words, element.name, element.where)));
  });
  return result;
}

std::vector<std::string> equilibrium_causes(const AtRest& rest) {
  const Model& model = rest.compilation.model;
  std::vector<std::string> causes = coinciding_ends(rest.compilation, rest.last);
  const double up = model.gravity[2].value;
  if (up > 0) causes.push_back(fmt::format("gravity points upwards, its z is {:.4g} m/s^2", up));
  const double across = std::hypot(model.gravity[0].value, model.gravity[1].value);
  if (!model.tyres.empty() && across > std::abs(up)) {
    causes.push_back(
        fmt::format("gravity is [{:.4g}, {:.4g}, {:.4g}] m/s^2, and roads are level along x and y: are axes "
                    "swapped?",
                    model.gravity[0].value, model.gravity[1].value, up));
  }
  add_tyre_causes(model, causes);
  add_places(rest, causes);
  const bool none_loaded = std::none_of(rest.loads.begin(), rest.loads.end(), [](double load) { return load > 0; });
  if (!rest.loads.empty() && none_loaded)
    causes.push_back("no tyre touches the road: see road_height and the start position");
  if (rest.zdd.empty()) return causes;
  add_drives(rest, causes);
  add_holds(rest, causes);
  if (causes.empty()) add_falling(rest, causes);
  return causes;
}

}  // namespace mbgen
