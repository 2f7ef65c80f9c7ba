// Bushings: axes, freedoms, matrices.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/positions.hpp"
#include "compiler/reader/presentation.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// A bushing with axes as written, in the frame of `from`, before its freedoms are read.
struct BushingFields : Bushing {
  std::optional<Vector3> written_axis, axis2;
  const Value *tx = nullptr, *ty = nullptr, *tz = nullptr, *rx = nullptr, *ry = nullptr, *rz = nullptr;
  const Value *radial = nullptr, *conical = nullptr;  ///< tx and ty, rx and ry
  const Value *written_stiffness = nullptr, *written_damping = nullptr;
};

template <>
std::span<const Field<BushingFields>> fields<BushingFields>();
template <>
std::span<const Field<BushingFreedom>> fields<BushingFreedom>();

/// Notes on bushings with negative stiffness or damping (bushing_notes.cpp).
void note_bushings(Reader& reader);

namespace {

constexpr std::array<std::string_view, 2> kFreedomLocals = {"deflection", "rate"};

FieldInfo freedom(std::string_view name, std::string_view doc) {
  return {.name = name, .shape = Shape::object, .doc = doc, .of = "bushing_freedom"};
}

FieldInfo matrix(std::string_view name, std::string_view doc, std::string_view unit) {
  return {.name = name, .shape = Shape::six_by_six, .doc = doc, .unit = unit};
}

/// Fields of the attachment.
auto bushing_frame_fields() {
  using S = BushingFields;
  return std::array{
      field<S, &S::from>({.name = "from",
                          .shape = Shape::attachment,
                          .doc = "point of the frame with the axes of deflections",
                          .need = Need::required}),
      field<S, &S::to>({.name = "to",
                        .shape = Shape::attachment,
                        .doc = "point of the deflected frame, on another body; a distance to the point of `from` at "
                               "the reference is a deflection there",
                        .need = Need::required}),
      field<S, &S::written_axis>({.name = "axis",
                                  .shape = Shape::axis,
                                  .doc = "its axis z, in the frame of `from`; default z",
                                  .by_points = true}),
      field<S, &S::axis2>({.name = "axis2",
                           .shape = Shape::axis,
                           .doc = "direction of its axis x, likewise; its component perpendicular to `axis` is used; "
                                  "default: the next letter after `axis`, or a perpendicular of a skew one",
                           .by_points = true}),
  };
}

/// Fields of the law.
auto bushing_law_fields() {
  using S = BushingFields;
  return std::array{
      field<S, &S::radial>(freedom("radial", "common law of tx and ty, each over its own deflection")),
      field<S, &S::tx>(freedom("tx", "displacement along its axis x, m")),
      field<S, &S::ty>(freedom("ty", "displacement along its axis y, m")),
      field<S, &S::tz>(freedom("tz", "displacement along its axis z, m")),
      field<S, &S::conical>(freedom("conical", "common law of rx and ry, each over its own deflection")),
      field<S, &S::rx>(freedom("rx", "component x of the rotation vector, rad")),
      field<S, &S::ry>(freedom("ry", "component y of the rotation vector, rad")),
      field<S, &S::rz>(freedom("rz", "component z of the rotation vector, rad")),
      field<S, &S::written_stiffness>(
          matrix("stiffness", "symmetric matrix over tx, ty, tz, rx, ry, rz, six rows of six", "N/m, N or N m/rad")),
      field<S, &S::written_damping>(
          matrix("damping", "symmetric matrix over the rates, likewise", "N s/m, N s or N m s/rad")),
  };
}

}  // namespace

template <>
std::span<const Field<BushingFields>> fields<BushingFields>() {
  static const std::array table = joined(bushing_frame_fields(), bushing_law_fields());
  return table;
}

