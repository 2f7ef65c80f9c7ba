#pragma once
// Notes on sets of tyre coefficients that are allowed but unlikely.

#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// Adds a note unless it exists: several tyres may use one set or file.
void note_once(Reader& reader, Place place, const std::string& message, const std::string& hint = {});

/// Notes on the forces of a set at its nominal load, upright and rolling, without shifts: no longitudinal or lateral
/// force, a force in the wrong direction, negative friction, and coefficients of pure slip only for combined slip by
/// the set. place: of the set.
void note_tyre_set(Reader& reader, Place place, const Tyre& tyre);

}  // namespace mbgen::reading
