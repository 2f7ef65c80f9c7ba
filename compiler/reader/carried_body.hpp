#pragma once
// Bodies that the reader adds: without mass, at a point of a body of the model.

#include <string>

#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// Adds a body without mass, with the frame of the body of `at` and that point alone. scope: whose names it has.
/// Result: its only point.
Attachment add_carried_body(Reader& reader, const std::string& name, const Where& where, const Attachment& at,
                            std::size_t scope);

}  // namespace mbgen::reading
