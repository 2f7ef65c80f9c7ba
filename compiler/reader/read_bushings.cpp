// Bushings: axes, freedoms, matrices.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/reader/positions.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr double kMeeting = 1e-6;     ///< m: what a hardpoint table with micrometres leaves
constexpr double kLeastAngle = 1e-3;  ///< rad, between the two axes
constexpr double kRounding = 1e-12;   ///< of the largest entry of a matrix
constexpr double kCoupling = 1e-6;    ///< of freedoms of which one has no stiffness left

Vector3 unit(std::size_t index) { return {index == 0 ? 1.0 : 0.0, index == 1 ? 1.0 : 0.0, index == 2 ? 1.0 : 0.0}; }

Vector3 normalised(Vector3 vector) {
  const double length = norm(vector);
  for (double& component : vector) component /= length;
  return vector;
}

/// A direction across an axis: the letter after that of the axis, or one across a skew axis.
Vector3 across(const Vector3& axis) {
  std::size_t least = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(axis[i]) == 1) return unit((i + 1) % 3);
    if (std::abs(axis[i]) < std::abs(axis[least])) least = i;
  }
  return normalised(cross(axis, unit(least)));
}

/// The part of a direction across an axis, a unit vector.
Vector3 part_across(const Vector3& axis, const Vector3& direction) {
  Vector3 part = direction;
  const double along = dot(axis, direction);
  for (std::size_t i = 0; i < 3; ++i) part[i] -= along * axis[i];
  return normalised(part);
}

/// Sets the axes of a bushing, and whether they count mirrored.
void place_axes(Reader& reader, const Value& value, BushingFields& bushing) {
  const auto spoiled = [](const std::optional<Vector3>& axis) { return axis && std::isnan((*axis)[0]); };
  if (bushing.from.body < 0 || spoiled(bushing.written_axis) || spoiled(bushing.axis2)) return;
  if (bushing.written_axis) turn_axis_by_points(reader, find(value, "axis"), bushing.from.body, *bushing.written_axis);
  if (bushing.axis2) turn_axis_by_points(reader, find(value, "axis2"), bushing.from.body, *bushing.axis2);
  const Vector3 along = bushing.written_axis.value_or(Vector3{0, 0, 1});
  if (bushing.axis2) {
    const double angle = angle_between(along, *bushing.axis2);
    if (std::sin(angle) < kLeastAngle) {
      report(reader, *find(value, "axis2"), "\"axis2\" is along \"axis\", it must lie across it",
             "\"axis\" is the bushing's axis z, \"axis2\" its axis x");
      return;
    }
  }
  const Vector3 first = bushing.axis2 ? part_across(along, *bushing.axis2) : across(along);
  const Vector3 x = placed_direction(reader, bushing.from.body, first);
  const Vector3 z = placed_direction(reader, bushing.from.body, along);
  const Vector3 y = cross(z, x);
  Matrix3 axes{};
  for (std::size_t i = 0; i < 3; ++i) {
    axes[3 * i] = x[i];
    axes[3 * i + 1] = y[i];
    axes[3 * i + 2] = z[i];
  }
  bushing.axes = without_rest(axes);
  bushing.is_mirrored = handedness(current_scope(reader).placement) < 0;
}

/// A freedom by the field that writes it; `both` is the field that stands for two of them.
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
    // A value of two freedoms is read for both, its problems once.
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

/// Complains where an entry is not that on the other side of the diagonal, at any value of tunable parameters.
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

