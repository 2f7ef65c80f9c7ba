#pragma once
// Massless bodies added by the reader at a point of a body of the model.

#include <string>

#include "compiler/reader/reader.hpp"

namespace mbgen::reading {

/// Adds a massless body with the frame of `at`'s body and a single point. scope: of its name. Result: this point.
Attachment add_carried_body(Reader& reader, const std::string& name, const Where& where, const Attachment& at,
                            std::size_t scope);

}  // namespace mbgen::reading
