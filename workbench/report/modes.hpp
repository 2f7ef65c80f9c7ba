#pragma once
// Modes as the page animates them.

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "runtime/generic/generic.hpp"
#include "workbench/report/sources.hpp"

namespace mbgen {

/// Coordinates of a mode's swing about the point, at phases evenly spaced over a period, the loops closed.
struct Swing {
  std::vector<GenericState> frames;  ///< of half the swing, then of all of it
  double motion = 0;                 ///< m: how far the place moves that moves most
};

/// A mode with `count` phases (even). So large that the drawing moves by a tenth of the model's size or a body turns
/// by half a radian; less where the loops do not close so far from the point, or correct the linear motion much. Motion
/// is 0 where nothing that is drawn moves.
Swing swing_of(const ModesSource& source, const GenericSolver& solver, const Mode& mode, std::size_t count);

/// Data of the page of modes, all but model, scene and topology:
///   point: state (a text), drift (largest rate of the states there)
///   rest: the poses at the point
///   animations, one a mode: name (what moves most), kind "mode", eigenvalue, frequency (Hz), damping_ratio,
///     oscillates, neutral, unstable, motion (m: of the place that moves most), count, and poses as those of a result
///     (motion.hpp): of `count` phases of a period where the mode oscillates, else of its two ends; first of half the
///     swing, then of all of it
nlohmann::ordered_json modes_json(const ModesSource& source);

/// The roads of the model about the point, with the inputs there: see ground.hpp.
nlohmann::ordered_json ground_at_point(const ModesSource& source);

/// Where a place that moves with a body at the reference is at the point; body -1 stands for ground.
Vector3 carried(const ModesSource& source, int body, const Vector3& place);

}  // namespace mbgen
