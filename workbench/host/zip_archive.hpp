#pragma once
// Reproducible zip archives: same bytes for the same content.

#include <string>

namespace mbgen {

/// The archive with neutral headers of its entries: times of access and creation become the time of modification,
/// owners become 0. `cmake -E tar --mtime` sets only the time of modification. archive: as written by cmake, without a
/// comment at its end. Fails: std::runtime_error for other files.
std::string without_circumstances(std::string archive);

}  // namespace mbgen