template <>
std::span<const Field<BushingFreedom>> fields<BushingFreedom>() {
  using F = BushingFreedom;
  static const std::array table = {
      field<F, &F::stiffness>({.name = "stiffness",
                               .shape = Shape::law,
                               .doc = "stiffness, or a table of N or N m over the deflection (m or rad)",
                               .unit = "N/m or N m/rad"}),
      field<F, &F::damping>({.name = "damping",
                             .shape = Shape::law,
                             .doc = "damping, or a table of N or N m over the rate (m/s or rad/s)",
                             .unit = "N s/m or N m s/rad"}),
      field<F, &F::preload>({.name = "preload",
                             .doc = "force or moment added, against positive deflections",
                             .unit = "N or N m",
                             .fallback = 0}),
      field<F, &F::force>({.name = "force",
                           .shape = Shape::force,
                           .doc = "force or moment added, against positive deflections, over `deflection` and `rate`",
                           .unit = "N or N m",
                           .locals = kFreedomLocals}),
      field<F, &F::maxwell_stiffness>(
          {.name = "maxwell_stiffness",
           .doc = "stiffness of a Maxwell branch in parallel, by which the stiffness rises with frequency",
           .unit = "N/m or N m/rad",
           .bound = Bound::not_negative}),
      field<F, &F::maxwell_time>({.name = "maxwell_time",
                                  .doc = "relaxation time of the branch: its damping over its stiffness",
                                  .unit = "s",
                                  .bound = Bound::positive}),
  };
  return table;
}
namespace {

constexpr double kMeeting = 1e-6;    ///< m: rounding of a hardpoint table in micrometres
constexpr double kRounding = 1e-12;  ///< of the largest entry of a matrix

/// Sets the axes of a bushing and their mirroring.
void place_axes(Reader& reader, const Value& value, BushingFields& bushing) {
  const std::optional<Matrix3> axes =
      placed_axes(reader, value, bushing.from.body, bushing.written_axis, bushing.axis2, "bushing");
  if (!axes) return;
  bushing.axes = *axes;
  bushing.is_mirrored = handedness(current_scope(reader).placement) < 0;
}

/// Reads a freedom from its field, or from `both`, the field common to two freedoms.
void read_freedom(Reader& reader, const Value& value, const Value* written, const char* key, const Value* both,
                  const char* both_key, std::optional<BushingFreedom>& target) {
  if (written && both) {
    report(reader, find_member(value, key)->place, fmt::format("bushing has both \"{}\" and \"{}\"", both_key, key),
           fmt::format("\"{}\" gives {} too", both_key, key));
    return;
  }
  const Value* source = written ? written : both;
  if (!source) return;
  BushingFreedom freedom = with_defaults<BushingFreedom>();
  const std::size_t problems = reader.problems.size();
  if (!read_fields(reader, *source, freedom) || reader.problems.size() > problems) return;
  if (source->members.empty())
    report(reader, *source, "freedom of a bushing has no field: leave it out to leave it free");
  if (freedom.maxwell_stiffness && !find(*source, "maxwell_time"))
    report(reader, *source, "a Maxwell branch needs \"maxwell_time\"", "its damping over its stiffness, in s");
  if (!freedom.maxwell_stiffness && find(*source, "maxwell_time"))
    report(reader, *source, "\"maxwell_time\" needs \"maxwell_stiffness\"", "the stiffness of the Maxwell branch");
  target = std::move(freedom);
}

void read_freedoms(Reader& reader, const Value& value, BushingFields& bushing) {
  const auto read = [&](std::size_t index, const Value* written, const Value* both, const char* both_key) {
    // A field common to two freedoms is read for both; its problems count once.
    const std::size_t problems = reader.problems.size();
    read_freedom(reader, value, written, kBushingFreedomNames[index].data(), both, both_key, bushing.freedoms[index]);
    return reader.problems.size() == problems;
  };
  const auto read_two = [&](std::size_t first, const Value* a, const Value* b, const Value* both, const char* key) {
    const bool sound = read(first, a, both, key);
    if (sound || !both || a || b) read(first + 1, b, both, key);
  };
  read_two(0, bushing.tx, bushing.ty, bushing.radial, "radial");
  read(2, bushing.tz, nullptr, "");
  read_two(3, bushing.rx, bushing.ry, bushing.conical, "conical");
  read(5, bushing.rz, nullptr, "");
}

std::size_t place_in_matrix(std::size_t row, std::size_t column) { return kBushingFreedoms * row + column; }

/// Reports a matrix that is not symmetric at all values of tunable parameters.
void check_symmetry(Reader& reader, const Value& value, std::string_view key, const BushingMatrix& matrix) {
  double largest = 0;
  for (const Quantity& entry : matrix) largest = std::max(largest, std::abs(entry.value));
  const auto text = [&](const Quantity& entry) {
    return entry.expression < 0 ? std::string()
                                : reader.model.expressions[static_cast<std::size_t>(entry.expression)].text;
  };
  for (std::size_t row = 0; row < kBushingFreedoms; ++row) {
    for (std::size_t column = 0; column < row; ++column) {
      const Quantity &below = matrix[place_in_matrix(row, column)], &above = matrix[place_in_matrix(column, row)];
      if (std::isnan(below.value) || std::isnan(above.value)) return;
      if (std::abs(below.value - above.value) <= kRounding * largest && text(below) == text(above)) continue;
      report(reader, value.items[row].items[column],
             fmt::format("{} of a bushing must be symmetric: {} {} and {} {} differ", key, kBushingFreedomNames[row],
                         kBushingFreedomNames[column], kBushingFreedomNames[column], kBushingFreedomNames[row]),
             "write the same number or expression on both sides of the diagonal");
      return;
    }
  }
}

void read_matrix(Reader& reader, const Value* value, std::string_view key, std::optional<BushingMatrix>& target) {
  if (!value) return;
  const auto is_six = [](const Value& list) {
    return list.kind == Value::Kind::array && list.items.size() == kBushingFreedoms;
  };
  if (!is_six(*value) || !std::all_of(value->items.begin(), value->items.end(), is_six)) {
    report(reader, *value, "must be six rows of six numbers (tx, ty, tz, rx, ry, rz), got " + describe(*value),
           "the freedoms tx to rz take their stiffness and damping by themselves too");
    return;
  }
  const FieldInfo entry{.name = key};
  BushingMatrix matrix;
  for (std::size_t row = 0; row < kBushingFreedoms; ++row)
    for (std::size_t column = 0; column < kBushingFreedoms; ++column)
      read_value(reader, value->items[row].items[column], entry, matrix[place_in_matrix(row, column)]);
  check_symmetry(reader, *value, key, matrix);
  target = std::move(matrix);
}

void read_bushings(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries)
    names_of<Bushing>(reader).emplace(entry.name, static_cast<int>(names_of<Bushing>(reader).size()));
  for (const Entry& entry : entries) {
    std::vector<BushingFields> one;
    read_list(reader, {entry}, one, [](Reader&, const Value&, const BushingFields&) {});
    BushingFields& bushing = one.front();
    const InScope in_scope(reader, entry.scope);
    const Value& value = *entry.value;
    if (value.kind == Value::Kind::object) {
      const double distance = check_ends(reader, value, bushing.from, bushing.to);
      if (distance > kMeeting)
        note(reader, find_member(value, "to")->place,
             fmt::format("the points of bushing {} are {:.4g} m apart at the reference: it is deflected there",
                         in_quotes(bushing.name), distance),
             "a bushing has no deflection where its points meet");
      place_axes(reader, value, bushing);
      read_freedoms(reader, value, bushing);
      read_matrix(reader, bushing.written_stiffness, "stiffness", bushing.stiffness);
      read_matrix(reader, bushing.written_damping, "damping", bushing.damping);
      const auto wrote = [&](std::string_view name) { return find(value, name) != nullptr; };
      if (std::none_of(kBushingFreedomNames.begin(), kBushingFreedomNames.end(), wrote) && !wrote("radial") &&
          !wrote("conical") && !wrote("stiffness") && !wrote("damping"))
        report(reader, value, "bushing has no force in any freedom",
               "give radial, tz, conical and rz, or tx to rz, or a matrix of stiffness");
    }
    reader.model.bushings.push_back(bushing);
  }
}