/// Whether a symmetric matrix with a constant part of each freedom's own has a negative value in some direction: by
/// elimination, with the largest pivots first.
bool is_negative_somewhere(const BushingMatrix& quantities, const std::array<double, kBushingFreedoms>& own) {
  std::array<double, kBushingFreedoms * kBushingFreedoms> a{};
  std::transform(quantities.begin(), quantities.end(), a.begin(), [](const Quantity& q) { return q.value; });
  const auto at = [&](std::size_t row, std::size_t column) -> double& { return a[place_in_matrix(row, column)]; };
  // Lengths and angles have other units: each freedom counts by its own stiffness.
  std::array<double, kBushingFreedoms> scale{};
  for (std::size_t i = 0; i < kBushingFreedoms; ++i) {
    at(i, i) += own[i];
    if (at(i, i) < 0) return true;
    scale[i] = at(i, i) > 0 ? 1 / std::sqrt(at(i, i)) : 0;
    for (std::size_t j = 0; j < kBushingFreedoms; ++j)
      if (at(i, i) == 0 && at(i, j) != 0) return true;
  }
  for (std::size_t i = 0; i < kBushingFreedoms; ++i)
    for (std::size_t j = 0; j < kBushingFreedoms; ++j) at(i, j) *= scale[i] * scale[j];
  std::array<bool, kBushingFreedoms> taken{};
  for (std::size_t step = 0; step < kBushingFreedoms; ++step) {
    std::size_t pivot = kBushingFreedoms;
    for (std::size_t i = 0; i < kBushingFreedoms; ++i)
      if (!taken[i] && (pivot == kBushingFreedoms || at(i, i) > at(pivot, pivot))) pivot = i;
    taken[pivot] = true;
    const bool has_pivot = at(pivot, pivot) > kRounding;
    if (at(pivot, pivot) < -kRounding) return true;
    for (std::size_t i = 0; i < kBushingFreedoms; ++i) {
      if (taken[i]) continue;
      if (!has_pivot && std::abs(at(i, pivot)) > kCoupling) return true;
      const double factor = has_pivot ? at(i, pivot) / at(pivot, pivot) : 0;
      for (std::size_t j = 0; j < kBushingFreedoms; ++j)
        if (!taken[j]) at(i, j) -= factor * at(pivot, j);
    }
  }
  return false;
}

/// The same of a bushing's matrix with what its freedoms add, where those are constants.
bool is_negative_somewhere(const Bushing& bushing, const std::optional<BushingMatrix>& matrix,
                           std::optional<Law> BushingFreedom::*law) {
  if (!matrix) return false;
  std::array<double, kBushingFreedoms> own{};
  for (std::size_t i = 0; i < kBushingFreedoms; ++i) {
    if (!bushing.freedoms[i]) continue;
    const BushingFreedom& freedom = *bushing.freedoms[i];
    const std::optional<Law>& added = freedom.*law;
    if (freedom.force || (added && std::holds_alternative<Table>(*added))) return false;
    if (added) own[i] = std::get<Quantity>(*added).value;
  }
  return is_negative_somewhere(*matrix, own);
}

/// Whether a law acts in the direction of its argument somewhere.
bool is_negative(const std::optional<Law>& law) {
  if (!law) return false;
  if (const auto* factor = std::get_if<Quantity>(&*law)) return factor->value < 0;
  const Table& table = std::get<Table>(*law);
  for (std::size_t i = 0; i < table.x.size(); ++i)
    if (table.x[i] * table.y[i] < 0) return true;
  return false;
}

}  // namespace

void read_bushings(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries)
    reader.names.bushings.emplace(entry.name, static_cast<int>(reader.names.bushings.size()));
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

void note_bushings(Reader& reader) {
  const auto add = [&](const Bushing& bushing, const std::string& message, const char* hint) {
    reader.model.notes.push_back({bushing.where, message, hint, {}});
  };
  constexpr const char* kStiffnessHint = "positive stiffness pulls back to the reference";
  constexpr const char* kDampingHint = "positive damping acts against the motion";
  for (const Bushing& bushing : reader.model.bushings) {
    const std::string name = in_quotes(bushing.name);
    for (std::size_t i = 0; i < kBushingFreedoms; ++i) {
      if (!bushing.freedoms[i]) continue;
      const std::string of = fmt::format("{} of bushing {}", kBushingFreedomNames[i], name);
      if (is_negative(bushing.freedoms[i]->stiffness))
        add(bushing, fmt::format("stiffness {} is negative: it pushes away", of), kStiffnessHint);
      if (is_negative(bushing.freedoms[i]->damping))
        add(bushing, fmt::format("damping {} is negative: it adds energy", of), kDampingHint);
    }
    if (is_negative_somewhere(bushing, bushing.stiffness, &BushingFreedom::stiffness))
      add(bushing, fmt::format("stiffness of bushing {} is negative in some direction: it pushes away", name),
          kStiffnessHint);
    if (is_negative_somewhere(bushing, bushing.damping, &BushingFreedom::damping))
      add(bushing, fmt::format("damping of bushing {} is negative in some direction: it adds energy", name),
          kDampingHint);
  }
}

}  // namespace mbgen::reading
