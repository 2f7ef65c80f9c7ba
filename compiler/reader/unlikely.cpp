// Notes on allowed values that are probably mistakes: wrong signs, units or angles.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

/// Whether a damping law is negative somewhere.
bool adds_energy(const std::optional<Law>& damping) {
  if (!damping) return false;
  if (const auto* factor = std::get_if<Quantity>(&*damping)) return factor->value < 0;
  const Table& table = std::get<Table>(*damping);
  for (std::size_t i = 0; i < table.x.size(); ++i) {
    if (table.x[i] * table.y[i] < 0) return true;
  }
  return false;
}

template <class Element>
concept HasDampingLaw = requires(Element element) {
  requires std::is_same_v<decltype(element.damping), std::optional<Law>>;
};

/// Notes elements with a damping law that adds energy.
void note_damping(Reader& reader) {
  each_element(reader.model, [&]<class Element>(const Element& element) {
    if constexpr (HasDampingLaw<std::remove_const_t<Element>>)
      if (adds_energy(element.damping))
        note_at(reader, element.where,
                fmt::format("damping of {} is negative: it adds energy", in_quotes(element.name)),
                "positive damping acts against the motion");
  });
}

constexpr const char* kDegreesHint = "angles are in rad; degrees are written { \"deg\": 40 }";

void note_start(Reader& reader) {
  const Model& model = reader.model;
  for (const InitialValue& start : model.initial.positions) {
    if (start.coordinate.joint < 0) continue;
    note_angle(reader, start.where, "initial position of " + coordinate_name(model, start.coordinate), start.coordinate,
               start.value);
  }
}

void note_motions(Reader& reader) {
  const Model& model = reader.model;
  for (const Motion& motion : model.motions) {
    if (motion.position.expression < 0)
      note_angle(reader, motion.where, fmt::format("angle of {}", in_quotes(motion.name)), motion.joint,
                 motion.position.value);
  }
}

/// A point of a body, or its centre of mass where it has mass.
struct Spot {
  int body = -1;
  std::string name;  ///< "body.point"; empty for a centre of mass
  Vector3 at{};
  double distance = 0;  ///< from the middle of all
};

