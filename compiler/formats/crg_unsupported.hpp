#pragma once
// Requests of an OpenCRG file beside its data: modifiers and options. Source: ASAM OpenCRG 1.2.0, chapters "modifiers"
// and "options".

#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// The road after its modifiers of position: by a reference point (REFPOINT_), else rotated and shifted (REFLINE_).
CrgRoad relocated(CrgRoad road);

/// Applies the options of the grid's road for borders and smoothing of the ends.
void follow_options(RoadGrid& grid);

/// Modifiers and options that are not applied to a road, closed on request, one text each: "NAME = value", possibly
/// with a reason.
std::vector<std::string> unsupported_options(const CrgRoad& road);

}  // namespace mbgen
