#pragma once
// Tables and maps that expressions name.

#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// Makes the tables known to expressions. Requires: parameters are read.
void read_tables(Reader& reader, const Entries& entries);
void read_maps(Reader& reader, const Entries& entries);

}  // namespace mbgen::reading
