#pragma once
// Sets of tyre coefficients that are allowed and likely not meant.

#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// A note that is not there yet: several tyres are of one set or file.
void note_once(Reader& reader, Place place, const std::string& message, const std::string& hint = {});

/// Notes on the forces of a set at its nominal load, upright and rolling, without shifts: none along or across, a slip
/// that pushes the wrong way, friction below zero, and coefficients of pure slip only where combined slip is by the
/// set. place: of the set.
void note_tyre_set(Reader& reader, Place place, const Tyre& tyre);

}  // namespace mbgen::reading
