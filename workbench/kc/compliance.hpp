#pragma once
// Compliance matrices of an axle's wheels at the start.

#include "workbench/kc/curves.hpp"

namespace mbgen::kc {

/// Displacements over forces and moments, in the fixed axes of the rig: a matrix for loads at the wheel centres and one
/// for loads at the contact centres, with the wheels free, that is with constant forces of their pads, and again with
/// the wheel centres held at their height. Rows of each wheel: displacement of the loaded point (m), rotation vector of
/// the wheel body, steer angle, camber and wind-up (rad). Columns: force (N) and moment (N m) at the left wheel, at the
/// right wheel, equal at both, and opposite: the left one as named, the right one reversed. Held wheels have no column
/// of the vertical force; free wheels that no spring carries have no matrix.
std::vector<KcMatrix> compliance_matrices(const Rig& rig, const PointOfCurve& start);

}  // namespace mbgen::kc