double distance(const Vector3& a, const Vector3& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

std::vector<Spot> spots_of(const Model& model) {
  std::vector<Spot> spots;
  const auto add = [&](int index, std::string name, const Vector3Quantity& local) {
    const Pose& pose = model.bodies[index].pose;
    Vector3 at = rotated(pose.rotation, {local[0].value, local[1].value, local[2].value});
    for (std::size_t i = 0; i < 3; ++i) at[i] += pose.origin[i];
    if (std::isfinite(at[0] + at[1] + at[2])) spots.push_back({index, std::move(name), at});
  };
  for (int i = 0; i < static_cast<int>(model.bodies.size()); ++i) {
    if (i == model.ground) continue;  // a far point on ground stands for a force of constant direction
    const Body& body = model.bodies[i];
    for (const Point& point : body.points) add(i, body.name + "." + point.name, point.position);
    if (body.mass.value > 0) add(i, {}, body.com);
  }
  return spots;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Notes points much farther out than most. Result: the extent of the other points, m.
double note_far_points(Reader& reader) {
  constexpr double kFar = 30;
  constexpr std::size_t kFewest = 5;  // fewer have no middle
  std::vector<Spot> spots = spots_of(reader.model);
  if (spots.empty()) return 0;
  Vector3 middle{};
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<double> components;
    for (const Spot& spot : spots) components.push_back(spot.at[i]);
    middle[i] = median(components);
  }
  std::vector<double> distances;
  for (Spot& spot : spots) distances.push_back(spot.distance = distance(spot.at, middle));
  const double typical = median(distances);
  const bool has_middle = spots.size() >= kFewest && typical > 0;
  double extent = 0;
  for (const Spot& spot : spots) {
    if (!has_middle || spot.distance <= kFar * typical) {
      extent = std::max(extent, spot.distance);
      continue;
    }
    const Body& body = reader.model.bodies[spot.body];
    note_at(
        reader, body.where,
        fmt::format("{} is {:.4g} m from the middle of the model, most points are within {:.2g} m",
                    spot.name.empty() ? "centre of mass of " + in_quotes(body.name) : "point " + in_quotes(spot.name),
                    spot.distance, typical),
        "lengths are in m");
  }
  return 2 * extent;
}

/// Largest distance of a body's points from its centre of mass, m; 0 for a single point.
double reach_of(const Body& body) {
  const auto place = [](const Vector3Quantity& at) { return Vector3{at[0].value, at[1].value, at[2].value}; };
  double reach = 0;
  for (const Point& point : body.points) reach = std::max(reach, distance(place(point.position), place(body.com)));
  return body.points.size() > 1 && std::isfinite(reach) ? reach : 0;
}

/// Notes inertias with radii of gyration larger than the whole model, impossible for its bodies, or far larger than the
/// extent of the body's own points.
void note_inertias(Reader& reader, double extent) {
  constexpr double kFactor = 2;  // of a size, twice the extent of the points
  for (const Body& body : reader.model.bodies) {
    const double largest = std::max({body.inertia[0].value, body.inertia[1].value, body.inertia[2].value});
    if (!(body.mass.value > 0) || !(extent > 0)) continue;
    const double radius = std::sqrt(largest / body.mass.value), reach = reach_of(body);
    const bool is_beyond_all = radius > kFactor * extent, is_beyond_own = reach > 0 && radius > 2 * kFactor * reach;
    if (!is_beyond_all && !is_beyond_own) continue;
    const std::string than = is_beyond_all ? fmt::format("the whole model is {:.2g} m large", extent)
                                           : fmt::format("its points are within {:.2g} m of its centre of mass", reach);
    note_at(reader, body.where,
            fmt::format("inertia of {} is that of {:.4g} kg at a radius of {:.4g} m, {}", in_quotes(body.name),
                        body.mass.value, radius, than),
            "inertia is in kg m^2");
  }
}

/// Notes elements along the line between two points that coincide at the reference.
void note_ends(Reader& reader) {
  constexpr double kOnePlace = 1e-9;  // m
  each_element(reader.model, [&]<class Kind>(const Kind& element) {
    if (KindOf<Kind>::drawing == Drawing::pad) return;  // it has the ends of a spring, which is told
    const auto connection = connection_of(element);
    const BetweenPoints* line = std::get_if<BetweenPoints>(&connection);
    if (!line || line->from.body < 0 || line->to.body < 0 || line->from.point < 0 || line->to.point < 0) return;
    const double length =
        distance(reference_position(reader.model, line->from), reference_position(reader.model, line->to));
    if (!(length < kOnePlace)) return;
    note_at(reader, element.where,
            fmt::format("the ends of {} {} coincide at the reference: it has no direction there", KindOf<Kind>::words,
                        in_quotes(element.name)),
            "move one of its points, or start from positions at which they are apart");
  });
}

}  // namespace

void note_at(Reader& reader, const Where& where, std::string message, std::string hint) {
  reader.model.notes.push_back({where, std::move(message), std::move(hint), {}});
}

void note_angle(Reader& reader, const Where& where, const std::string& name, const CoordinateReference& coordinate,
                double angle) {
  if (coordinate.joint < 0 || coordinate.component < 0 || !is_rotation(reader.model, coordinate)) return;
  if (is_large_angle(angle))
    note_at(reader, where, fmt::format("{} is {:.6g} rad, more than a turn", name, angle), kDegreesHint);
}

bool is_large_angle(double angle) { return std::abs(angle) > 2 * std::numbers::pi * (1 + 1e-12); }

void note_turns(Reader& reader, const Value& value, double angle) {
  if (is_large_angle(angle))
    note(reader, value.place, fmt::format("{:.6g} rad is more than a turn", angle), kDegreesHint);
}

void note_unlikely(Reader& reader) {
  note_damping(reader);
  note_start(reader);
  each_section([&]<class Kind>(KindOf<Kind>) {
    if (const auto note = section_of(Leader<Kind>()).note) note(reader);
  });
  note_ends(reader);
  note_motions(reader);
  note_inertias(reader, note_far_points(reader));
}

}  // namespace mbgen::reading