std::string trouble_of_bushing(const Model& model, std::size_t index) {
  const Bushing& bushing = model.bushings[index];
  bool moves = look_at_motion(model, bushing.stiffness);
  for (const std::optional<BushingFreedom>& own : bushing.freedoms) {
    if (!own) continue;
    if (own->force) return kByExpression;
    moves = moves || look_at_motion(model, own->stiffness, own->preload, own->maxwell_stiffness);
  }
  return moves ? kByMotion : "";
}

}  // namespace

ElementSection section_of(Leader<Bushing>) {
  return {"rubber and mounts: six freedoms between two bodies",
          [] {
            return std::vector<ObjectKind>{
                kind_of<BushingFields>("bushing",
                                       "compliant element of six freedoms between two frames, with equal axes at the "
                                       "reference; the forces of its fields are added"),
                kind_of<BushingFreedom>(
                    "bushing_freedom",
                    "one freedom of a bushing; its force acts against the deflection of `to`. A Maxwell branch, a "
                    "spring and a damper in series, is relaxed at the start",
                    {}, {{"maxwell_stiffness", "maxwell_time"}, {"maxwell_time", "maxwell_stiffness"}})};
          },
          read_bushings, trouble_of_bushing, note_bushings};
}

}  // namespace mbgen::reading
