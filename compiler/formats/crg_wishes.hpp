#pragma once
// Requests of an OpenCRG file beside its data: modifiers and options. Source: ASAM OpenCRG 1.2.0, chapters "modifiers"
// and "options".

#include <string>
#include <vector>

#include "compiler/model/roads.hpp"

namespace mbgen {

/// The road where its modifiers put it: by a reference point (REFPOINT_), else turned and shifted (REFLINE_).
CrgRoad relocated(CrgRoad road);

/// Takes over what the options of the grid's road say of its borders and of smoothing at its ends.
void follow_options(RoadGrid& grid);

/// Modifiers and options of a road, closed as asked, that are not followed, a text each: "NAME = value", perhaps why.
std::vector<std::string> not_followed(const CrgRoad& road);

}  // namespace mbgen
