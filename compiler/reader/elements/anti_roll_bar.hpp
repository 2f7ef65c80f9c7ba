#pragma once
// Anti-roll bars as a composition: each stands for bodies, joints, rods and a joint spring of the model format.

#include "compiler/reader/elements/composed.hpp"
#include "compiler/reader/raw.hpp"

namespace mbgen::reading {

/// An anti-roll bar: see compose_bars. Positions in the axes of its file.
struct AntiRollBarFields {
  std::string body, left, right;  ///< names of bodies
  const Value *pivot = nullptr, *arm = nullptr, *link = nullptr;
  const Value *right_pivot = nullptr, *right_arm = nullptr, *right_link = nullptr;
  Mirror mirror = Mirror::xz;
  const Value *stiffness = nullptr, *damping = nullptr, *section = nullptr;
  std::optional<double> link_stiffness;
  double mass = 0, link_mass = 0;
};

/// The round cross-section of an anti-roll bar.
struct BarSectionFields {
  double diameter = 0, inner_diameter = 0, shear_modulus = 0;
  std::optional<double> length;
};

template <>
std::span<const Field<AntiRollBarFields>> fields<AntiRollBarFields>();
template <>
std::span<const Field<BarSectionFields>> fields<BarSectionFields>();

/// A bar NAME becomes the bodies NAME_left and NAME_right in revolute joints of these names, whose axis goes from the
/// right pivot to the left one; the joint spring NAME between both; the rods NAME_link_left and NAME_link_right. Its
/// points are hardpoints: NAME_pivot_left, NAME_arm_left, NAME_link_left, and on the right. Problems have the places of
/// the bar's own fields; a bar with a problem stands for nothing. Requires: hardpoints are read, instances are placed.
void compose_bars(Reader& reader, const Entries& bars, ComposedParts& made);

}  // namespace mbgen::reading
