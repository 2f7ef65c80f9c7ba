#pragma once
// Readers of positions and of axes by two points: numbers, hardpoints, points of bodies.

#include <string>

#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// Requires: parameters and inputs are read.
void read_hardpoints(Reader& reader, const Entries& entries);
/// Gives the model its list, and notes those that nothing uses. Requires: everything is read.
void finish_hardpoints(Reader& reader);

/// A position of another scope in the axes of the current one.
Vector3Quantity position_here(Reader& reader, std::size_t scope, const Vector3Quantity& position);
/// A position that stands as three quantities or as the name of a hardpoint. frame: of the body whose coordinates three
/// quantities are in, as the current scope writes it; target gets those coordinates.
void read_position(Reader& reader, const Value& value, const FieldInfo& info, const Pose& frame,
                   Vector3Quantity& target);
/// A hardpoint in the axes of the current scope, as constants. Complains where it follows from tunable parameters.
void read_constant_hardpoint(Reader& reader, const Value& value, Vector3& target);
/// Complains about the components of a position that follow from tunable parameters. what: the position, in messages.
Vector3 constant_position(Reader& reader, const Value& value, const std::string& what, const Vector3Quantity& position);
/// Index of the hardpoint that the current scope calls so, -1 with a complaint.
int find_hardpoint(Reader& reader, const Value& value);
/// A hardpoint in the frame of a body.
Vector3Quantity position_on_body(Reader& reader, int hardpoint, int body);
/// The point that the current scope calls so: one of the body, or a hardpoint. Result: point -1 when there is none.
Attachment find_point(Reader& reader, int body, const std::string& name);
/// Positions `by` farther, m; numbers as the decimals that people type.
Vector3Quantity moved(Reader& reader, const Vector3Quantity& position, const Vector3& by);

// Axes by two points (axis_by_points.cpp).
/// Unit vector from one point to the other, in the axes of the current scope: who reads the object turns it into the
/// frame that the axis is meant in. Complains about points at one place.
void read_axis_by_points(Reader& reader, const Value& value, Vector3& target);
/// Turns an axis that stands as two points into the frame of a body in which other axes stand; others stay. written:
/// the axis, nullptr where there is none.
void turn_axis_by_points(const Reader& reader, const Value* written, int body, Vector3& axis);
/// The same for an axis in a frame that is turned by `rotation` from the axes of the current scope.
void turn_axis_by_points(const Value& written, const Matrix3& rotation, Vector3& axis);

}  // namespace mbgen::reading
