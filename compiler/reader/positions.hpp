#pragma once
// Readers of positions and of axes by two points: numbers, hardpoints, points of bodies.

#include <string>

#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// Requires: parameters and inputs are read.
void read_hardpoints(Reader& reader, const Entries& entries);
/// Sets the model's list, and notes unused ones. Requires: everything is read.
void finish_hardpoints(Reader& reader);

/// A position of another scope in the axes of the current one.
Vector3Quantity position_here(Reader& reader, std::size_t scope, const Vector3Quantity& position);
/// A position given by three quantities or by the name of a hardpoint. frame: of the body for three quantities, as
/// written in the current scope; target gets coordinates in this frame.
void read_position(Reader& reader, const Value& value, const FieldInfo& info, const Pose& frame,
                   Vector3Quantity& target);
/// A hardpoint in the axes of the current scope, as constants. Reports one that depends on tunable parameters.
void read_constant_hardpoint(Reader& reader, const Value& value, Vector3& target);
/// Reports components of a position that depend on tunable parameters. what: the position, in messages.
Vector3 constant_position(Reader& reader, const Value& value, const std::string& what, const Vector3Quantity& position);
/// Index of the hardpoint of this name in the current scope, -1 with a problem.
int find_hardpoint(Reader& reader, const Value& value);
/// A hardpoint in the frame of a body.
Vector3Quantity position_on_body(Reader& reader, int hardpoint, int body);
/// The point of this name in the current scope: one of the body, or a hardpoint. Result: point -1 for none.
Attachment find_point(Reader& reader, int body, const std::string& name);
/// Positions shifted by `by`, m; numbers remain decimals as typed.
Vector3Quantity moved(Reader& reader, const Vector3Quantity& position, const Vector3& by);

// Axes by two points (axis_by_points.cpp).
/// Unit vector from one point to the other, in the axes of the current scope; the reader of the object transforms it to
/// the proper frame. Reports coinciding points.
void read_axis_by_points(Reader& reader, const Value& value, Vector3& target);
/// Transforms an axis given by two points to the frame of a body, which is the frame of axes otherwise; others are
/// unchanged. written: the axis, nullptr without one.
void turn_axis_by_points(const Reader& reader, const Value* written, int body, Vector3& axis);
/// The same for an axis in a frame rotated by `rotation` from the axes of the current scope.
void turn_axis_by_points(const Value& written, const Matrix3& rotation, Vector3& axis);

/// Axes fixed to a body, columns, GLOBAL: z by "axis", default z, and x by the part of "axis2" across it, default the
/// letter after z. owner: of the axes, in messages. Result: none with a problem.
std::optional<Matrix3> placed_axes(Reader& reader, const Value& value, int body, std::optional<Vector3> axis,
                                   std::optional<Vector3> axis2, const char* owner);

}  // namespace mbgen::reading
