#pragma once
// The roads under the tyres of a model, as the page draws them.

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "compiler/model/model.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {

/// As JSON, along some frames:
///   strips: of each road that is known: its name; stations (x y of the way, cosine and sine of its direction), offsets
///     to the left of it, heights (global z, station by station, right to left) and, where it is not 1, friction; m
///   tracks: of each tyre the body, the wheel centre in its frame and the heights below it, frame by frame
///   floor: m, below all strips
///   notes: what cannot be drawn as it is, a sentence each
/// Strips and tracks are left out of a model none of whose tyres is on a named road. Numbers in base64.
/// knows_inputs: whether the solver's inputs are those of the frames; roads that depend on others are not drawn.
/// Requires: frames.
nlohmann::ordered_json ground_json(const Model& model, const GenericSolver& solver,
                                   const std::vector<GenericState>& frames, bool knows_inputs);

}  // namespace mbgen
