#pragma once
// Mode shapes for animation in the page.

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "runtime/generic/generic.hpp"
#include "workbench/report/sources.hpp"

namespace mbgen {

/// Coordinates of a mode's oscillation about the point, with closed loops, at equidistant phases of a period.
struct Swing {
  std::vector<GenericState> frames;  ///< for half of the amplitude, then for all of it
  double motion = 0;                 ///< m: largest displacement of a drawn point
};

/// A mode at `count` phases (even). The amplitude moves the drawing by a tenth of the model's size or rotates a body by
/// half a radian; it is smaller if the loops do not close so far from the point, or correct the linear motion much.
/// Motion is 0 if nothing drawn moves.
Swing swing_of(const ModesSource& source, const GenericSolver& solver, const Mode& mode, std::size_t count);

/// Data of the page of modes, all but model, scene and topology:
///   point: state (a text), drift (largest rate of the states there)
///   rest: the poses at the point
///   animations, one a mode: name (what moves most), kind "mode", eigenvalue, frequency (Hz), damping_ratio,
///     oscillates, neutral, unstable, motion (m: of the place that moves most), count, and poses as those of a result
///     (motion.hpp): of `count` phases of a period where the mode oscillates, else of its two ends; first of half the
///     swing, then of all of it
nlohmann::ordered_json modes_json(const ModesSource& source);

/// Roads of the model about the point, with its inputs: see ground.hpp.
nlohmann::ordered_json ground_at_point(const ModesSource& source);

/// Position at the point of a body-fixed place given at the reference; body -1 stands for ground.
Vector3 carried(const ModesSource& source, int body, const Vector3& place);

}  // namespace mbgen
