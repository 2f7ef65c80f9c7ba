// Three axes by one or two directions.
#include <fmt/format.h>

#include <cmath>

#include "compiler/model/vectors.hpp"
#include "compiler/reader/positions.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr double kLeastSine = 1e-3;  ///< between the two directions

Vector3 letter_axis(std::size_t index) {
  return {index == 0 ? 1.0 : 0.0, index == 1 ? 1.0 : 0.0, index == 2 ? 1.0 : 0.0};
}

/// A direction perpendicular to an axis: the letter after the axis's, or any for a skew axis.
Vector3 direction_across(const Vector3& axis) {
  std::size_t least = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(axis[i]) == 1) return letter_axis((i + 1) % 3);
    if (std::abs(axis[i]) < std::abs(axis[least])) least = i;
  }
  return normalised(cross(axis, letter_axis(least)));
}

/// Perpendicular component of a direction, as a unit vector.
Vector3 part_across(const Vector3& axis, const Vector3& direction) {
  return normalised(sum(direction, axis, -dot(axis, direction)));
}

}  // namespace

std::optional<Matrix3> placed_axes(Reader& reader, const Value& value, int body, std::optional<Vector3> axis,
                                   std::optional<Vector3> axis2, const char* owner) {
  const auto spoiled = [](const std::optional<Vector3>& written) { return written && std::isnan((*written)[0]); };
  if (body < 0 || spoiled(axis) || spoiled(axis2)) return {};
  if (axis) turn_axis_by_points(reader, find(value, "axis"), body, *axis);
  if (axis2) turn_axis_by_points(reader, find(value, "axis2"), body, *axis2);
  const Vector3 along = axis.value_or(Vector3{0, 0, 1});
  if (axis2 && std::sin(angle_between(along, *axis2)) < kLeastSine) {
    report(reader, *find(value, "axis2"), "\"axis2\" is along \"axis\", it must lie across it",
           fmt::format("\"axis\" is axis z of the {}, \"axis2\" its axis x", owner));
    return {};
  }
  const Vector3 first = axis2 ? part_across(along, *axis2) : direction_across(along);
  const Vector3 x = placed_direction(reader, body, first), z = placed_direction(reader, body, along), y = cross(z, x);
  Matrix3 axes{};
  for (std::size_t i = 0; i < 3; ++i) {
    axes[3 * i] = x[i];
    axes[3 * i + 1] = y[i];
    axes[3 * i + 2] = z[i];
  }
  return without_rest(axes);
}

}  // namespace mbgen::reading
