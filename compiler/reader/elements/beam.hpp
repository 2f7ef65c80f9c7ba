#pragma once
// Beams as a composition: bodies at nodes, six elastic freedoms between neighbours.

#include <optional>

#include "compiler/reader/elements/composed.hpp"
#include "compiler/reader/raw.hpp"

namespace mbgen::reading {

/// A beam as written: see compose_beams. Positions in the axes of its file.
struct BeamFields {
  const Value *points = nullptr, *section = nullptr, *material = nullptr, *supports = nullptr;
  std::string on;  ///< name of a body
  Vector3 up{0, 0, 1};
  double segments = 0, damping = 0;
};

enum class BeamShape { round, tube, box, i, general };
constexpr std::array<std::string_view, 5> kBeamShapes = {"round", "tube", "box", "i", "general"};

/// A cross-section as written.
struct BeamSectionFields {
  BeamShape shape = BeamShape::round;
  std::optional<double> diameter, wall, width, height, flange, web, area, iy, iz, j;
};

enum class BeamSupport { welded, pinned, hinge };
constexpr std::array<std::string_view, 3> kBeamSupports = {"welded", "pinned", "hinge"};

/// A support of a point of a beam.
struct BeamSupportFields {
  std::string body;
  BeamSupport type = BeamSupport::welded;
  const Value* axis = nullptr;
};

template <>
std::span<const Field<BeamFields>> fields<BeamFields>();
template <>
std::span<const Field<BeamSectionFields>> fields<BeamSectionFields>();
template <>
std::span<const Field<BeamMaterial>> fields<BeamMaterial>();
template <>
std::span<const Field<BeamSupportFields>> fields<BeamSupportFields>();
/// A beam NAME through the points P, Q, ... has the bodies NAME_P, NAME_P_1, NAME_P_2, ..., NAME_Q, ..., at the ends of
/// its segments, which are hardpoints of the same names. A bushing NAME_P_1 connects the nodes of a segment at its
/// middle, the hardpoint NAME_P_1_mid: EA/l, 12 EI/l^3, GJ/l, EI/l, with which the segment has the stiffness of an
/// Euler-Bernoulli beam for loads at its ends. A support joins a point's node to a body; each other node is on its
/// neighbour by a free joint, the first one of a beam without supports on the body `on`. So no loop is closed.
/// Each half of a segment of mass m gives its node m/2 with a first moment of m l/12 towards the segment (the
/// trapezoidal rule with its end correction for the kinetic energy: frequencies err by the third power of l), and the
/// rotary inertia of its sections.
/// Requires: hardpoints are read, instances are placed. A beam with a problem stands for nothing.
void compose_beams(Reader& reader, const Entries& beams, ComposedParts& made);

/// Properties of a section (beam_section.cpp). Reports fields that its shape lacks or does not have.
std::optional<BeamSection> read_beam_section(Reader& reader, const Value& value);

}  // namespace mbgen::reading
